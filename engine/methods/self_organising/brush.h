#pragma once

#include "engine/base/result.h"
#include "engine/methods/self_organising/growing_tree.h"
#include "engine/methods/self_organising/habit.h"

#include <cstdint>
#include <vector>

namespace tractus::self_organising {

// The brush at one moment: a ball. Millimetres in the tree's frame.
struct BrushBall {
    double seconds = 0; // Since the stroke began; never falls.
    Vec3 centre = Vec3::Zero();
    double radius = 0;
};

// A stroke of the brush: the ball sows markers of free space where it comes, and the tree grows a
// number of years while it moves (TreeSketch: Longay et al. 2012).
struct BrushSweep {
    std::vector<BrushBall> balls {};
    int years = 1;
    double seconds_per_year = 0; // 0: the years divide the sweep's time evenly.
    // True: only buds grow that are in the ball, or no farther from it than they perceive. False:
    // all buds grow wherever the brush has been.
    bool waits_outside = false;
    std::uint64_t seed = 1; // Of the markers' places.
};

// The markers that a sweep sows in the end, in the order in which it reaches their cells. Number
// and places in a cell follow from the cell's place and the seed alone, so nothing is sown twice,
// and what lies where does not depend on how the brush came there. Fails, as the user's fault, for
// a sweep over more space than memory should hold.
Result<std::vector<Vec3>> sow(BrushSweep const& sweep, Habit const& habit);

// Grows the tree along the sweep. Branches stay where they grew: their weight bends them only as it
// grows later. `seed`: of the habit's chance. Fails like sow() and grow_step().
Result<void> grow_along(GrowingTree& tree, BrushSweep const& sweep, Habit const& habit,
                        std::uint64_t seed);

} // namespace tractus::self_organising
