#pragma once

#include "engine/plant/plant.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace tractus {

// Where a segment is, said so that it can be found again in a plant that has changed elsewhere: the
// number of its root among those on the ground, how many segments up its axis, the number of the
// lateral axis there, how many segments up that, and so on. Even in length.
//
// An axis that has a key (AxisKeys) is found by that alone, wherever it stands now: the address
// begins with kKeyedAxis, the key, 0, and the place on it as a share of its length, where 2^31 is
// the whole. What follows is as above.
using SegmentAddress = std::vector<std::uint32_t>;
constexpr std::uint32_t kKeyedAxis = 0xFFFFFFFF;

// What the source of a plant calls its axes, one for each axis of it or none at all; 0: it has no
// name for that axis. Axes with the same key count as nameless.
using AxisKeys = std::vector<std::uint32_t>;

// A key from a name that is unique in the plant; never 0.
std::uint32_t axis_key(std::string_view name);

// A path by its two ends.
struct PathAddress {
    SegmentAddress first {};
    SegmentAddress last {};

    bool operator==(PathAddress const&) const = default;
};

// How many segments a path has; 0 if it is on an axis that has a key, whose segments may be others
// now, or in a part of a plant (plant_addresses.h).
std::size_t segment_count(PathAddress const& path);

// The segments from one to another that it bears; no value where it does not bear it.
std::optional<std::vector<SegmentId>> path_between(Plant const& plant, SegmentId first,
                                                   SegmentId last);

// The axes of a plant by what bears them: finds segments by their addresses, and addresses of
// segments, in a time that grows with the order of their axes and hardly with the plant.
class AddressIndex {
public:
    AddressIndex() = default; // Index of a plant without axes.

    // `plant` is the one that is asked about afterwards.
    explicit AddressIndex(Plant const& plant, AxisKeys keys = {});

    SegmentAddress address_of(Plant const& plant, SegmentId segment) const;

    // `path` as in Association, not empty.
    PathAddress address_of(Plant const& plant, std::vector<SegmentId> const& path) const;

    // No value where the plant has nothing at the address.
    std::optional<SegmentId> find_segment(Plant const& plant, SegmentAddress const& address) const;

private:
    // The first of the axes that the segment bears, or that stand on the ground for kNone.
    std::vector<AxisId>::const_iterator first_on(Plant const& plant, SegmentId parent) const;

    // 0 for an axis without a key.
    std::uint32_t key_of(AxisId axis) const { return keys_.empty() ? 0 : keys_[axis]; }
    std::optional<SegmentId> find_on_keyed(Plant const& plant, SegmentAddress const& address) const;
    SegmentAddress address_at(Plant const& plant, SegmentId segment, double share) const;

    std::vector<AxisId> by_parent_; // Axes that stand on one segment follow each other, in order.
    AxisKeys keys_;
    std::vector<std::pair<std::uint32_t, AxisId>> by_key_; // In order.
};

} // namespace tractus
