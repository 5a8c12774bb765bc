// Tests of drawing without hardware: a simulated board sends heights through a pseudo-terminal, and
// the station's own driver for serial ports reads them.

#include "app/station/log_replay.h"
#include "app/station/station.h"
#include "calib/rig_file.h"
#include "drivers/device_kind.h"
#include "drivers/logs/log.h"
#include "drivers/logs/log_writer.h"
#include "drivers/reconnecting_source.h"
#include "drivers/sensors/serial_line.h"
#include "sim/pty_serial_port.h"
#include "sim/serial_board.h"
#include "sim/simulated_rig.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fmt/core.h>
#include <gtest/gtest.h>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <unistd.h>
#include <vector>

namespace tractus::station {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;

constexpr std::size_t kTablet = 0;
constexpr std::size_t kSensor = 1;

// Returns a recording of the simulated rig in which a vertical line and a rising curve are drawn.
drivers::Log recording()
{
    sim::LineShape const upright { .from_mm = { -40, 10, 60 }, .to_mm = { -40, 10, 260 } };
    sim::HelixShape const curve {
        .foot_mm = { 20, 0, 80 }, .radius_mm = 30, .end_radius_mm = 20, .turns = 1.5, .rise_mm = 150
    };
    sim::Hand const hand({ { .path = sim::make_path(upright) }, { .path = sim::make_path(curve) } },
                         {});
    auto const run = sim::simulate_rig(hand, {});
    std::ostringstream out;
    drivers::LogWriter writer(
        out,
        { .devices = { run.tablet.info, run.height.info }, .rig_text = calib::print_rig(run.rig) });
    for (auto const& [device, report] : run.in_order_of_arrival())
        writer.write_report(device, report->received, report->bytes());
    return drivers::parse_log(out.str(), "recording").value();
}

using Strokes = std::vector<tools::ToolStroke>;

Strokes replay(drivers::Log const& log)
{
    StationOptions options;
    options.rig = calib::parse_rig(log.rig_text, "log").value();
    auto station = Station::create(log.devices, options).value();
    for (auto const& record : log.records)
        station.push(record.device, record.time, log.report(record));
    station.finish();
    return station.take_strokes();
}

// Fixture with the tablet of a recording, and a simulated board on a serial line that sends the
// recording's heights.
class SerialTwin : public testing::Test {
protected:
    void SetUp() override
    {
        port_ = sim::PtySerialPort::create(link_).value();
        plug_in_board();
        source_ = drivers::ReconnectingSource::open(sensor_info(), reconnection()).value();
    }
    void TearDown() override { fs::remove(link_); }

    void plug_in_board()
    {
        board_.emplace(*port_, sim::HeightCurve::read(log_).value(),
                       sim::SerialBoard::Options { .rate_hz = 500 });
        board_->begin(log_.begin());
    }

    // Addresses of serial lines begin with /dev. This one leads from there to the link.
    drivers::DeviceInfo sensor_info() const
    {
        return { .name = "board",
                 .location = "/dev/pts/../.." + link_.string(),
                 .settings = fmt::format("max={}", board_->full_scale()) };
    }

    drivers::Reconnection reconnection() const
    {
        drivers::Reconnection reconnection { .list
                                             = [] { return std::vector<drivers::DeviceInfo>(); },
                                             .open = drivers::open_serial_line,
                                             .now = [] { return Timestamp {}; },
                                             .slept = [] { return Duration(0); } };
        reconnection.retry_every = Duration(0);
        return reconnection;
    }

    // Lets the board print its lines up to `end`, and passes each report that the driver reads to
    // `push`.
    template<typename Push> void print_until(Timestamp end, Push const& push)
    {
        if (board_->due() < log_.begin())
            ASSERT_TRUE(board_->play(log_.begin()));
        while (board_->due() <= end) {
            auto const time = board_->due();
            ASSERT_TRUE(board_->play(time));
            while (auto const report = source_->read(0ms).value())
                push(time, report->bytes());
        }
    }

    // Plays the recording through the serial line, and returns a log of the reports.
    drivers::Log record()
    {
        std::ostringstream out;
        drivers::LogWriter writer(
            out,
            { .devices = { log_.devices[kTablet], source_->info() }, .rig_text = log_.rig_text });
        for (auto const& record : log_.records) {
            if (record.device != kTablet)
                continue;
            print_until(record.time, [&](Timestamp time, std::span<std::byte const> report) {
                writer.write_report(kSensor, time, report);
            });
            writer.write_report(kTablet, record.time, log_.report(record));
        }
        return drivers::parse_log(out.str(), "through the line").value();
    }

