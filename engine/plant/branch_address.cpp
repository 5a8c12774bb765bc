#include "engine/plant/branch_address.h"

#include "engine/base/check.h"

#include <algorithm>

namespace tractus {

// The number of axis `id` among those that stand on the same segment, or on the ground. All of them
// come after their parent.
static std::uint32_t number_among_siblings(Plant const& plant, AxisId id)
{
    auto const parent = plant.axes[id].parent_axis;
    std::uint32_t number = 0;
    for (AxisId other = parent == kNone ? 0 : parent + 1; other < id; ++other)
        number += plant.axes[other].parent_segment == plant.axes[id].parent_segment;
    return number;
}

SegmentAddress address_of(Plant const& plant, SegmentId segment)
{
    SegmentAddress backwards;
    while (segment != kNone) {
        auto const id = axis_of(plant, segment);
        backwards.push_back(segment - plant.axes[id].first_segment);
        backwards.push_back(number_among_siblings(plant, id));
        segment = plant.axes[id].parent_segment;
    }
    return { backwards.rbegin(), backwards.rend() };
}

std::optional<SegmentId> find_segment(Plant const& plant, SegmentAddress const& address)
{
    SegmentId segment = kNone;
    for (std::size_t i = 0; i + 1 < address.size(); i += 2) {
        auto left = address[i];
        auto const found
            = std::find_if(plant.axes.begin(), plant.axes.end(), [&](Axis const& axis) {
                  return axis.parent_segment == segment && left-- == 0;
              });
        if (found == plant.axes.end() || address[i + 1] >= found->segment_count)
            return std::nullopt;
        segment = found->first_segment + address[i + 1];
    }
    return segment == kNone ? std::nullopt : std::optional(segment);
}

PathAddress address_of(Plant const& plant, std::vector<SegmentId> const& path)
{
    CHECK(!path.empty());
    return { address_of(plant, path.front()), address_of(plant, path.back()) };
}

std::optional<std::vector<SegmentId>> find_path(Plant const& plant, PathAddress const& address)
{
    auto const first = find_segment(plant, address.first);
    auto const last = find_segment(plant, address.last);
    if (!first || !last)
        return std::nullopt;
    std::vector<SegmentId> path { *last };
    while (path.back() != *first) {
        auto const below = parent_segment(plant, path.back());
        if (below == kNone)
            return std::nullopt;
        path.push_back(below);
    }
    std::reverse(path.begin(), path.end());
    return path;
}

} // namespace tractus
