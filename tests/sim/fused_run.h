#pragma once

#include "calib/fuser.h"
#include "drivers/height_decoders.h"
#include "drivers/reports/height_decoder.h"
#include "drivers/tablets/pen_decoders.h"
#include "sim/simulated_rig.h"

#include <gtest/gtest.h>
#include <vector>

namespace tractus::sim {

// Result of a simulated run that was processed by a station's decoders and fuser.
struct FusedRun {
    std::vector<TipSample> live;
    std::vector<TipSample> settled;
    calib::FuserCounts counts;
};

// Feeds the reports of a run through the real decoders and the fuser, with `rig` as its
// calibration.
inline FusedRun fuse(SimulatedRun const& run, calib::Rig const& rig)
{
    auto const pens = drivers::make_pen_decoder(run.tablet.info);
    auto const heights = drivers::make_height_decoder(run.height.info);
    EXPECT_TRUE(pens) << pens.error().message;
    EXPECT_TRUE(heights) << heights.error().message;

    FusedRun fused;
    calib::Fuser fuser(rig);
    std::vector<drivers::HeightSample> samples;
    std::vector<drivers::PenSample> new_pens;
    for (auto const& [device, report] : run.in_order_of_arrival()) {
        if (device == 1) {
            samples.clear();
            EXPECT_TRUE((*heights)->decode(*report, samples));
            for (auto const& sample : samples)
                fuser.push(sample);
        } else {
            new_pens.clear();
            EXPECT_TRUE((*pens)->decode(*report, new_pens));
            for (auto const& pen : new_pens)
                if (auto const tip = fuser.push(pen))
                    fused.live.push_back(*tip);
        }
    }
    fuser.flush();
    fused.settled = fuser.take_settled();
    fused.counts = fuser.counts();
    return fused;
}

// Returns a hand that moves at 300 mm/s in the plane and 200 mm/s in height at once, in strokes of
// every kind.
inline Hand fast_hand(std::uint64_t seed)
{
    auto const fast = [](PathShape const& shape) {
        return HandStroke { .path = make_path(shape), .speed_mm_s = 1000 };
    };
    // The path has 2.5 turns of 188.5 mm and rises by 314 mm, so that the speeds have the ratio 300
    // to 200.
    HelixShape const up {
        .foot_mm = { 0, 0, 20 }, .radius_mm = 30, .end_radius_mm = 30, .turns = 2.5, .rise_mm = 314
    };
    HelixShape const down { .foot_mm = { 40, -10, 380 },
                            .radius_mm = 55,
                            .end_radius_mm = 20,
                            .turns = -2,
                            .rise_mm = -350 };
    SCurveShape const s_curve { .from_mm = { -100, -50, 10 },
                                .to_mm = { 90, 60, 300 },
                                .swing_mm = 20 };
    BranchShape const branch { .from_mm = { 0, 0, 50 },
                               .length_mm = 160,
                               .heading_rad = 2,
                               .elevation_rad = 1.3,
                               .turn_rad = 0.5,
                               .bend_rad = -1.2 };
    LineShape const level { .from_mm = { -100, 60, 5 }, .to_mm = { 100, 60, 5 } };
    return Hand({ fast(up), fast(down), fast(s_curve), fast(branch), fast(level) },
                { .seed = seed });
}

// Distances of tips from where the hand was at their time.
struct Errors {
    double rms_mm = 0;
    double max_mm = 0;
};

inline Errors errors_of(std::vector<TipSample> const& tips, Hand const& hand)
{
    Errors errors;
    double sum_of_squares = 0;
    std::size_t count = 0;
    for (auto const& tip : tips) {
        if (!tip.touching)
            continue;
        double const error_mm = (tip.position_mm - hand.at(tip.time).position_mm).norm();
        errors.max_mm = std::max(errors.max_mm, error_mm);
        sum_of_squares += error_mm * error_mm;
        ++count;
    }
    EXPECT_GT(count, 0u);
    errors.rms_mm = std::sqrt(sum_of_squares / static_cast<double>(count));
    return errors;
}

} // namespace tractus::sim
