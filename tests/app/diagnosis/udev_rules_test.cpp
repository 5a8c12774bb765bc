#include "app/diagnosis/udev_rules.h"

#include <gtest/gtest.h>

namespace tractus {
namespace {

TEST(UdevRules, AreThoseOfTheSeatOrOfAGroup)
{
    auto const seat = udev_rules(RuleHolder::Seat);
    EXPECT_NE(seat.find("ATTRS{idVendor}==\"056a\", TAG+=\"uaccess\""), std::string::npos);
    auto const group = udev_rules(RuleHolder::Group);
    EXPECT_NE(group.find("ATTRS{idVendor}==\"056a\", GROUP=\"plugdev\", MODE=\"0660\""),
              std::string::npos);
    EXPECT_EQ(group.find("TAG+=\"uaccess\"\n"), std::string::npos);
}

TEST(UdevRules, PermitOneDevice)
{
    EXPECT_EQ(udev_rule_for({ .location = "/dev/hidraw0", .vendor_id = 0x056a }),
              "KERNEL==\"hidraw*\", ATTRS{idVendor}==\"056a\", TAG+=\"uaccess\"");
    EXPECT_EQ(udev_rule_for({ .location = "/dev/hidraw0", .bus = 0x18, .vendor_id = 0x04f3 }),
              "KERNEL==\"hidraw*\", KERNELS==\"0018:04F3:*\", TAG+=\"uaccess\"");
    EXPECT_EQ(udev_rule_for({ .location = "usb:1-2", .vendor_id = 0x1209, .product_id = 1 }),
              "SUBSYSTEM==\"usb\", ATTR{idVendor}==\"1209\", ATTR{idProduct}==\"0001\", "
              "TAG+=\"uaccess\"");
    EXPECT_EQ(udev_rule_for({ .location = "gpio:gpiochip0:1,2,3,4:mcp3208:0" }),
              "SUBSYSTEM==\"gpio\", KERNEL==\"gpiochip*\", TAG+=\"uaccess\"");
}

} // namespace
} // namespace tractus
