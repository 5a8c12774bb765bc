#pragma once

#include "engine/base/result.h"
#include "engine/methods/self_organising/growing_tree.h"
#include "engine/methods/self_organising/habit.h"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace tractus::self_organising {

// A spherical brush at one moment, in millimetres in the tree's frame.
struct BrushBall {
    double seconds = 0; // Time since the stroke began; non-decreasing.
    Vec3 centre = Vec3::Zero();
    double radius = 0;
};

// A brush stroke that a tree follows: the moving ball sows markers of free space, and the tree
// grows for `years` years meanwhile (TreeSketch: Longay et al. 2012).
struct BrushSweep {
    std::vector<BrushBall> balls {};
    int years = 1;
    // Seconds of drawing that count as one year; 0: the years divide the stroke's duration evenly.
    double seconds_per_year = 0;
    // True: a bud grows only while it is in the moving ball or no further from it than the bud's
    // perception radius. False: buds grow wherever the brush has been.
    bool waits_outside = false;
    // True: the balls together are a volume, which is sown as a whole before the first year; the
    // space between successive balls is not sown.
    bool is_volume = false;
    // Brush paths that cleared space: no markers are sown in the cells that these paths cover.
    std::vector<std::vector<BrushBall>> cleared {};
    std::uint64_t seed = 1; // Seed of the markers' positions.
};

// Checks the balls of a brush's path. Fails with a user error if a ball's radius is not positive or
// a number is not finite.
Result<void> check_balls(std::span<BrushBall const> balls);

// Resamples a brush's path so densely that the centres of successive balls are at most a quarter of
// the smaller radius apart.
std::vector<BrushBall> dense_path(std::span<BrushBall const> balls);

// Computes the markers that a whole sweep sows, in the order in which the brush reaches their
// cells. The markers in a cell follow from the cell's position and the seed alone: no cell is sown
// twice, and markers do not depend on how the brush moved over a cell. Fails like check_balls(),
// and with a user error if the sweep covers too many cells.
Result<std::vector<Vec3>> sow(BrushSweep const& sweep, Habit const& habit);

// Receives the tree after each year.
using YearCallback = std::function<void(GrowingTree const&)>;

// Grows the tree along the sweep. The branches keep the shape in which they grew; only weight that
// is added later bends them. `seed` drives the habit's random variation. Fails like sow() and
// grow_step().
Result<void> grow_along(GrowingTree& tree, BrushSweep const& sweep, Habit const& habit,
                        std::uint64_t seed, YearCallback const& on_year = {});

} // namespace tractus::self_organising
