#include "tests/sim/fused_run.h"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>
#include <gtest/gtest.h>

// Compares tips, made by the whole chain from reports on, with the true positions: with noise,
// rounding, jitter and latencies of the sensors, and a hand at 300 mm/s in the plane and 200 mm/s
// in height.

namespace tractus::calib {
namespace {

constexpr std::uint64_t kRigs = 24;

TEST(FusionAccuracy, SettledTipsLieWithinAMillimetreOfTheTruth)
{
    double worst_rms_mm = 0;
    double worst_max_mm = 0;
    std::string distribution;
    for (std::uint64_t seed = 1; seed <= kRigs; ++seed) {
        auto const hand = sim::fast_hand(seed);
        auto const run = sim::simulate_rig(hand, { .seed = seed });
        auto const fused = sim::fuse(run, run.rig);
        EXPECT_EQ(fused.settled.size(), run.truth.size());
        auto const errors = sim::errors_of(fused.settled, hand);
        worst_rms_mm = std::max(worst_rms_mm, errors.rms_mm);
        worst_max_mm = std::max(worst_max_mm, errors.max_mm);
        distribution += fmt::format("{:.3f}/{:.3f} ", errors.rms_mm, errors.max_mm);
    }
    RecordProperty("rms_and_max_mm_per_seed", distribution);
    // The promised limits are 1.0 mm and 3 mm; the limits here are those stated in calib/fuser.h.
    EXPECT_LT(worst_rms_mm, 0.2) << distribution;
    EXPECT_LT(worst_max_mm, 0.5) << distribution;
}

TEST(FusionAccuracy, TheConvertersStepsDoNotShowInASlowStroke)
{
    // The stroke is near the bottom, where a count is 0.15 mm of height. The hand moves by 0.05 mm
    // per sample.
    sim::LineShape const slow { .from_mm = { 0, 0, 20 }, .to_mm = { 0, 0, 70 } };
    sim::Hand const hand({ { .path = sim::make_path(slow), .speed_mm_s = 10 } },
                         { .height_tremor_mm = 0 });
    auto const run = sim::simulate_rig(hand, {});
    auto const fused = sim::fuse(run, run.rig);
    double greatest_step_mm = 0;
    for (std::size_t i = 1; i < fused.settled.size(); ++i)
        if (fused.settled[i].touching && fused.settled[i - 1].touching)
            greatest_step_mm = std::max(
                greatest_step_mm,
                std::abs(fused.settled[i].position_mm.z() - fused.settled[i - 1].position_mm.z()));
    EXPECT_LT(greatest_step_mm, 0.15);
    EXPECT_LT(sim::errors_of(fused.settled, hand).rms_mm, 0.06);
}

TEST(FusionAccuracy, LiveTipsLieWithinWhatTheFusersHeaderSays)
{
    double worst_max_mm = 0;
    double worst_rms_mm = 0;
    for (std::uint64_t seed = 1; seed <= kRigs; ++seed) {
        auto const hand = sim::fast_hand(seed);
        auto const run = sim::simulate_rig(hand, { .seed = seed });
        auto const errors = sim::errors_of(sim::fuse(run, run.rig).live, hand);
        worst_rms_mm = std::max(worst_rms_mm, errors.rms_mm);
        worst_max_mm = std::max(worst_max_mm, errors.max_mm);
    }
    RecordProperty("worst_rms_mm", fmt::format("{:.3f}", worst_rms_mm));
    RecordProperty("worst_max_mm", fmt::format("{:.3f}", worst_max_mm));
    EXPECT_LT(worst_rms_mm, 0.2);
    EXPECT_LT(worst_max_mm, 1);
}

} // namespace
} // namespace tractus::calib