    fs::path link_ = fs::temp_directory_path() / fmt::format("tractus_twin_{}", ::getpid());
    drivers::Log log_ = recording();
    std::unique_ptr<sim::PtySerialPort> port_;
    std::optional<sim::SerialBoard> board_;
    std::unique_ptr<drivers::ReconnectingSource> source_;
};

double distance_mm(Vec3 const& place_mm, std::vector<TipSample> const& tips)
{
    double nearest_mm = 1e9;
    for (std::size_t i = 1; i < tips.size(); ++i) {
        Vec3 const way = tips[i].position_mm - tips[i - 1].position_mm;
        Vec3 const off = place_mm - tips[i - 1].position_mm;
        double const length = way.squaredNorm();
        double const part = length > 0 ? std::clamp(off.dot(way) / length, 0.0, 1.0) : 0;
        nearest_mm = std::min(nearest_mm, (off - part * way).norm());
    }
    return nearest_mm;
}

TEST_F(SerialTwin, DrawsWhatTheRecordedSensorDrew)
{
    auto const through_line = record();
    EXPECT_EQ(drivers::describe_device(through_line.devices[kSensor]).kind,
              drivers::DeviceKind::Height);
    auto const expected = replay(log_);
    auto const drawn = replay(through_line);
    ASSERT_EQ(expected.size(), 2u);
    ASSERT_EQ(drawn.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_GT(drawn[i].stroke.tips.size(), 100u);
        for (auto const& tip : drawn[i].stroke.tips)
            ASSERT_LT(distance_mm(tip.position_mm, expected[i].stroke.tips), 0.3);
    }
}

TEST_F(SerialTwin, GoesOnWhenItIsPluggedInAgain)
{
    std::size_t before = 0;
    std::size_t after = 0;
    print_until(log_.begin() + 1s, [&](auto...) { ++before; });
    EXPECT_GT(before, 400u);
    port_.reset();
    EXPECT_EQ(source_->read(1s).value().value().size, 0u) << "it went away";
    EXPECT_FALSE(fs::exists(fs::symlink_status(link_))) << "its link went with it";
    port_ = sim::PtySerialPort::create(link_).value();
    plug_in_board();
    for (int i = 0; i < 10 && !source_->is_connected(); ++i)
        EXPECT_FALSE(source_->read(0ms).value());
    ASSERT_TRUE(source_->is_connected());
    print_until(log_.begin() + 1s, [&](auto...) { ++after; });
    EXPECT_EQ(after, before);
}

TEST_F(SerialTwin, KnowsItsReaders)
{
    ASSERT_TRUE(port_->serve());
    EXPECT_TRUE(port_->is_read());
    source_.reset();
    ASSERT_TRUE(port_->serve());
    EXPECT_FALSE(port_->is_read());
    EXPECT_EQ(port_->lost_count(), 0u);
    ASSERT_TRUE(board_->play(log_.begin()));
    EXPECT_EQ(port_->lost_count(), 1u) << "nobody has read that line";
}

// If the station does not read for a long time, lines are lost, as with a real board. Later lines
// must be whole again.
TEST_F(SerialTwin, LosesLinesWhereNobodyReadsThem)
{
    for (int i = 0; i < 100'000 && port_->lost_count() == 0; ++i)
        ASSERT_TRUE(board_->play(log_.begin() + i * 2ms));
    EXPECT_GT(port_->lost_count(), 0u);
    std::size_t count = 0;
    while (source_->read(0ms).value())
        ++count;
    EXPECT_GT(count, 100u);
}

TEST_F(SerialTwin, ReplacesNoFileByItsLink)
{
    auto const file = fs::temp_directory_path() / fmt::format("tractus_file_{}", ::getpid());
    fs::create_symlink("/dev/null", file);
    auto const port = sim::PtySerialPort::create(file);
    fs::remove(file);
    ASSERT_FALSE(port);
    EXPECT_NE(port.error().message.find("choose another name"), std::string::npos)
        << port.error().message;
}

} // namespace
} // namespace tractus::station
