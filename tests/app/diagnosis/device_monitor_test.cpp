#include "app/diagnosis/device_monitor.h"

#include "tests/app/diagnosis/reports.h"
#include "tests/drivers/devices.h"

#include <gtest/gtest.h>

namespace tractus::diagnosis {
namespace {

std::string field(DeviceReading const& reading, std::string const& name)
{
    for (auto const& [key, value] : reading.fields)
        if (key == name)
            return value;
    return {};
}

TEST(DeviceMonitor, ShowsWhatThePenSays)
{
    DeviceMonitor monitor(drivers::simple_pen());
    monitor.push(report_at_ms(0, kTouching));
    auto const reading = monitor.reading();
    EXPECT_EQ(reading.description.kind, drivers::DeviceKind::Pen);
    EXPECT_EQ(field(reading, "x"), "100.00 mm");
    EXPECT_EQ(field(reading, "y"), "50.00 mm");
    EXPECT_EQ(field(reading, "touching"), "yes");
    EXPECT_EQ(field(reading, "pressure"), "0.500");
    EXPECT_EQ(reading.samples, 1u);
    ASSERT_TRUE(reading.last);
    EXPECT_EQ(reading.last->size, 10u);
}

TEST(DeviceMonitor, MeasuresRateAndJitterOfTheLastSecond)
{
    DeviceMonitor monitor(drivers::simple_pen());
    for (int i = 0; i < 400; ++i)
        monitor.push(report_at_ms(5 * i + i % 2, kTouching));
    auto const pace = monitor.reading().pace;
    EXPECT_NEAR(pace.rate_hz, 200, 1);
    EXPECT_NEAR(to_seconds(pace.jitter), 0.001, 1e-5);
    EXPECT_EQ(pace.longest_interval, std::chrono::milliseconds(6));
}

TEST(DeviceMonitor, TakesAPauseForNoRhythm)
{
    DeviceMonitor monitor(drivers::simple_pen());
    for (int const time : { 0, 5, 10, 15, 800, 805, 810 })
        monitor.push(report_at_ms(time, kTouching));
    EXPECT_NEAR(monitor.reading().pace.rate_hz, 200, 0.1);
    monitor.pass_time(timestamp_ns(5'000'000'000));
    EXPECT_EQ(monitor.reading().pace.rate_hz, 0);
}

TEST(DeviceMonitor, NoticesWhatIsWrong)
{
    DeviceMonitor monitor(drivers::simple_pen());
    monitor.push(report_at_ms(10, kTouching));
    monitor.push(report_at_ms(5, kTouching));
    monitor.push(report_at_ms(15, "02 21"));
    monitor.push(report_at_ms(20, ""));
    auto const reading = monitor.reading();
    EXPECT_EQ(reading.reports, 3u);
    EXPECT_EQ(reading.backward_times, 1u);
    EXPECT_EQ(reading.broken_reports, 1u);
    EXPECT_FALSE(reading.first_broken.empty());
    EXPECT_TRUE(reading.is_away);
    EXPECT_EQ(field(reading, "in range"), "no");
    monitor.push(report_at_ms(30, kTouching));
    EXPECT_FALSE(monitor.reading().is_away);
    EXPECT_EQ(monitor.reading().departures, 1u);
}

TEST(DeviceMonitor, WatchesTheHeightSensor)
{
    DeviceMonitor monitor(drivers::simple_height_sensor());
    for (int i = 0; i < 200; ++i)
        monitor.push(report_at_ms(2 * i, "01 ff 0f"));
    auto const reading = monitor.reading();
    EXPECT_EQ(field(reading, "height"), "4095 of 4095 counts");
    // The fault is that the value stays at the end of the sensor's range.
    EXPECT_EQ(reading.height_faults.size(), 1u);
}

} // namespace
} // namespace tractus::diagnosis
