#include "app/devices/live_recording.h"

#include "app/play/paced_log.h"
#include "drivers/logs/log.h"
#include "tests/app/simple_rig.h"

#include <gtest/gtest.h>
#include <sstream>
#include <utility>

namespace tractus::devices {
namespace {

// Returns a report of the simple pen with the given flags: 21 for touching, 20 for hovering.
drivers::RawReport flagged_report(Timestamp time, char const* flags)
{
    drivers::RawReport report { .received = time };
    for (auto const byte : drivers::bytes(std::string("02 ") + flags + " 10 27 10 27 00 01 00 00"))
        report.storage[report.size++] = byte;
    return report;
}

// A stream buffer that counts how often it is flushed.
class CountingBuffer final : public std::stringbuf {
public:
    int flushes = 0;

protected:
    int sync() override
    {
        ++flushes;
        return std::stringbuf::sync();
    }
};

class LiveRecorderTest : public testing::Test {
protected:
    drivers::LogHeader header_ { .devices
                                 = { drivers::simple_pen(), drivers::simple_height_sensor() },
                                 .start = at_ms(1000) };
    CountingBuffer buffer_;
    LiveRecorder recorder_ { std::make_unique<std::ostream>(&buffer_), header_ };
};

TEST_F(LiveRecorderTest, FlushesFourTimesASecond)
{
    for (int i = 0; i < 1000; ++i)
        ASSERT_TRUE(recorder_.flush_if_due(at_ms(1000 + i)));
    EXPECT_EQ(buffer_.flushes, 3);
}

TEST_F(LiveRecorderTest, FlushesWhenAStrokeEnds)
{
    recorder_.write({ 0, flagged_report(at_ms(1001), "20") });
    recorder_.write({ 0, flagged_report(at_ms(1002), "21") });
    ASSERT_TRUE(recorder_.flush_if_due(at_ms(1002)));
    EXPECT_EQ(buffer_.flushes, 0);
    recorder_.write({ 0, flagged_report(at_ms(1003), "20") });
    ASSERT_TRUE(recorder_.flush_if_due(at_ms(1003)));
    EXPECT_EQ(buffer_.flushes, 1);
}

TEST_F(LiveRecorderTest, FlushesWhenThePenIsUnpluggedInAStroke)
{
    recorder_.write({ 0, flagged_report(at_ms(1002), "21") });
    recorder_.write({ 1, { .received = at_ms(1003) } });
    ASSERT_TRUE(recorder_.flush_if_due(at_ms(1003)));
    EXPECT_EQ(buffer_.flushes, 0);
    recorder_.write({ 0, { .received = at_ms(1003) } });
    ASSERT_TRUE(recorder_.flush_if_due(at_ms(1003)));
    EXPECT_EQ(buffer_.flushes, 1);
    EXPECT_EQ(recorder_.report_count(), 1u);
}

TEST(LiveRecorder, NeverWritesOverAFile)
{
    auto const recorder = LiveRecorder::create("/dev/null", {});
    ASSERT_FALSE(recorder);
    EXPECT_EQ(recorder.error().fault, Fault::User);
}

// A clock that advances only when the program waits.
struct TestClock {
    Timestamp time = at_ms(5000);

