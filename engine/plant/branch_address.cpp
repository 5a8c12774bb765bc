#include "engine/plant/branch_address.h"

#include "engine/base/check.h"
#include "engine/base/fnv.h"

#include <algorithm>
#include <numeric>

namespace tractus {

static constexpr double kWholeShare = 0x80000000u;

static bool is_keyed(SegmentAddress const& address)
{
    return address.size() >= 4 && address.front() == kKeyedAxis;
}

std::uint32_t axis_key(std::string_view name)
{
    auto const hash = fnv1a_32(name);
    return hash == 0 ? 1 : hash;
}

std::size_t segment_count(PathAddress const& path)
{
    // An address that begins with this number or a higher one has the key of an axis or the prefix
    // of a part.
    constexpr std::uint32_t kMinName = 0xFFFFFFFE;
    if (path.first.empty() || path.first.front() >= kMinName || path.last.empty()
        || path.last.front() >= kMinName)
        return 0;
    // Number of segments on the way from the base of the first segment's axis to the last segment.
    std::size_t count = 0;
    for (auto i = path.first.size(); i <= path.last.size(); i += 2)
        count += path.last[i - 1] + std::size_t { 1 };
    return count - std::min(count, std::size_t { path.first.back() });
}

AddressIndex::AddressIndex(Plant const& plant, AxisKeys keys)
    : by_parent_(plant.axes.size())
    , keys_(std::move(keys))
{
    CHECK(keys_.empty() || keys_.size() == plant.axes.size());
    std::iota(by_parent_.begin(), by_parent_.end(), AxisId { 0 });
    std::stable_sort(by_parent_.begin(), by_parent_.end(), [&](AxisId one, AxisId other) {
        return plant.axes[one].parent_segment < plant.axes[other].parent_segment;
    });
    for (AxisId axis = 0; axis < keys_.size(); ++axis)
        if (keys_[axis] != 0)
            by_key_.emplace_back(keys_[axis], axis);
    std::sort(by_key_.begin(), by_key_.end());
    for (std::size_t i = 1; i < by_key_.size(); ++i)
        if (by_key_[i].first == by_key_[i - 1].first)
            keys_[by_key_[i].second] = keys_[by_key_[i - 1].second] = 0;
    std::erase_if(by_key_, [&](auto const& entry) { return keys_[entry.second] == 0; });
}

std::vector<AxisId>::const_iterator AddressIndex::first_on(Plant const& plant,
                                                           SegmentId parent) const
{
    return std::lower_bound(
        by_parent_.begin(), by_parent_.end(), parent,
        [&](AxisId axis, SegmentId segment) { return plant.axes[axis].parent_segment < segment; });
}

// Returns the address of a segment. `share`: position on the segment, 0 to 1, used if its axis has
// a key.
SegmentAddress AddressIndex::address_at(Plant const& plant, SegmentId segment, double share) const
{
    SegmentAddress backwards;
    while (segment != kNone) {
        auto const id = axis_of(plant, segment);
        auto const& axis = plant.axes[id];
        if (auto const key = key_of(id); key != 0) {
            double to_mm = 0;
            double own_mm = 0;
            auto const places_mm = plant.positions(axis);
            for (SegmentId i = 0; i <= segment - axis.first_segment; ++i) {
                to_mm += own_mm;
                own_mm = (places_mm[i + 1] - places_mm[i]).norm();
            }
            double const whole_mm = std::max(axis_length_mm(plant, axis), 1e-300);
            double const at = std::clamp((to_mm + share * own_mm) / whole_mm, 0.0, 1.0);
            backwards.push_back(static_cast<std::uint32_t>(at * kWholeShare));
            backwards.push_back(0);
            backwards.push_back(key);
            backwards.push_back(kKeyedAxis);
            break;
        }
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
        share = 0.5;
    }
    return { backwards.rbegin(), backwards.rend() };
}

SegmentAddress AddressIndex::address_of(Plant const& plant, SegmentId segment) const
{
    return address_at(plant, segment, 0.5);
}

// On axes with keys, the address gives positions slightly inside both ends of the path. So a path
// over a whole axis still covers it after the axis has been divided into other segments.
PathAddress AddressIndex::address_of(Plant const& plant, std::vector<SegmentId> const& path) const
{
    CHECK(!path.empty());
    constexpr double kInside = 0.01;
    return { address_at(plant, path.front(), kInside),
             address_at(plant, path.back(), 1 - kInside) };
}

std::optional<SegmentId> AddressIndex::find_on_keyed(Plant const& plant,
                                                     SegmentAddress const& address) const
{
    auto const found
        = std::lower_bound(by_key_.begin(), by_key_.end(), std::pair(address[1], AxisId { 0 }));
    if (found == by_key_.end() || found->first != address[1])
        return std::nullopt;
    auto const& axis = plant.axes[found->second];
    double to_go_mm = address[3] / kWholeShare * axis_length_mm(plant, axis);
    auto const places_mm = plant.positions(axis);
    for (std::uint32_t i = 0; i + 1 < axis.segment_count; ++i) {
        to_go_mm -= (places_mm[i + 1] - places_mm[i]).norm();
        if (to_go_mm < 0)
            return axis.first_segment + i;
    }
    return axis.first_segment + axis.segment_count - 1;
}

std::optional<SegmentId> AddressIndex::find_segment(Plant const& plant,
                                                    SegmentAddress const& address) const
{
    SegmentId segment = kNone;
    std::size_t i = 0;
    if (is_keyed(address)) {
        auto const on_axis = find_on_keyed(plant, address);
        if (!on_axis)
            return std::nullopt;
        segment = *on_axis;
        i = 4;
    }
    for (; i + 1 < address.size(); i += 2) {
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

std::optional<std::vector<SegmentId>> path_between(Plant const& plant, SegmentId first,
                                                   SegmentId last)
{
    std::vector<SegmentId> path { last };
    while (path.back() != first) {
        auto const below = parent_segment(plant, path.back());
        if (below == kNone)
            return std::nullopt;
        path.push_back(below);
    }
    std::reverse(path.begin(), path.end());
    return path;
}

} // namespace tractus
