#include "app/station/station.h"
#include "engine/base/random.h"
#include "tests/app/station/pressed_pens.h"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>
#include <gtest/gtest.h>

// Tests of a pen that is held still while the surface rises or sinks: the basic stroke of this
// station. The tablets report only changes.

namespace tractus::station {
namespace {

using namespace std::chrono_literals;

constexpr double kLow_mm = 100;
constexpr double kHigh_mm = 300;
constexpr double kDown_s = 0.3;  // Time at which the pen touches the tablet.
constexpr double kStart_s = 0.6; // Time at which the surface starts to move.

calib::Rig rig()
{
    calib::Rig rig;
    rig.height_model = calib::LinearHeight { .mm_per_count = 0.1 };
    rig.height_latency = 3ms;
    rig.tablet_size_mm = { 200, 100 };
    rig.tablet_latency = 8ms;
    return rig;
}

struct Rise {
    double mm_per_s = 100;
    double readings_hz = 500;
    double noise_counts = 0; // Standard deviation of the height sensor's readings.
    std::uint64_t seed = 1;
    // Rate at which the pen's pressure changes by one count; 0: never.
    double pressure_changes_hz = 0;
};

// Returns the height of the surface. The surface starts and stops abruptly, which is harder to
// follow than the movement of a hand.
double height_mm(Rise const& rise, double seconds)
{
    return std::clamp(kLow_mm + rise.mm_per_s * (seconds - kStart_s), kLow_mm, kHigh_mm);
}

double stop_s(Rise const& rise)
{
    return kStart_s + (kHigh_mm - kLow_mm) / rise.mm_per_s;
}

Timestamp at_s(double seconds)
{
    return timestamp_ns(std::llround(seconds * 1e9));
}

// A report of the pen or the height sensor, with the time of its arrival.
struct Arrival {
    double seconds = 0;
    std::size_t device = 0;
    std::vector<std::byte> report;
};

void add_pen(std::vector<Arrival>& arrivals, PenFormat const& format, Rise const& rise)
{
    auto const send = [&](double seconds, PenState const& pen) {
        arrivals.push_back({ seconds + 0.008, kPen, format.report(pen) });
    };
    // Number of samples before the touch, in which the pen hovers; they are 5 ms apart.
    constexpr int kApproach = 20;
    for (int i = 0; i < kApproach; ++i)
        send(kDown_s - 0.005 * (kApproach - i), { .x_mm = 60 + 0.5 * i, .y_mm = 40 });
    double const up_s = stop_s(rise) + 0.2;
    int pressure = 1000;
    for (double seconds = kDown_s; seconds < up_s; seconds += 1 / rise.pressure_changes_hz) {
        send(seconds, { .x_mm = 70, .y_mm = 40, .touching = true, .pressure = pressure++ });
        if (rise.pressure_changes_hz == 0)
            break;
    }
    send(up_s, { .x_mm = 70, .y_mm = 40 });
}

void add_heights(std::vector<Arrival>& arrivals, Rise const& rise)
{
    Random random({ .seed = rise.seed });
    double const period_s = 1 / rise.readings_hz;
    for (double seconds = random.uniform() * period_s; seconds < stop_s(rise) + 0.5;
         seconds += period_s) {
        double const counts = height_mm(rise, seconds) / 0.1 + rise.noise_counts * random.normal();
        arrivals.push_back(
            { seconds + 0.003, kHeight, height_report(static_cast<int>(std::lround(counts))) });
    }
}

std::vector<Arrival> arrivals_of(PenFormat const& format, Rise const& rise)
{
    std::vector<Arrival> arrivals;
    add_pen(arrivals, format, rise);
    add_heights(arrivals, rise);
    std::stable_sort(arrivals.begin(), arrivals.end(),
                     [](auto const& a, auto const& b) { return a.seconds < b.seconds; });
    return arrivals;
}

Station station_of(drivers::DeviceInfo const& pen)
{
    StationOptions options;
    options.rig = rig();
    std::vector const devices { pen, drivers::simple_height_sensor() };
    return Station::create(devices, options).value();
}

struct Drawn {
    std::vector<tools::ToolStroke> strokes;
    std::vector<PenMoment> moments; // Moments of the pen, for the live ink.
    std::size_t tips_in_silence = 0;
};

Drawn draw(PenFormat const& format, Rise const& rise)
{
    auto station = station_of(format.device());
    Drawn drawn;
    for (auto const& [seconds, device, report] : arrivals_of(format, rise)) {
        station.push(device, at_s(seconds), report);
        auto const moments = station.take_moments();
        drawn.moments.insert(drawn.moments.end(), moments.begin(), moments.end());
    }
    station.finish();
    drawn.strokes = station.take_strokes();
    drawn.tips_in_silence = station.counts().tips_in_silence;
    return drawn;
}

class VerticalStroke : public testing::TestWithParam<PenFormat> { };

// The pressure changes often, because the pens of some tablets count as gone after 0.1 s of
// silence.
Rise rise_of(double mm_per_s)
{
    return { .mm_per_s = mm_per_s, .pressure_changes_hz = 12 };
}

void expect_truth(std::vector<TipSample> const& tips, Rise const& rise)
{
    double longest_gap_s = 0;
    double worst_mm = 0;
    double aside_mm = 0;
    for (std::size_t i = 0; i < tips.size(); ++i) {
        double const seconds = to_seconds(tips[i].time - Timestamp());
        worst_mm = std::max(worst_mm, std::abs(tips[i].position_mm.z() - height_mm(rise, seconds)));
        aside_mm = std::max(aside_mm, (tips[i].position_mm - tips[0].position_mm).head<2>().norm());
        // The surface counts as moving only after it has moved by SilentTouch::kMoved_mm.
        double const moves_s = kStart_s + calib::SilentTouch::kMoved_mm / rise.mm_per_s;
        if (i > 0 && to_seconds(tips[i - 1].time - Timestamp()) > moves_s && seconds < stop_s(rise))
            longest_gap_s = std::max(longest_gap_s, to_seconds(tips[i].time - tips[i - 1].time));
    }
    EXPECT_LE(longest_gap_s, 0.01);
    EXPECT_LE(worst_mm, 0.5);
    EXPECT_EQ(aside_mm, 0);
}

TEST_P(VerticalStroke, HasTipsAllTheWayAtEverySpeed)
{
    for (double const mm_per_s : { 20, 50, 100, 200, 400 })
        for (double const readings_hz : { 110, 250, 500, 1000 }) {
            auto rise = rise_of(mm_per_s);
            rise.readings_hz = readings_hz;
            SCOPED_TRACE(fmt::format("{} mm/s, {} Hz", mm_per_s, readings_hz));
            auto const drawn = draw(GetParam(), rise);
            ASSERT_EQ(drawn.strokes.size(), 1u);
            auto const& tips = drawn.strokes[0].stroke.tips.vector();
            expect_truth(tips, rise);
            EXPECT_NEAR(tips.front().position_mm.z(), kLow_mm, 0.2);
            EXPECT_NEAR(tips.back().position_mm.z(), kHigh_mm, 0.2);
        }
}

TEST_P(VerticalStroke, HasTipsInTimeOrderWithThePenLastPressure)
{
    auto const drawn = draw(GetParam(), rise_of(100));
    ASSERT_EQ(drawn.strokes.size(), 1u);
    auto const& tips = drawn.strokes[0].stroke.tips;
    for (std::size_t i = 1; i < tips.size(); ++i) {
        EXPECT_LT(tips[i - 1].time, tips[i].time);
        // In this recording, the pressure only rises.
        EXPECT_LE(tips[i - 1].pressure, tips[i].pressure);
    }
    EXPECT_GT(tips.front().pressure, 0);
}

TEST_P(VerticalStroke, IsLiveInkAtOnce)
{
    for (double const mm_per_s : { 20, 400 }) {
        auto const rise = rise_of(mm_per_s);
        auto const drawn = draw(GetParam(), rise);
        std::size_t count = 0;
        for (auto const& moment : drawn.moments) {
            double const seconds = to_seconds(moment.time - Timestamp());
            if (seconds < kStart_s + 0.05 || seconds > stop_s(rise) - 0.05)
                continue;
            ++count;
            EXPECT_TRUE(moment.touching);
            EXPECT_NEAR(moment.position_mm.z(), height_mm(rise, seconds), 1);
        }
        EXPECT_GE(static_cast<double>(count), 100 * (stop_s(rise) - kStart_s - 0.1));
    }
}

TEST_P(VerticalStroke, SinksAsItRises)
{
    // With a sensor that counts down, the readings of a rise must give its mirror image: a descent.
    auto const rise = rise_of(150);
    auto const up = draw(GetParam(), rise);
    StationOptions options;
    options.rig = rig();
    options.rig.height_model = calib::LinearHeight { .mm_per_count = -0.1, .zero_counts = 4000 };
    std::vector const devices { GetParam().device(), drivers::simple_height_sensor() };
    auto station = Station::create(devices, options).value();
    for (auto const& [seconds, device, report] : arrivals_of(GetParam(), rise))
        station.push(device, at_s(seconds), report);
    station.finish();
    auto const down = station.take_strokes();
    ASSERT_EQ(down.size(), 1u);
    auto const& tips = down[0].stroke.tips;
    ASSERT_EQ(tips.size(), up.strokes.at(0).stroke.tips.size());
    for (std::size_t i = 0; i < tips.size(); ++i)
        EXPECT_NEAR(tips[i].position_mm.z(), 400 - up.strokes[0].stroke.tips[i].position_mm.z(),
                    1e-6);
}

INSTANTIATE_TEST_SUITE_P(Formats, VerticalStroke,
                         testing::Values(standard_pen(), mouse_mode_pen(), huion_v2_pen()),
                         [](auto const& info) {
                             std::string name = info.param.name;
                             std::erase(name, ' ');
                             return name;
                         });

TEST(SilentPen, KeepsWithinHalfAMillimetreAmongNoise)
{
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        Random random({ .seed = seed, .stream = 7 });
        Rise const rise { .mm_per_s = random.uniform(20, 400),
                          .readings_hz = random.uniform(200, 1000),
                          .noise_counts = 0.5,
                          .seed = seed };
        SCOPED_TRACE(fmt::format("{:.0f} mm/s, {:.0f} Hz", rise.mm_per_s, rise.readings_hz));
        auto const drawn = draw(standard_pen(), rise);
        ASSERT_EQ(drawn.strokes.size(), 1u);
        expect_truth(drawn.strokes[0].stroke.tips.vector(), rise);
    }
}

TEST(SilentPen, HasNoTipsWhileTheSurfaceRests)
{
    auto station = station_of(standard_pen().device());
    std::vector<Arrival> arrivals;
    Rise const short_rise {}; // Only the times of the pen's reports matter in this test.
    add_pen(arrivals, standard_pen(), short_rise);
    Random random({ .seed = 3 });
    for (double seconds = 0; seconds < stop_s(short_rise) + 1; seconds += 0.002)
        arrivals.push_back(
            { seconds, kHeight,
              height_report(static_cast<int>(std::lround(1000 + random.normal()))) });
    std::stable_sort(arrivals.begin(), arrivals.end(),
                     [](auto const& a, auto const& b) { return a.seconds < b.seconds; });
    for (auto const& [seconds, device, report] : arrivals)
        station.push(device, at_s(seconds), report);
    EXPECT_EQ(station.counts().tips_in_silence, 0u);
}

// Returns the reports of a pen that moves while the surface rises. Its tablet streams about 200
// reports a second at irregular times; those from `lost_from_s` to `lost_to_s` are lost.
std::vector<Arrival> streaming_arrivals(std::uint64_t seed, double lost_from_s, double lost_to_s)
{
    Random random({ .seed = seed });
    std::vector<Arrival> arrivals;
    for (double seconds = 0.1; seconds < 1; seconds += 0.005)
        if (seconds < lost_from_s || seconds >= lost_to_s)
            arrivals.push_back(
                { seconds + 0.008 + 0.001 * random.uniform(), kPen,
                  standard_pen().report(
                      { .x_mm = 20 + 150 * seconds, .y_mm = 40, .touching = true }) });
    arrivals.push_back({ 1.01, kPen, standard_pen().report({ .x_mm = 170, .y_mm = 40 }) });
    for (double seconds = 0; seconds < 1.2; seconds += 0.002)
        arrivals.push_back(
            { seconds + 0.003, kHeight, height_report(static_cast<int>(1000 + 2000 * seconds)) });
    std::stable_sort(arrivals.begin(), arrivals.end(),
                     [](auto const& a, auto const& b) { return a.seconds < b.seconds; });
    return arrivals;
}

TEST(SilentPen, IsNeverOneThatSendsAllTheTime)
{
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        auto station = station_of(standard_pen().device());
        for (auto const& [seconds, device, report] : streaming_arrivals(seed, 0, 0))
            station.push(device, at_s(seconds), report);
        station.finish();
        EXPECT_EQ(station.counts().tips_in_silence, 0u);
        EXPECT_EQ(station.take_strokes().size(), 1u);
    }
}

