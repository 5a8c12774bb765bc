#include "drivers/tablets/tablet_interfaces.h"

#include "tests/drivers/bytes.h"
#include "tests/drivers/devices.h"

#include <gtest/gtest.h>

namespace tractus::drivers {
namespace {

DeviceInfo node(std::string location, std::string path)
{
    return { .location = std::move(location),
             .physical_path = std::move(path),
             .vendor_id = 0x28bd,
             .product_id = 0x0094 };
}

TEST(TabletInterfaces, AreGroupedByTheirTablet)
{
    auto const groups = group_by_tablet({
        node("/dev/hidraw0", "usb-0000:00:14.0-1/input0"),
        node("/dev/hidraw1", "usb-0000:00:14.0-2/input0"),
        node("/dev/hidraw2", "usb-0000:00:14.0-1/input1"),
        node("/dev/hidraw3", "usb-0000:00:14.0-2/input1"),
    });
    ASSERT_EQ(groups.size(), 2u);
    ASSERT_EQ(groups[0].size(), 2u);
    EXPECT_EQ(groups[0][0].location, "/dev/hidraw0");
    EXPECT_EQ(groups[0][1].location, "/dev/hidraw2");
    EXPECT_EQ(groups[1][1].location, "/dev/hidraw3");
}

TEST(TabletInterfaces, WithoutAPathAreTabletsOfTheirOwn)
{
    EXPECT_EQ(group_by_tablet({ node("/dev/hidraw0", ""), node("/dev/hidraw1", "") }).size(), 2u);
}

TEST(TabletInterfaces, CarryAPenByWhatTheySendNotByTheirNumber)
{
    EXPECT_TRUE(carries_pen(simple_pen()));
    EXPECT_FALSE(carries_pen(simple_height_sensor()));

    DeviceInfo xp_pen { .vendor_id = 0x28bd, .product_id = 0x0094 };
    xp_pen.report_descriptor
        = bytes("06 00 ff 09 01 a1 01 85 02 09 01 15 00 26 ff 00 75 08 95 07 81 02 c0");
    EXPECT_TRUE(carries_pen(xp_pen)); // An interface with reports in the maker's own format.
    xp_pen.report_descriptor
        = bytes("05 01 09 06 a1 01 85 03 05 07 19 e0 29 e7 15 00 25 01 75 01 95 08 81 02 c0");
    EXPECT_FALSE(carries_pen(xp_pen)); // The interface of the tablet's keys.
}

TEST(TabletInterfaces, OfATouchPadCarryNoPen)
{
    DeviceInfo touch { .vendor_id = 0x056a, .product_id = 0x0302 };
    touch.report_descriptor
        = bytes("06 00 ff 09 01 a1 01 85 02 09 01 15 00 26 ff 00 75 08 95 3f 81 02 c0");
    EXPECT_FALSE(carries_pen(touch));
}

} // namespace
} // namespace tractus::drivers
