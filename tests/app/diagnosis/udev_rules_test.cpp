#include "app/diagnosis/udev_rules.h"

#include "tests/drivers/bytes.h"

#include <gtest/gtest.h>
#include <string_view>

namespace tractus::diagnosis {
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
    EXPECT_EQ(
        udev_rule_for({ .location = "/dev/hidraw0", .vendor_id = 0x056a, .product_id = 0x37a }),
        "KERNEL==\"hidraw*\", ATTRS{idVendor}==\"056a\", ATTRS{idProduct}==\"037a\", "
        "TAG+=\"uaccess\"");
    EXPECT_EQ(
        udev_rule_for(
            { .location = "/dev/hidraw0", .bus = 0x18, .vendor_id = 0x04f3, .product_id = 0x2a1c }),
        "KERNEL==\"hidraw*\", KERNELS==\"0018:04F3:2A1C.*\", TAG+=\"uaccess\"");
    EXPECT_EQ(udev_rule_for({ .location = "usb:1-2", .vendor_id = 0x1209, .product_id = 1 }),
              "SUBSYSTEM==\"usb\", ATTR{idVendor}==\"1209\", ATTR{idProduct}==\"0001\", "
              "TAG+=\"uaccess\"");
    EXPECT_EQ(udev_rule_for({ .location = "gpio:gpiochip0:1,2,3,4:mcp3208:0" }),
              "SUBSYSTEM==\"gpio\", KERNEL==\"gpiochip*\", TAG+=\"uaccess\"");
}

TEST(UdevRules, PermitPensByUsageAndTabletsByMaker)
{
    auto const permits = [](std::uint16_t bus, std::uint16_t vendor_id, std::uint16_t product_id,
                            std::string_view descriptor) {
        return do_rules_permit({ .location = "/dev/hidraw0",
                                 .bus = bus,
                                 .vendor_id = vendor_id,
                                 .product_id = product_id,
                                 .report_descriptor = drivers::bytes(descriptor) });
    };
    constexpr auto kPen = "05 0d 09 02 a1 01 09 20 a1 00 c0 c0", kMouse = "05 01 09 02 a1 01 c0";
    EXPECT_TRUE(permits(0x18, 0x2d1f, 0x0001, kPen)); // A pen whose manufacturer is in no rule.
    EXPECT_TRUE(permits(0x03, 0x2179, 0x0053, kPen));
    // A device that reports a pen on a vendor-defined usage page of Wacom.
    EXPECT_TRUE(permits(0x18, 0x2d1f, 0x0001, "06 0d ff 09 01 a1 01 c0"));
    EXPECT_FALSE(permits(0x03, 0x045e, 0x0001, kMouse));
    EXPECT_FALSE(permits(0x03, 0x2179, 0x0053, "05 0d 09 04 a1 01 c0")); // A touch screen.
    EXPECT_TRUE(permits(0x03, 0x256c, 0x006d, "06 00 ff 09 01 a1 01 c0"));
    EXPECT_TRUE(permits(0x05, 0x256c, 0x006d, "06 00 ff 09 01 a1 01 c0"));
    // A tablet with the USB ID of a chip manufacturer.
    EXPECT_TRUE(permits(0x03, 0x0483, 0xa640, kMouse));
    EXPECT_FALSE(permits(0x03, 0x0483, 0x5740, kMouse));
    constexpr auto kKeyboard = "05 01 09 06 a1 01 c0";
    EXPECT_TRUE(permits(0x03, 0x0458, 0x501a, "06 00 ff 09 01 a1 01 c0"));
    // A keyboard by a manufacturer of tablets.
    EXPECT_FALSE(permits(0x03, 0x0458, 0x0708, kKeyboard));
}

} // namespace
} // namespace tractus::diagnosis
