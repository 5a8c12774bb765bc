#include "sim/simulated_rig.h"

#include "calib/rig_file.h"
#include "drivers/height_decoders.h"
#include "drivers/logs/log.h"
#include "drivers/logs/log_writer.h"
#include "drivers/tablets/pen_decoders.h"
#include "tests/drivers/heights.h"
#include "tests/sim/fused_run.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <sstream>

namespace tractus::sim {
namespace {

using namespace std::chrono_literals;

bool same_reports(SimulatedDevice const& a, SimulatedDevice const& b)
{
    return std::equal(a.reports.begin(), a.reports.end(), b.reports.begin(), b.reports.end(),
                      [](drivers::RawReport const& x, drivers::RawReport const& y) {
                          return x.received == y.received && x.size == y.size
                              && x.storage == y.storage;
                      });
}

// Returns all samples that the real decoder makes from a tablet's reports.
std::vector<drivers::PenSample> decoded(SimulatedDevice const& tablet)
{
    auto const decoder = drivers::make_pen_decoder(tablet.info).value();
    std::vector<drivers::PenSample> samples;
    for (auto const& report : tablet.reports)
        EXPECT_TRUE(decoder->decode(report, samples));
    return samples;
}

TEST(SimulatedTablet, ItsDescriptorSaysWhatItIs)
{
    auto const run = simulate_rig(fast_hand(1), {});
    auto const traits = drivers::make_pen_decoder(run.tablet.info).value()->traits();
    EXPECT_NEAR(traits.size_mm.x(), 254, 1e-9);
    EXPECT_NEAR(traits.size_mm.y(), 159, 1e-9);
    EXPECT_FALSE(traits.is_size_assumed);
    EXPECT_TRUE(traits.has_pressure);
    EXPECT_TRUE(traits.has_tilt);
    EXPECT_TRUE(traits.has_in_range);
    EXPECT_TRUE(traits.has_eraser);
    EXPECT_EQ(traits.button_count, 2u);
    EXPECT_EQ(traits.raw_pressure_maximum, 8191);
}

TEST(SimulatedTablet, ATabletOfAnotherSizeSaysSo)
{
    SimulatedRigOptions options;
    options.geometry.tablet_size_mm = { 600, 338.5 };
    auto const run = simulate_rig(fast_hand(1), options);
    auto const size_mm = drivers::make_pen_decoder(run.tablet.info).value()->traits().size_mm;
    EXPECT_LT((size_mm - Vec2(600, 338.5)).norm(), 1e-9);
}

TEST(SimulatedTablet, ReportsDecodeToWhatTheHandDid)
{
    auto const hand = fast_hand(1);
    SimulatedRigOptions options;
    options.geometry.rotation_deg = 3;
    options.geometry.tablet_size_mm = { 300, 200 };
    auto const run = simulate_rig(hand, options);
    auto const samples = decoded(run.tablet);
    ASSERT_EQ(samples.size(), run.truth.size());
    for (std::size_t i = 0; i < samples.size(); ++i) {
        auto const state = hand.at(run.truth[i].time);
        ASSERT_EQ(samples[i].in_range, state.in_range) << i;
        ASSERT_EQ(samples[i].touching, state.touching) << i;
        if (!state.in_range)
            continue;
        Vec3 const place_mm = T_tablet_world(options.geometry) * state.position_mm;
        ASSERT_LT((samples[i].position_mm - place_mm.head<2>()).norm(), 0.01) << i;
        ASSERT_NEAR(*samples[i].pressure, state.pressure, 1.0 / 8191) << i;
        ASSERT_LT((*samples[i].tilt_rad - state.tilt_rad).cwiseAbs().maxCoeff(), radians(0.51))
            << i;
        ASSERT_FALSE(samples[i].eraser);
        ASSERT_EQ(samples[i].buttons, 0u);
    }
}

TEST(SimulatedTablet, DrawsWithTheEraser)
{
    auto const path = make_path(LineShape { { 0, 0, 10 }, { 50, 0, 10 } });
    Hand const hand({ { .path = path, .eraser = true } }, {});
    auto const samples = decoded(simulate_rig(hand, {}).tablet);
    EXPECT_TRUE(std::any_of(samples.begin(), samples.end(),
                            [](auto const& sample) { return sample.eraser && sample.touching; }));
    for (auto const& sample : samples)
        EXPECT_TRUE(sample.eraser || !sample.in_range);
}

TEST(SimulatedTablet, SaysOnceThatThePenHasLeft)
{
    auto const samples = decoded(simulate_rig(fast_hand(1), {}).tablet);
    std::size_t departures = 0;
    for (std::size_t i = 1; i < samples.size(); ++i) {
        EXPECT_TRUE(samples[i].in_range || samples[i - 1].in_range) << i;
        departures += !samples[i].in_range;
    }
    EXPECT_GT(departures, 1u);
    EXPECT_FALSE(samples.back().in_range);
}

TEST(SimulatedTablet, APenOffTheActiveAreaIsOutOfRange)
{
    auto const path = make_path(LineShape { { 0, 0, 10 }, { 200, 0, 10 } });
    auto const samples = decoded(simulate_rig(Hand({ { .path = path } }, {}), {}).tablet);
    EXPECT_FALSE(samples.back().in_range);
    for (auto const& sample : samples) {
        EXPECT_LE(sample.position_mm.x(), 254);
        EXPECT_GE(sample.position_mm.x(), 100);
    }
    EXPECT_NEAR(samples.back().position_mm.x(), 254, 1);
}

TEST(SimulatedTablet, MeasuresTwoHundredTimesASecond)
{
    auto const run = simulate_rig(fast_hand(1), {});
    for (std::size_t i = 1; i < run.truth.size(); ++i)
        EXPECT_EQ((run.truth[i].time - run.truth[i - 1].time) % 5ms, 0ms);
}

TEST(SimulatedHeight, ReportsDecodeToTheCountsOfTheTrueHeight)
{
    auto const hand = fast_hand(1);
    SimulatedRigOptions options;
    options.height.timing.jitter = 0ms;
    auto const run = simulate_rig(hand, options);
    auto const decoder = drivers::make_height_decoder(run.height.info).value();
    EXPECT_EQ(decoder->full_scale(), 4095);
    double sum_of_squares = 0;
    for (auto const& report : run.height.reports) {
        auto const sample = drivers::decode_heights(*decoder, report).value().at(0);
        auto const height = hand.at(sample.time - options.height.timing.latency).position_mm.z();
        double const noise = sample.counts - ideal_counts(options.geometry, height);
        sum_of_squares += noise * noise;
        ASSERT_LT(std::abs(noise), 6);
    }
    double const count = static_cast<double>(run.height.reports.size());
    EXPECT_NEAR(count, to_seconds(hand.end()) * 500, 2);
    // Expected deviation: one count of noise, and a variance of 1/12 squared count for rounding.
    EXPECT_NEAR(std::sqrt(sum_of_squares / count), std::sqrt(1 + 1.0 / 12), 0.05);
}

TEST(SimulatedHeight, StopsAtTheConvertersEnds)
{
    SimulatedRigOptions options;
    options.geometry.string_at_zero_counts_mm = 300;
    auto const run = simulate_rig(fast_hand(1), options);
    auto const decoder = drivers::make_height_decoder(run.height.info).value();
    std::int32_t least = 4095;
    for (auto const& report : run.height.reports)
        least = std::min(least, drivers::decode_heights(*decoder, report).value().at(0).counts);
    EXPECT_EQ(least, 0);
}

TEST(SimulatedRig, SameSeedSameBytes)
{
    auto const a = simulate_rig(fast_hand(5), { .seed = 5 });
    auto const b = simulate_rig(fast_hand(5), { .seed = 5 });
    EXPECT_TRUE(same_reports(a.tablet, b.tablet));
    EXPECT_TRUE(same_reports(a.height, b.height));
}

TEST(SimulatedRig, AnotherSeedIsAnotherRun)
{
    auto const hand = fast_hand(5);
    auto const a = simulate_rig(hand, { .seed = 5 });
    auto const b = simulate_rig(hand, { .seed = 6 });
    EXPECT_FALSE(same_reports(a.tablet, b.tablet));
    EXPECT_FALSE(same_reports(a.height, b.height));
    auto const c = simulate_rig(fast_hand(6), { .seed = 5 });
    EXPECT_FALSE(same_reports(a.tablet, c.tablet));
}

// Returns a run after it was written as a log, and the log was read again.
SimulatedRun replayed_from_log(SimulatedRun const& run)
{
    std::ostringstream file;
    drivers::LogWriter writer(
        file,
        { .devices = { run.tablet.info, run.height.info }, .rig_text = calib::print_rig(run.rig) });
    for (auto const& [device, report] : run.in_order_of_arrival())
        writer.write_report(device, report->received, report->bytes());
    EXPECT_TRUE(writer.flush());

    auto const log = drivers::parse_log(file.str(), "simulated").value();
    SimulatedRun replayed { .tablet = { log.devices.at(0), {} },
                            .height = { log.devices.at(1), {} },
                            .rig = calib::parse_rig(log.rig_text, "simulated").value() };
    for (auto const& record : log.records) {
        drivers::RawReport report { .received = record.time, .size = record.size };
        std::ranges::copy(log.report(record), report.storage.begin());
        (record.device == 0 ? replayed.tablet : replayed.height).reports.push_back(report);
    }
    return replayed;
}

void expect_same_tips_from_log(SimulatedRun const& run)
{
    auto const replayed = replayed_from_log(run);
    auto const live = fuse(run, run.rig).settled;
    auto const read = fuse(replayed, replayed.rig).settled;
    ASSERT_EQ(read.size(), live.size());
    for (std::size_t i = 0; i < read.size(); ++i) // Times in a log are whole microseconds.
        ASSERT_LT((read[i].position_mm - live[i].position_mm).norm(), 1e-3) << i;
}

// Returns options for the station's own kind of sensor on a busy computer. The sensor's clock is
// slow by 200 ppm.
SimulatedRigOptions with_frames()
{
    SimulatedRigOptions options;
    options.height.wire = HeightWire::Frames;
    options.height.clock_drift_ppm = 200;
    return options;
}

TEST(SimulatedRig, ALogOfItFusesToTheSameStrokes)
{
    expect_same_tips_from_log(simulate_rig(fast_hand(1), {}));
}

TEST(SimulatedRig, ALogOfFramesFusesToTheSameStrokes)
{
    expect_same_tips_from_log(simulate_rig(fast_hand(1), with_frames()));
}

TEST(SimulatedRig, FramesAreNoWorseThanASlider)
{
    auto const hand = fast_hand(1);
    auto const slider = simulate_rig(hand, {});
    auto const frames = simulate_rig(hand, with_frames());
    auto const slider_errors = errors_of(fuse(slider, slider.rig).settled, hand);
    auto const frames_errors = errors_of(fuse(frames, frames.rig).settled, hand);
    // Nearly all of either error comes from the converter's noise, which is the same for both
    // sensors.
    EXPECT_LT(frames_errors.rms_mm, 1.01 * slider_errors.rms_mm);
    EXPECT_LT(frames_errors.max_mm, 1.02 * slider_errors.max_mm);
}

// Simulates a host that stalls for 60 ms of each half second: reports that arrive during a stall
// are delayed to its end.
void look_away(SimulatedDevice& device)
{
    for (auto& report : device.reports)
        if (auto const since = report.received.time_since_epoch() % 500ms; since < 60ms)
            report.received += 60ms - since;
}

TEST(SimulatedRig, FramesKeepTheirTimesWhenTheHostLooksAway)
{
    auto const hand = fast_hand(1);
    auto frames = simulate_rig(hand, with_frames());
    auto slider = simulate_rig(hand, {});
    look_away(frames.height);
    look_away(slider.height);
    EXPECT_LT(errors_of(fuse(frames, frames.rig).settled, hand).max_mm, 0.5);
    EXPECT_GT(errors_of(fuse(slider, slider.rig).settled, hand).max_mm, 3);
}

TEST(SimulatedRig, AWrongHeightModelMissesTheTruth)
{
    auto const hand = fast_hand(1);
    auto const run = simulate_rig(hand, {});
    // The readings are compared with the straight line through both ends of the travel.
    RigGeometry const geometry;
    double const low = ideal_counts(geometry, 0);
    double const high = ideal_counts(geometry, geometry.travel_mm);
    auto rig = run.rig;
    rig.height_model = calib::LinearHeight { .mm_per_count = geometry.travel_mm / (high - low),
                                             .zero_counts = low };
    auto const right = errors_of(fuse(run, run.rig).settled, hand);
    auto const wrong = errors_of(fuse(run, rig).settled, hand);
    EXPECT_LT(right.max_mm, 1);
    EXPECT_GT(wrong.rms_mm, 5);
    EXPECT_GT(wrong.max_mm, 15);
}

TEST(SimulatedRig, AWrongLatencyMissesTheTruth)
{
    auto const hand = fast_hand(1);
    auto const run = simulate_rig(hand, {});
    auto rig = run.rig;
    rig.height_latency = rig.tablet_latency = 0ms;
    EXPECT_GT(errors_of(fuse(run, rig).settled, hand).max_mm, 1.5);
}

// With a coil 9 mm above the nib, the position of a pen that leans by about 30 degrees is off by 5
// mm; a rig with that coil height must put tips where the hand was.
TEST(SimulatedRig, SeesThePenByItsCoil)
{
    auto const hand = fast_hand(1);
    SimulatedRigOptions options;
    options.geometry.coil_height_mm = 9;
    auto const run = simulate_rig(hand, options);
    auto rig = run.rig;
    EXPECT_EQ(rig.coil_height_mm, Vec2(9, 9));
    EXPECT_LT(errors_of(fuse(run, rig).settled, hand).max_mm, 0.6);
    rig.coil_height_mm = Vec2::Zero();
    EXPECT_GT(errors_of(fuse(run, rig).settled, hand).max_mm, 4);
}

TEST(SimulatedRig, SurvivesATurnedTabletAndACrookedTravel)
{
    auto const hand = fast_hand(1);
    SimulatedRigOptions options;
    options.geometry.tablet_size_mm = { 300, 220 };
    options.geometry.rotation_deg = 7;
    options.geometry.travel_shear = { 0.03, -0.02 };
    auto const run = simulate_rig(hand, options);
    EXPECT_LT(errors_of(fuse(run, run.rig).settled, hand).max_mm, 1);
}

} // namespace
} // namespace tractus::sim
