#include "engine/variation/axis_levels.h"

#include "engine/base/parallel.h"

#include <algorithm>

namespace tractus::variation {

// Minimum number of segments in a level that is divided among threads. With fewer, one thread
// finishes the level before others have woken up.
constexpr std::size_t kSegmentsWorthThreads = 4096;

AxisLevels find_axis_levels(Plant const& plant)
{
    std::vector<std::uint32_t> level_of(plant.axes.size());
    AxisLevels levels;
    for (AxisId id = 0; id < plant.axes.size(); ++id) { // Parents come before laterals.
        auto const& axis = plant.axes[id];
        level_of[id] = axis.parent_axis == kNone ? 0 : level_of[axis.parent_axis] + 1;
        if (level_of[id] >= levels.segment_count.size())
            levels.segment_count.resize(level_of[id] + 1);
        levels.segment_count[level_of[id]] += axis.segment_count;
    }

    levels.first.assign(levels.count() + 1, 0);
    for (auto const level : level_of)
        ++levels.first[level + 1];
    for (std::size_t i = 1; i < levels.first.size(); ++i)
        levels.first[i] += levels.first[i - 1];
    levels.axes.resize(plant.axes.size());
    auto next = levels.first;
    for (AxisId id = 0; id < plant.axes.size(); ++id)
        levels.axes[next[level_of[id]]++] = id;
    for (std::size_t number = 0; number < levels.count(); ++number)
        std::stable_sort(levels.axes.begin() + std::ptrdiff_t { levels.first[number] },
                         levels.axes.begin() + std::ptrdiff_t { levels.first[number + 1] },
                         [&](AxisId a, AxisId b) {
                             return plant.axes[a].segment_count < plant.axes[b].segment_count;
                         });
    return levels;
}

void for_each_level(AxisLevels const& levels,
                    std::function<void(std::span<AxisId const>)> const& work)
{
    for (std::size_t number = 0; number < levels.count(); ++number) {
        auto const axes = levels.level(number);
        if (levels.segment_count[number] < kSegmentsWorthThreads) {
            work(axes);
            continue;
        }
        auto const segments_per_axis = levels.segment_count[number] / axes.size();
        auto const grain = std::max<std::size_t>(1, kSegmentsWorthThreads / 4 / segments_per_axis);
        parallel_for(axes.size(), grain, [&](std::size_t begin, std::size_t end) {
            work(axes.subspan(begin, end - begin));
        });
    }
}

} // namespace tractus::variation
