#pragma once

#include "engine/plant/plant.h"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace tractus::variation {

// The axes of a plant by level: level 0 stands on the ground, level n on axes of level n - 1. What
// is computed from a parent to what it bears runs level by level, and within a level in any order.
struct AxisLevels {
    // Level after level; in a level the shorter axes first, by their number of segments, so that
    // neighbours grow side by side; those that are equal in the plant's order.
    std::vector<AxisId> axes;
    std::vector<std::uint32_t> first;       // Where each level begins in `axes`, and the end.
    std::vector<std::size_t> segment_count; // Number of segments of each level.

    std::size_t count() const { return segment_count.size(); }
    std::span<AxisId const> level(std::size_t number) const
    {
        return std::span(axes).subspan(first[number], first[number + 1] - first[number]);
    }
};

AxisLevels find_axis_levels(Plant const& plant);

// Calls `work` for some axes of a level at a time, until all were given, a level after the one that
// bears it. Calls within a level may run at once on several threads: each may write only what
// belongs to its own axes. Small levels run on the calling thread.
void for_each_level(AxisLevels const& levels,
                    std::function<void(std::span<AxisId const>)> const& work);

} // namespace tractus::variation
