#pragma once

#include "engine/base/time.h"
#include "sim/hand.h"
#include "sim/simulated_rig.h"

#include <cstdint>
#include <vector>

namespace tractus::sim {

// Faults of hands, devices and computers, which simulations have only on request. Each fault has
// its own fields. Equal input and options give equal results.
struct Unkindness {
    std::uint64_t seed = 1;

    // Length by which the pen continues, on a curve over the tablet, while it leaves the surface.
    // Chosen at random between the least and the greatest length for each stroke; 0: no hooks.
    double min_hook_mm = 0;
    double most_hook_mm = 0;

    // Share of the strokes before which the pen touches by mistake, close to their start and for at
    // most 4.5 mm. Public recordings of tablets: 88 of 251 strokes extend less than 5 mm, 75 of
    // them less than 2 mm.
    double dab_share = 0;

    // The hand trembles at 8 to 12 Hz with this standard deviation along x and along y, in place of
    // HandOptions' tremor; 0: HandOptions' tremor is used. Measured in the 3D strokes that come
    // with Tilt Brush (which are drawn in the air at 300 to 700 mm/s), as the mean of the three
    // axes in windows of 0.5 s, cubic trend removed: medians 0.17 mm (toolkit_sketch1) and 0.31 mm
    // (Wire); half as much from 12 to 20 Hz.
    double tremor_mm = 0;

    // True: the tablet sends no report that equals the previous one, so a resting pen is silent.
    bool reports_changes_only = false;

    // Share of the tablet's reports that are lost at random, which makes the report rate irregular.
    // Reports in which the pen arrives, leaves, touches or lifts are always sent.
    double skipped_share = 0;

    // Interval at which the tablet's waiting reports are delivered in a batch; 0: each is delivered
    // at once.
    Duration batch_period {};

    // Period of wrong height readings, which are off by 100 counts up to half of full scale: a run
    // of one to `most_wrong_in_a_row` begins once in each period; 0: none. Only for HidSlider,
    // since frames have a checksum.
    Duration wrong_period {};
    int most_wrong_in_a_row = 10;

    // Time at the end of each `stall_period` in which the computer reads nothing. Afterwards all
    // waiting reports get the same time. The kernel keeps the first 64 reports of each device. 0:
    // no stalls.
    Duration stall {};
    Duration stall_period {};

    bool operator==(Unkindness const&) const = default;

    // True if reports come late, in bursts or not at all.
    bool delays_reports() const
    {
        return skipped_share > 0 || batch_period > Duration(0) || stall > Duration(0);
    }
};

// Returns all faults at once, as severe as at real stations; tests/app/station/unkind_hand_test.cpp
// states the remaining accuracy.
Unkindness all_unkindness(std::uint64_t seed);

// Ends each stroke in a horizontal hook to the side. A hook that would leave the rig's reach is
// omitted.
void add_hooks(std::vector<HandStroke>& strokes, RigGeometry const& geometry,
               Unkindness const& unkindness);

// Puts dabs, short touches by mistake, before some strokes. A dab that would leave the rig's reach
// is omitted.
void add_dabs(std::vector<HandStroke>& strokes, RigGeometry const& geometry,
              Unkindness const& unkindness);

void set_tremor(HandOptions& options, Unkindness const& unkindness);

// Adds the faults of devices and computer to the reports of a run. `truth` is unchanged, so it no
// longer has one entry for each report.
void make_unkind(SimulatedRun& run, Unkindness const& unkindness);

} // namespace tractus::sim