TEST(SilentPen, IsNotOneWhoseReportsWereLostOnTheWay)
{
    auto station = station_of(standard_pen().device());
    for (auto const& [seconds, device, report] : streaming_arrivals(1, 0.5, 0.58))
        station.push(device, at_s(seconds), report);
    station.finish();
    // At that time, the station did not know yet that reports were lost.
    EXPECT_GT(station.counts().tips_in_silence, 0u);
    auto const strokes = station.take_strokes();
    ASSERT_EQ(strokes.size(), 1u);
    for (auto const& tip : strokes[0].stroke.tips) {
        double const seconds = to_seconds(tip.time - Timestamp());
        EXPECT_NEAR(tip.position_mm.x(), -80 + 150 * seconds, 0.3);
        EXPECT_NEAR(tip.position_mm.z(), 100 + 200 * seconds, 0.5);
    }
}

// The tablet streams its reports, but cannot report that the pen has left.
TEST(SilentPen, LeavesNoTailWhereItsSilenceMeansThatItHasLeft)
{
    auto station = station_of(mouse_mode_pen().device());
    Rise const rise { .mm_per_s = 150 };
    std::vector<Arrival> arrivals;
    // At first the pen rests, and its tablet continues to send reports.
    for (double seconds = 0.1; seconds < kStart_s; seconds += 0.005)
        arrivals.push_back(
            { seconds + 0.008, kPen,
              mouse_mode_pen().report(
                  { .x_mm = 20 + 20 * std::max(seconds, 0.2), .y_mm = 40, .touching = true }) });
    // The pen is lifted without a report, and later touches elsewhere.
    for (double seconds = 2; seconds < 2.2; seconds += 0.005)
        arrivals.push_back({ seconds + 0.008, kPen,
                             mouse_mode_pen().report(
                                 { .x_mm = 120 + 20 * seconds, .y_mm = 40, .touching = true }) });
    add_heights(arrivals, rise);
    std::stable_sort(arrivals.begin(), arrivals.end(),
                     [](auto const& a, auto const& b) { return a.seconds < b.seconds; });
    for (auto const& [seconds, device, report] : arrivals)
        station.push(device, at_s(seconds), report);
    station.finish();
    auto const strokes = station.take_strokes();
    ASSERT_EQ(strokes.size(), 2u);
    for (auto const& tip : strokes[0].stroke.tips)
        EXPECT_NEAR(tip.position_mm.z(), kLow_mm, 1);
    for (auto const& tip : strokes[1].stroke.tips)
        EXPECT_NEAR(tip.position_mm.z(), kHigh_mm, 1);
}

} // namespace
} // namespace tractus::station
