#pragma once

#include "engine/base/time.h"
#include "sim/hand.h"
#include "sim/simulated_rig.h"

#include <cstdint>
#include <vector>

namespace tractus::sim {

// Faults of hands, devices and computers that a simulation leaves out unless asked. Each field is a
// switch; all are off by default. Pure: the same input and options give the same result.
struct Unkindness {
    std::uint64_t seed = 1;

    // The pen goes on by this much, in a bend over the tablet, while it leaves the surface. Drawn
    // anew for each stroke between the two; 0: no hooks.
    double least_hook_mm = 0;
    double most_hook_mm = 0;

    // The tablet sends no report that equals the one before: a resting pen is silent.
    bool reports_changes_only = false;

    // Share of the tablet's reports that are lost at random, which makes the report rate ragged.
    // Reports in which the pen comes, goes, touches or lifts are always sent.
    double skipped_share = 0;

    // The tablet's reports are delivered in batches, one at the end of each period; 0: at once.
    Duration batch_period {};

    // Wrong height readings, off by 100 counts up to half of full scale: a run of one to
    // `most_wrong_in_a_row` begins once in each period; 0: none. For the HID slider only, since
    // frames carry a checksum.
    Duration wrong_period {};
    int most_wrong_in_a_row = 10;

    // The computer reads nothing during the last `stall` of each period, then stamps at once what
    // has come meanwhile. The kernel keeps the first 64 reports of each device. 0: no stalls.
    Duration stall {};
    Duration stall_period {};
};

// Everything at once, in the amounts that stations have met; tests/app/station/unkind_hand_test.cpp
// has the accuracy that remains.
Unkindness all_unkindness(std::uint64_t seed);

// Ends each stroke in a hook, sideways and level. A hook that would leave the rig's reach is left
// out.
void add_hooks(std::vector<HandStroke>& strokes, RigGeometry const& geometry,
               Unkindness const& unkindness);

// Changes what arrives; the truth stays, so that it no longer has one entry per report.
void make_unkind(SimulatedRun& run, Unkindness const& unkindness);

} // namespace tractus::sim
