#pragma once

#include "engine/plant/plant.h"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace tractus::variation {

// The axes of a plant by level: level 0 is on the ground, level n is attached to axes of level n -
// 1. Computations that need the results of parents run level by level, in any order within a level.
struct AxisLevels {
    // All axes, level after level. Within a level they ascend by number of segments, so that axes
    // processed side by side take similar time; axes with equally many segments keep the plant's
    // order.
    std::vector<AxisId> axes;
    // Index in `axes` of each level's first axis, followed by the total number of axes.
    std::vector<std::uint32_t> first;
    std::vector<std::size_t> segment_count; // Number of segments of each level.

    std::size_t count() const { return segment_count.size(); }
    std::span<AxisId const> level(std::size_t number) const
    {
        return std::span(axes).subspan(first[number], first[number + 1] - first[number]);
    }
};

AxisLevels find_axis_levels(Plant const& plant);

// Calls `work` for groups of axes, level by level. Calls within a level may run concurrently: each
// may write only data of its own axes. Small levels run on the calling thread.
void for_each_level(AxisLevels const& levels,
                    std::function<void(std::span<AxisId const>)> const& work);

} // namespace tractus::variation
