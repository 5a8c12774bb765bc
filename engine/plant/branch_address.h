#pragma once

#include "engine/plant/plant.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace tractus {

// Where a segment is, said so that it can be found again in a plant that has changed elsewhere: the
// number of its root among those on the ground, how many segments up its axis, the number of the
// lateral axis there, how many segments up that, and so on. Even in length.
using SegmentAddress = std::vector<std::uint32_t>;

SegmentAddress address_of(Plant const& plant, SegmentId segment);

// No value where the plant has nothing at the address.
std::optional<SegmentId> find_segment(Plant const& plant, SegmentAddress const& address);

// A path by its two ends.
struct PathAddress {
    SegmentAddress first {};
    SegmentAddress last {};
};

// `path` as in Association, not empty.
PathAddress address_of(Plant const& plant, std::vector<SegmentId> const& path);

// No value where one of its ends is missing, or they are no longer on one way from root to tip.
std::optional<std::vector<SegmentId>> find_path(Plant const& plant, PathAddress const& address);

} // namespace tractus
