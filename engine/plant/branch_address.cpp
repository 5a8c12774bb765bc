#include "engine/plant/branch_address.h"

#include "engine/base/check.h"

#include <algorithm>
#include <numeric>

namespace tractus {

std::size_t segment_count(PathAddress const& path)
{
    if (path.first.empty())
        return 0;
    std::size_t count = 0; // Axes from the first's on, whole.
    for (auto i = path.first.size(); i <= path.last.size(); i += 2)
        count += path.last[i - 1] + std::size_t { 1 };
    return count - std::min(count, std::size_t { path.first.back() });
}

AddressIndex::AddressIndex(Plant const& plant)
    : by_parent_(plant.axes.size())
{
    std::iota(by_parent_.begin(), by_parent_.end(), AxisId { 0 });
    std::stable_sort(by_parent_.begin(), by_parent_.end(), [&](AxisId one, AxisId other) {
        return plant.axes[one].parent_segment < plant.axes[other].parent_segment;
    });
}

std::vector<AxisId>::const_iterator AddressIndex::first_on(Plant const& plant,
                                                           SegmentId parent) const
{
    return std::lower_bound(
        by_parent_.begin(), by_parent_.end(), parent,
        [&](AxisId axis, SegmentId segment) { return plant.axes[axis].parent_segment < segment; });
}

SegmentAddress AddressIndex::address_of(Plant const& plant, SegmentId segment) const
{
    SegmentAddress backwards;
    while (segment != kNone) {
        auto const id = axis_of(plant, segment);
        auto const& axis = plant.axes[id];
        auto const first = first_on(plant, axis.parent_segment);
        auto const number
            = std::lower_bound(first, by_parent_.end(), id,
                               [&](AxisId one, AxisId other) {
                                   return plant.axes[one].parent_segment == axis.parent_segment
                                       && one < other;
                               })
            - first;
        backwards.push_back(segment - axis.first_segment);
        backwards.push_back(static_cast<std::uint32_t>(number));
        segment = axis.parent_segment;
    }
    return { backwards.rbegin(), backwards.rend() };
}

PathAddress AddressIndex::address_of(Plant const& plant, std::vector<SegmentId> const& path) const
{
    CHECK(!path.empty());
    return { address_of(plant, path.front()), address_of(plant, path.back()) };
}

std::optional<SegmentId> AddressIndex::find_segment(Plant const& plant,
                                                    SegmentAddress const& address) const
{
    SegmentId segment = kNone;
    for (std::size_t i = 0; i + 1 < address.size(); i += 2) {
        auto const first = first_on(plant, segment);
        if (address[i] >= by_parent_.end() - first)
            return std::nullopt;
        auto const& axis = plant.axes[first[address[i]]];
        if (axis.parent_segment != segment || address[i + 1] >= axis.segment_count)
            return std::nullopt;
        segment = axis.first_segment + address[i + 1];
    }
    return segment == kNone ? std::nullopt : std::optional(segment);
}

std::optional<std::vector<SegmentId>> AddressIndex::find_path(Plant const& plant,
                                                              PathAddress const& address) const
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