    play::Pace pace(Timestamp data_begin, double speed)
    {
        return { .data_begin = data_begin,
                 .real_begin = time,
                 .speed = speed,
                 .now = [this] { return time; },
                 .wait = [this](Duration duration) { time += duration; } };
    }
};

std::shared_ptr<drivers::Log const> two_reports()
{
    return std::make_shared<drivers::Log const>(
        drivers::parse_log("R: 1 c0\nN: pen\nE: 10.0 1 01\nE: 10.5 1 02\n", "pen.hid").value());
}

TEST(PacedLog, SendsEachReportWhenItsTimeHasCome)
{
    TestClock clock;
    auto const source = play::open_paced(two_reports(), 0, clock.pace(at_ms(10'000), 2));
    EXPECT_EQ(source->info().name, "pen");
    auto const first = source->read(std::chrono::milliseconds(50));
    ASSERT_TRUE(first && *first);
    EXPECT_EQ((*first)->received, at_ms(5000));
    for (int i = 0; i < 4; ++i)
        EXPECT_EQ(source->read(std::chrono::milliseconds(60)).value(), std::nullopt);
    EXPECT_EQ(clock.time, at_ms(5240));
    auto const second = source->read(std::chrono::milliseconds(60));
    ASSERT_TRUE(second && *second);
    EXPECT_EQ((*second)->received, at_ms(5250));
    EXPECT_EQ(clock.time, at_ms(5250));
}

TEST(PacedLog, SaysThatItIsOver)
{
    TestClock clock;
    auto const source = play::open_paced(two_reports(), 0, clock.pace(at_ms(10'000), 1000));
    ASSERT_TRUE(source->read(std::chrono::seconds(1)));
    ASSERT_TRUE(source->read(std::chrono::seconds(1)));
    auto const end = source->read(std::chrono::seconds(1));
    ASSERT_FALSE(end);
    EXPECT_EQ(end.error().message, "pen.hid:device 0 is over");
}

// Plays both devices of a log, a million times as fast as they were recorded.
LiveDevices played(std::string const& text)
{
    auto const log
        = std::make_shared<drivers::Log const>(drivers::parse_log(text, "both.log").value());
    auto const pace = play::pace_from_now(log->records.front().time, 1e6);
    std::vector<std::unique_ptr<drivers::ReportSource>> sources;
    for (std::size_t i = 0; i < log->devices.size(); ++i)
        sources.push_back(play::open_paced(log, i, pace));
    return LiveDevices::start(std::move(sources)).value();
}

TEST(LiveRecording, RecordsAllDevicesUntilTheyAreOver)
{
    auto devices = played("D: 0\nR: 1 c0\nN: pen\nD: 1\nR: 1 a0\nN: height\n"
                          "E: 1.0 1 01\nD: 0\nE: 2.0 1 02\nD: 1\nE: 3.0 1 03\n");
    auto const options = live_recording_by_the_clock({});
    CountingBuffer buffer;
    LiveRecorder recorder(std::make_unique<std::ostream>(&buffer),
                          { .devices = devices.infos(), .rig_text = "version = 1\n" });
    std::atomic<bool> const stop = false;
    auto const counts = record_live(devices, recorder, options, stop);
    ASSERT_TRUE(counts) << counts.error().message;
    EXPECT_EQ(counts->reports, 3u);
    EXPECT_EQ(counts->lost, 0u);
    auto const log = drivers::parse_log(buffer.str(), "recorded").value();
    ASSERT_EQ(log.records.size(), 3u);
    EXPECT_EQ(log.rig_text, "version = 1\n");
    EXPECT_EQ(log.devices[1].name, "height");
    EXPECT_GE(buffer.flushes, 1);
}

TEST(LiveRecording, KeepsWhatHasComeWhenItIsStopped)
{
    auto devices = played("R: 1 c0\nE: 1.0 1 01\nE: 9000000.0 1 02\n");
    CountingBuffer buffer;
    LiveRecorder recorder(std::make_unique<std::ostream>(&buffer), { .devices = devices.infos() });
    std::atomic<bool> stop = false;
    auto options = live_recording_by_the_clock({});
    options.rest = [&](Duration) { stop = recorder.report_count() > 0; };
    ASSERT_TRUE(record_live(devices, recorder, options, stop));
    EXPECT_EQ(drivers::parse_log(buffer.str(), "recorded")->records.size(), 1u);
}

TEST(LiveRecording, EndsWhenTheTimeIsOver)
{
    auto devices = played("R: 1 c0\nE: 1.0 1 01\nE: 9000000.0 1 02\n");
    CountingBuffer buffer;
    LiveRecorder recorder(std::make_unique<std::ostream>(&buffer), { .devices = devices.infos() });
    Timestamp now {};
    std::atomic<bool> const stop = false;
    EXPECT_TRUE(record_live(devices, recorder,
                            { .seconds = 20,
                              .now = [&] { return now; },
                              .rest = [&](Duration) { now += std::chrono::seconds(1); } },
                            stop));
    EXPECT_EQ(now, at_ms(20'000));
}

TEST(LiveDevices, GoOnWithoutThoseThatCannotBeOpened)
{
    auto missing = drivers::simple_pen();
    missing.location = "/dev/hidraw999";
    std::vector<RefusedDevice> refused;
    auto const devices = LiveDevices::open_usable({ missing }, refused);
    EXPECT_TRUE(devices.infos().empty());
    ASSERT_EQ(refused.size(), 1u);
    EXPECT_EQ(refused[0].info.location, "/dev/hidraw999");
    EXPECT_NE(refused[0].error.message.find("/dev/hidraw999"), std::string::npos);
}

TEST(LiveDevices, NamesTheDeviceThatIsNotThere)
{
    auto const devices = LiveDevices::open_named(std::vector<std::string> { "/dev/hidraw999" });
    ASSERT_FALSE(devices);
    EXPECT_EQ(devices.error().fault, Fault::User);
    EXPECT_NE(devices.error().message.find("/dev/hidraw999"), std::string::npos);
}

} // namespace
} // namespace tractus::devices
