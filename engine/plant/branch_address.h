#pragma once

#include "engine/plant/plant.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace tractus {

// Address of a segment that remains valid when the plant changes elsewhere. Numbers of axes and
// numbers of segments alternate in it: first the number of the root axis among those on the ground
// and the segment on that axis, then the number of the lateral axis at that segment and the segment
// on the lateral, and so on. Its length is even.
//
// An axis with a key (AxisKeys) is found by its key, wherever it is attached. The address then
// begins with kKeyedAxis, the key, 0, and the position on the axis as a share of its length in
// units of 2^-31. The laterals on that axis follow as in other addresses.
using SegmentAddress = std::vector<std::uint32_t>;
constexpr std::uint32_t kKeyedAxis = 0xFFFFFFFF;

// A key for each axis of a plant, by which the axis is recognised when the plant is made again; 0
// for an axis without a key. Empty if no axis has a key. Axes that share a key count as having
// none.
using AxisKeys = std::vector<std::uint32_t>;

// Derives a key from a name that is unique in the plant; never 0.
std::uint32_t axis_key(std::string_view name);

// A path along the plant, as the addresses of its first and last segment.
struct PathAddress {
    SegmentAddress first {};
    SegmentAddress last {};

    bool operator==(PathAddress const&) const = default;
};

// Returns the number of segments of a path, or 0 if the addresses do not show it. That is so on an
// axis with a key, whose segments may have changed, and in a part of a plant (plant_addresses.h).
std::size_t segment_count(PathAddress const& path);

// Returns the segments from `first` up to `last`, or no value if `last` is not a descendant of
// `first`.
std::optional<std::vector<SegmentId>> path_between(Plant const& plant, SegmentId first,
                                                   SegmentId last);

// An index of a plant's axes by parent segment, for converting between segments and addresses. The
// time for a conversion grows with the branching order of the segment, but hardly with the size of
// the plant.
class AddressIndex {
public:
    AddressIndex() = default; // The index of a plant without axes.

    // Indexes `plant`; the same plant must be passed to the other functions.
    explicit AddressIndex(Plant const& plant, AxisKeys keys = {});

    SegmentAddress address_of(Plant const& plant, SegmentId segment) const;

    // `path`: segments from root to tip, each a child of the one before; not empty.
    PathAddress address_of(Plant const& plant, std::vector<SegmentId> const& path) const;

    // Returns no value if the plant has no segment at the address.
    std::optional<SegmentId> find_segment(Plant const& plant, SegmentAddress const& address) const;

private:
    // First axis in by_parent_ that is attached to `parent`; for kNone, first axis on the ground.
    std::vector<AxisId>::const_iterator first_on(Plant const& plant, SegmentId parent) const;

    // Key of the axis, or 0 if it has none.
    std::uint32_t key_of(AxisId axis) const { return keys_.empty() ? 0 : keys_[axis]; }
    std::optional<SegmentId> find_on_keyed(Plant const& plant, SegmentAddress const& address) const;
    SegmentAddress address_at(Plant const& plant, SegmentId segment, double share) const;

    std::vector<AxisId> by_parent_; // All axes by parent segment, then in the plant's order.
    AxisKeys keys_;
    std::vector<std::pair<std::uint32_t, AxisId>> by_key_; // Keys and their axes, sorted by key.
};

} // namespace tractus
