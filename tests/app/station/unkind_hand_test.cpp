#include "app/station/station.h"
#include "sim/unkindness.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fmt/core.h>
#include <gtest/gtest.h>
#include <utility>
#include <vector>

// Compares intended strokes with the drawn ones when the hand, the devices and the computer behave
// badly.

namespace tractus::station {
namespace {

using namespace std::chrono_literals;

// Returns a hand that draws a vertical line with the pen at rest on the tablet, a horizontal line,
// and a rising curve.
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
    sim::add_dabs(strokes, {}, unkindness);
    // The hand has no tremor in the plane of the tablet. So the pen rests during the vertical line,
    // and its tablet sends no reports.
    sim::HandOptions options { .seed = seed, .plane_tremor_mm = 0 };
    sim::set_tremor(options, unkindness);
    return sim::Hand(std::move(strokes), options);
}

// Returns the position of the hand for each millisecond.
std::vector<Vec3> places_of(sim::Hand const& hand)
{
    std::vector<Vec3> places;
    for (Timestamp time {}; time <= hand.end(); time += 1ms)
        places.push_back(hand.at(time).position_mm);
    return places;
}

struct Outcome {
    std::size_t strokes = 0;
    std::size_t meant = 0; // Number of the hand's strokes, including dabs.
    // Maximum distance of a tip from the positions of the hand at about the tip's time.
    double worst_mm = 0;
    // Maximum distance of the hand's positions, with the pen down, from the nearest drawn stroke.
    double missed_mm = 0;
};

double distance_mm(Vec3 const& point, Vec3 const& a, Vec3 const& b)
{
    Vec3 const way = b - a;
    double const length = way.squaredNorm();
    double const part = length > 0 ? std::clamp((point - a).dot(way) / length, 0.0, 1.0) : 0;
    return (point - a - part * way).norm();
}

// Draws with the given unkindness. The time of a tip may be as late as a stall delays reports.
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
    auto const places = places_of(hand);
    Outcome outcome { .strokes = strokes.size(), .meant = hand.strokes().size() };
    for (auto const& drawn : strokes)
        for (auto const& tip : drawn.stroke.tips) {
            double nearest_mm = 1e9;
            auto const at = tip.time.time_since_epoch() / Duration(1ms);
            auto const end = std::min(at + 50, std::ssize(places) - 1);
            for (auto ms = std::max<std::ptrdiff_t>(at - 150, 0); ms <= end; ++ms)
                nearest_mm = std::min(
                    nearest_mm, (places[static_cast<std::size_t>(ms)] - tip.position_mm).norm());
            outcome.worst_mm = std::max(outcome.worst_mm, nearest_mm);
        }
    for (std::size_t i = 0; i < std::min(strokes.size(), hand.strokes().size()); ++i)
        for (auto time = hand.strokes()[i].down; time < hand.strokes()[i].up; time += 5ms) {
            double nearest_mm = 1e9;
            Vec3 const place_mm
                = places[static_cast<std::size_t>(time.time_since_epoch() / Duration(1ms))];
            auto const& tips = strokes[i].stroke.tips;
            for (std::size_t k = 1; k < tips.size(); ++k)
                nearest_mm
                    = std::min(nearest_mm,
                               distance_mm(place_mm, tips[k - 1].position_mm, tips[k].position_mm));
            outcome.missed_mm = std::max(outcome.missed_mm, nearest_mm);
        }
    return outcome;
}

void expect_what_was_meant(sim::Unkindness const& unkindness, double bound_mm)
{
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        SCOPED_TRACE(fmt::format("seed {}", seed));
        auto const outcome = draw(seed, unkindness);
        EXPECT_EQ(outcome.strokes, outcome.meant);
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
    auto const hooked = hand_of(1, { .min_hook_mm = 0.5, .most_hook_mm = 2 });
    EXPECT_GT(hooked.end(), hand.end());
}

TEST(UnkindHand, DabsAsOftenAndAsShortlyAsInPublicRecordings)
{
    std::vector<sim::HandStroke> strokes(
        1000, { .path = sim::Path({ { 0, 0, 50 }, { 50, 0, 50 } }), .speed_mm_s = 150 });
    sim::add_dabs(strokes, {}, { .dab_share = 0.35 });
    std::size_t dabs = 0;
    std::size_t shorter_than_2_mm = 0;
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        if (!strokes[i].is_dab)
            continue;
        ++dabs;
        double const length_mm = strokes[i].path.length_mm();
        shorter_than_2_mm += length_mm < 2;
        EXPECT_LT(length_mm, 5);
        ASSERT_LT(i + 1, strokes.size());
        EXPECT_FALSE(strokes[i + 1].is_dab);
        EXPECT_LT((strokes[i].path.points_mm().front() - Vec3(0, 0, 50)).norm(), 2.001);
    }
    EXPECT_NEAR(static_cast<double>(dabs), 350, 40);
    EXPECT_NEAR(static_cast<double>(shorter_than_2_mm), static_cast<double>(dabs) * 75 / 88, 25);
}

// Tests the deviation of a trembling hand at rest, and how often it crosses its mean position:
// twice per wave.
TEST(UnkindHand, TremblesFrom8To12HzByWhatWasMeasured)
{
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        sim::HandOptions options { .seed = seed, .pause = 10s };
        sim::set_tremor(options, { .tremor_mm = 0.3 });
        sim::Hand const hand({ { .path = sim::Path({ { 0, 0, 50 }, { 1, 0, 50 } }) } }, options);
        double squares = 0;
        int crossings = 0;
        double last = 0;
        for (auto time = Timestamp(500ms); time < Timestamp(9500ms); time += 1ms) {
            double const y_mm = hand.at(time).position_mm.y();
            squares += y_mm * y_mm;
            crossings += last * y_mm < 0;
            last = y_mm;
        }
        // The deviation varies, since waves of close frequencies interfere.
        EXPECT_NEAR(std::sqrt(squares / 9000), 0.3, 0.05);
        EXPECT_GE(crossings, 2 * 8 * 9 - 2);
        EXPECT_LE(crossings, 2 * 12 * 9 + 2);
    }
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

TEST(UnkindHand, DrawsWhatItMeansBetweenDabs)
{
    expect_what_was_meant({ .dab_share = 1 }, 0.6);
}

TEST(UnkindHand, DrawsWhatItMeansTrembling)
{
    expect_what_was_meant({ .tremor_mm = 0.3 }, 0.8);
}

TEST(UnkindHand, DrawsWhatItMeansWithAllOfThisAtOnce)
{
    expect_what_was_meant(sim::all_unkindness(1), 10);
}

} // namespace
} // namespace tractus::station
