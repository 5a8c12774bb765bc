#include "app/station/station.h"
#include "engine/base/random.h"
#include "tests/app/station/pressed_pens.h"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>
#include <gtest/gtest.h>

// Tests of impossible height readings during strokes.

namespace tractus::station {
namespace {

using namespace std::chrono_literals;

struct Faults {
    double readings_hz = 500;
    int in_a_row = 0;        // Length of each run of wrong readings; one run begins every 0.3 s.
    double single_share = 0; // Share of isolated wrong readings among the readings outside runs.
    // True: wrong readings are 4095, the end of the range; false: they are random.
    bool on_rail = false;
    std::uint64_t seed = 1;
};

double height_mm(double seconds)
{
    return 200 + 60 * std::sin(2 * 3.14159265 * seconds / 1.6);
}

// Draws with a pen that moves for two seconds while the surface rises and sinks.
tools::ToolStroke draw(Faults const& faults, double& worst_live_mm)
{
    StationOptions options;
    options.rig.tablet_size_mm = { 200, 100 };
    std::vector const devices { drivers::simple_pen(), drivers::simple_height_sensor() };
    auto station = Station::create(devices, options).value();
    Random random({ .seed = faults.seed });
    auto const at = [](double seconds) { return timestamp_ns(std::llround(seconds * 1e9)); };
    // Returns a wrong reading: at least 10 mm away from the true one, or at the end of the range.
    auto const wrong = [&](double counts) {
        double const off = random.uniform(100, 1900);
        return faults.on_rail ? 4095
                              : static_cast<int>(counts > 2000 ? counts - off : counts + off);
    };
    double next_pen_s = 0.25;
    double next_faults_s = 0.5;
    int wrong_ones = 0;
    for (double seconds = 0; seconds < 3; seconds += 1 / faults.readings_hz) {
        for (; next_pen_s <= seconds; next_pen_s += 0.005) {
            bool const touching = next_pen_s > 0.3 && next_pen_s < 2.3;
            station.push(kPen, at(next_pen_s),
                         standard_pen().report(
                             { .x_mm = 20 + 60 * next_pen_s, .y_mm = 50, .touching = touching }));
        }
        if (seconds >= next_faults_s) {
            wrong_ones = faults.in_a_row;
            next_faults_s += std::max(0.3, 30 / faults.readings_hz);
        }
        bool const is_wrong
            = wrong_ones > 0 || (seconds > 0.2 && random.uniform() < faults.single_share);
        wrong_ones -= wrong_ones > 0;
        double const counts = height_mm(seconds) / 0.1;
        station.push(
            kHeight, at(seconds),
            height_report(is_wrong ? wrong(counts) : static_cast<int>(std::lround(counts))));
        for (auto const& moment : station.take_moments())
            worst_live_mm = std::max(worst_live_mm,
                                     std::abs(moment.position_mm.z()
                                              - height_mm(to_seconds(moment.time - Timestamp()))));
    }
    station.finish();
    auto strokes = station.take_strokes();
    EXPECT_EQ(strokes.size(), 1u);
    return strokes.empty() ? tools::ToolStroke {} : strokes[0];
}

double worst_mm(tools::ToolStroke const& stroke)
{
    double worst_mm = 0;
    for (auto const& tip : stroke.stroke.tips)
        worst_mm = std::max(
            worst_mm,
            std::abs(tip.position_mm.z() - height_mm(to_seconds(tip.time - Timestamp()))));
    return worst_mm;
}

TEST(WrongReadings, StayOutOfTheInkUpToTenInARowAtAnyRate)
{
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        Random random({ .seed = seed, .stream = 1 });
        Faults const faults { .readings_hz = random.uniform(100, 2000),
                              .in_a_row = 1 + static_cast<int>(random.uniform() * 10),
                              .on_rail = random.uniform() < 0.3,
                              .seed = seed };
        SCOPED_TRACE(fmt::format("{:.0f} Hz, {} in a row, on rail {}", faults.readings_hz,
                                 faults.in_a_row, faults.on_rail));
        double live_mm = 0;
        auto const stroke = draw(faults, live_mm);
        // The readings after wrong ones are doubted for a while, too. Over a gap of a tenth of a
        // second, the interpolated height may be slightly wrong.
        double const gap_s = (faults.in_a_row + 4) / faults.readings_hz;
        EXPECT_LE(worst_mm(stroke), 0.5 + 14 * gap_s * gap_s);
        EXPECT_LE(live_mm, 1.5 + 250 * gap_s);
        EXPECT_GE(stroke.stroke.tips.size(), 390u);
    }
}

TEST(WrongReadings, StayOutOfTheInkWhereOneInTwentyIsWrong)
{
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        Random random({ .seed = seed, .stream = 2 });
        Faults const faults { .readings_hz = random.uniform(150, 2000),
                              .single_share = 0.05,
                              .on_rail = seed % 2 == 0,
                              .seed = seed };
        SCOPED_TRACE(fmt::format("{:.0f} Hz", faults.readings_hz));
        double live_mm = 0;
        EXPECT_LE(worst_mm(draw(faults, live_mm)), 0.5);
    }
}

TEST(WrongReadings, AreNoneWhereTheSurfaceIsSomewhereElseAfterAPause)
{
    StationOptions options;
    options.rig.tablet_size_mm = { 200, 100 };
    std::vector const devices { drivers::simple_pen(), drivers::simple_height_sensor() };
    auto station = Station::create(devices, options).value();
    // The computer stood still for half a second. The delayed readings and the new ones then arrive
    // at once.
    for (int ms = 0; ms < 2000; ms += 2) {
        bool const is_after = ms >= 1000;
        int const arrives_ms = ms + (is_after ? 500 : 0);
        station.push(kHeight, at_ms(arrives_ms), height_report(is_after ? 2500 : 1000));
        station.push(
            kPen, at_ms(arrives_ms),
            standard_pen().report({ .x_mm = 20 + 0.05 * ms, .y_mm = 50, .touching = is_after }));
    }
    station.finish();
    auto const strokes = station.take_strokes();
    ASSERT_EQ(strokes.size(), 1u);
    for (auto const& tip : strokes[0].stroke.tips)
        EXPECT_NEAR(tip.position_mm.z(), 250, 0.1);
}

TEST(WrongReadings, AreNamedAsJumps)
{
    // `tractus doctor` uses HeightMonitor, so its judgement must agree with that used for ink.
    calib::HeightMonitor monitor { calib::Rig {} };
    for (int i = 0; i < 1000; ++i) {
        bool const is_wrong = i > 500 && i <= 505;
        monitor.push(
            { .time = at_ms(2 * i), .counts = is_wrong ? 1900 : 1000, .full_scale = 4095 });
        EXPECT_EQ(monitor.doubts_last(), is_wrong);
    }
    EXPECT_EQ(monitor.total(calib::HeightFaultKind::Jump).count, 1u);
}

} // namespace
} // namespace tractus::station
