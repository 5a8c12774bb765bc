#include "app/devices/watch_view.h"

#include "tests/app/diagnosis/reports.h"
#include "tests/drivers/devices.h"

#include <gtest/gtest.h>

namespace tractus::diagnosis {
namespace {

TEST(WatchView, ShowsBytesBesideTheirMeaning)
{
    DeviceMonitor monitor(drivers::simple_pen());
    for (int i = 0; i < 10; ++i)
        monitor.push(report_at_ms(5 * i, kTouching));
    auto const reading = monitor.reading();
    auto const lines = devices::watch_lines(std::span(&reading, 1), 200);
    ASSERT_GE(lines.size(), 5u);
    EXPECT_EQ(lines[0], "Simple Pen (1209:0002) at ");
    EXPECT_EQ(lines[2],
              "  200.0/s  every 5.00 ms  jitter 0.00 ms  longest 5.00 ms  10 reports  0 "
              "broken");
    EXPECT_NE(lines[3].find("02 21 10 27 88 13 00 04 00 00"), std::string::npos) << lines[3];
    EXPECT_NE(lines[3].find("x         100.00 mm"), std::string::npos) << lines[3];
    EXPECT_NE(lines[4].find("y         50.00 mm"), std::string::npos) << lines[4];
}

TEST(WatchView, SaysThatADeviceIsAway)
{
    DeviceMonitor monitor(drivers::simple_pen());
    monitor.push(report_at_ms(0, kTouching));
    monitor.push(report_at_ms(5, ""));
    auto const reading = monitor.reading();
    EXPECT_EQ(devices::watch_lines(std::span(&reading, 1), 200)[2],
              "  gone; waiting for it to come back; 1 reports");
}

TEST(WatchView, FitsTheScreen)
{
    DeviceMonitor monitor(drivers::simple_pen());
    monitor.push(report_at_ms(0, kTouching));
    auto const reading = monitor.reading();
    for (auto const& line : devices::watch_lines(std::span(&reading, 1), 30))
        EXPECT_LE(line.size(), 30u);
}

} // namespace
} // namespace tractus::diagnosis
