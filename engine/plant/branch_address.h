#pragma once

#include "engine/plant/plant.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace tractus {

// Where a segment is, said so that it can be found again in a plant that has changed elsewhere: the
// number of its root among those on the ground, how many segments up its axis, the number of the
// lateral axis there, how many segments up that, and so on. Even in length.
using SegmentAddress = std::vector<std::uint32_t>;

// A path by its two ends.
struct PathAddress {
    SegmentAddress first {};
    SegmentAddress last {};

    bool operator==(PathAddress const&) const = default;
};

// How many segments a path has.
std::size_t segment_count(PathAddress const& path);

// The axes of a plant by what bears them: finds segments by their addresses, and addresses of
// segments, in a time that grows with the order of their axes and hardly with the plant.
class AddressIndex {
public:
    AddressIndex() = default; // Index of a plant without axes.

    // `plant` is the one that is asked about afterwards.
    explicit AddressIndex(Plant const& plant);

    SegmentAddress address_of(Plant const& plant, SegmentId segment) const;

    // `path` as in Association, not empty.
    PathAddress address_of(Plant const& plant, std::vector<SegmentId> const& path) const;

    // No value where the plant has nothing at the address.
    std::optional<SegmentId> find_segment(Plant const& plant, SegmentAddress const& address) const;

    // No value where one of its ends is missing, or they are no longer on one way from root to tip.
    std::optional<std::vector<SegmentId>> find_path(Plant const& plant,
                                                    PathAddress const& address) const;

private:
    // The first of the axes that the segment bears, or that stand on the ground for kNone.
    std::vector<AxisId>::const_iterator first_on(Plant const& plant, SegmentId parent) const;

    std::vector<AxisId> by_parent_; // Axes that stand on one segment follow each other, in order.
};

} // namespace tractus
