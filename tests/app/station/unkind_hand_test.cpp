#include "app/station/station.h"
#include "sim/unkindness.h"

#include <algorithm>
#include <cstddef>
#include <fmt/core.h>
#include <gtest/gtest.h>
#include <utility>
#include <vector>

// Compares intended strokes with the results, under the worst behaviour of devices and computer.

namespace tractus::station {
namespace {

using namespace std::chrono_literals;

// Returns a hand that draws a vertical line with the pen at rest, a horizontal line and a rising
// curve.
sim::Hand hand_of(std::uint64_t seed, sim::Unkindness const& unkindness)
{
    sim::LineShape const upright { .from_mm = { -40, 10, 60 }, .to_mm = { -40, 10, 260 } };
    sim::LineShape const level { .from_mm = { -60, -30, 150 }, .to_mm = { 60, -20, 150 } };
    sim::HelixShape const curve {
        .foot_mm = { 20, 0, 80 }, .radius_mm = 30, .end_radius_mm = 20, .turns = 1.5, .rise_mm = 150
    };
    std::vector<sim::HandStroke> strokes { { .path = sim::make_path(upright) },
                                           { .path = sim::make_path(level) },
                                           { .path = sim::make_path(curve) } };
    sim::add_hooks(strokes, {}, unkindness);
    // Without tremor in the plane, the pen rests during the vertical line, and its tablet is
    // silent.
    return sim::Hand(std::move(strokes), { .seed = seed, .plane_tremor_mm = 0 });
}

struct Outcome {
    std::size_t strokes = 0;
    double worst_mm = 0; // Greatest distance of a tip from where the hand was at about that time.
    // Greatest distance of the hand's positions, pen down, from the nearest stroke.
    double missed_mm = 0;
};

double distance_mm(Vec3 const& point, Vec3 const& a, Vec3 const& b)
{
    Vec3 const way = b - a;
    double const length = way.squaredNorm();
    double const part = length > 0 ? std::clamp((point - a).dot(way) / length, 0.0, 1.0) : 0;
    return (point - a - part * way).norm();
}

// Draws with the given unkindness; tips may be as late as a stall delays reports.
Outcome draw(std::uint64_t seed, sim::Unkindness unkindness)
{
    unkindness.seed = seed;
    auto const hand = hand_of(seed, unkindness);
    auto run = sim::simulate_rig(hand, { .seed = seed });
    sim::make_unkind(run, unkindness);
    StationOptions options;
    options.rig = run.rig;
    options.rig.sample_times = calib::SampleTimes::Evened;
    std::vector const devices { run.tablet.info, run.height.info };
    auto station = Station::create(devices, options).value();
    for (auto const& [device, report] : run.in_order_of_arrival())
        station.push(device, report->received, report->bytes());
    station.finish();
    auto const strokes = station.take_strokes();
    Outcome outcome { .strokes = strokes.size() };
    for (auto const& drawn : strokes)
        for (auto const& tip : drawn.stroke.tips) {
            double nearest_mm = 1e9;
            for (auto time = tip.time - 150ms; time <= tip.time + 50ms; time += 1ms)
                nearest_mm
                    = std::min(nearest_mm, (hand.at(time).position_mm - tip.position_mm).norm());
            outcome.worst_mm = std::max(outcome.worst_mm, nearest_mm);
        }
    for (std::size_t i = 0; i < std::min(strokes.size(), hand.strokes().size()); ++i)
        for (auto time = hand.strokes()[i].down; time < hand.strokes()[i].up; time += 5ms) {
            double nearest_mm = 1e9;
            auto const& tips = strokes[i].stroke.tips;
            for (std::size_t k = 1; k < tips.size(); ++k)
                nearest_mm = std::min(nearest_mm,
                                      distance_mm(hand.at(time).position_mm,
                                                  tips[k - 1].position_mm, tips[k].position_mm));
            outcome.missed_mm = std::max(outcome.missed_mm, nearest_mm);
        }
    return outcome;
}

void expect_what_was_meant(sim::Unkindness const& unkindness, double bound_mm)
{
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        SCOPED_TRACE(fmt::format("seed {}", seed));
        auto const outcome = draw(seed, unkindness);
        EXPECT_EQ(outcome.strokes, 3u);
        EXPECT_LE(outcome.worst_mm, bound_mm);
        EXPECT_LE(outcome.missed_mm, bound_mm);
    }
}

std::vector<Timestamp> arrivals(sim::SimulatedDevice const& device)
{
    std::vector<Timestamp> times;
    for (auto const& report : device.reports)
        times.push_back(report.received);
    return times;
}

TEST(UnkindHand, SwitchesDoWhatTheySay)
{
    auto const hand = hand_of(1, {});
    auto const kind = sim::simulate_rig(hand, {});
    auto const made = [&](sim::Unkindness const& unkindness) {
        auto run = kind;
        sim::make_unkind(run, unkindness);
        EXPECT_TRUE(std::ranges::is_sorted(arrivals(run.tablet)));
        EXPECT_TRUE(std::ranges::is_sorted(arrivals(run.height)));
        return run;
    };
    auto const sent = kind.tablet.reports.size();
    EXPECT_EQ(made({}).tablet.reports.size(), sent);
    EXPECT_LT(made({ .reports_changes_only = true }).tablet.reports.size(), sent);
    EXPECT_NEAR(static_cast<double>(made({ .skipped_share = 0.3 }).tablet.reports.size()),
                0.7 * static_cast<double>(sent), 0.05 * static_cast<double>(sent));
    for (auto const time : arrivals(made({ .batch_period = 15ms }).tablet))
        EXPECT_EQ(time.time_since_epoch() % Duration(15ms), Duration(0));
    std::size_t wrong = 0;
    auto const misread = made({ .wrong_period = 300ms });
    for (std::size_t i = 0; i < kind.height.reports.size(); ++i)
        wrong += !std::ranges::equal(misread.height.reports[i].bytes(),
                                     kind.height.reports[i].bytes());
    EXPECT_GE(wrong, 10u);
    for (auto const time : arrivals(made({ .stall = 80ms, .stall_period = 700ms }).height))
        EXPECT_LT(time.time_since_epoch() % Duration(700ms), Duration(620ms));
    auto const hooked = hand_of(1, { .least_hook_mm = 0.5, .most_hook_mm = 2 });
    EXPECT_GT(hooked.end(), hand.end());
}

TEST(UnkindHand, DrawsWhatItMeansOnAKindRig)
{
    expect_what_was_meant({}, 0.6);
}

TEST(UnkindHand, DrawsWhatItMeansWhereOnlyChangesAreReported)
{
    expect_what_was_meant({ .reports_changes_only = true }, 0.6);
}

TEST(UnkindHand, DrawsWhatItMeansAtARaggedRate)
{
    expect_what_was_meant({ .reports_changes_only = true, .skipped_share = 0.3 }, 1.2);
}

TEST(UnkindHand, DrawsWhatItMeansInBatches)
{
    expect_what_was_meant({ .batch_period = 15ms }, 2.5);
}

TEST(UnkindHand, DrawsWhatItMeansAmongWrongReadings)
{
    expect_what_was_meant({ .wrong_period = 300ms }, 1);
}

TEST(UnkindHand, DrawsWhatItMeansOnAStallingComputer)
{
    expect_what_was_meant({ .stall = 80ms, .stall_period = 700ms }, 8);
}

TEST(UnkindHand, DrawsWhatItMeansWithAllOfThisAtOnce)
{
    expect_what_was_meant(sim::all_unkindness(1), 10);
}

} // namespace
} // namespace tractus::station
