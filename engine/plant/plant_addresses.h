#pragma once

#include "engine/plant/branch_address.h"
#include "engine/plant/plant.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace tractus {

// What addresses begin with in a part of a plant that once was a plant of its own: four numbers for
// each plant that it is a part of, the outermost first. Behind it stands the address in that plant.
// Empty for what the whole grew from.
using PartPrefix = SegmentAddress;
constexpr std::uint32_t kPartOfPlant = 0xFFFFFFFE;

// `id` is the part's name, which no other part of the same plant has.
PartPrefix part_prefix(std::uint64_t id);

// The id of the outermost part; 0 for an address in none.
std::uint64_t part_of(SegmentAddress const& address);

// `prefix` before the address.
SegmentAddress in_part(PartPrefix const& prefix, SegmentAddress const& address);
PathAddress in_part(PartPrefix const& prefix, PathAddress const& address);

// Whether the address is in the part, or in a part of it.
bool is_in_part(PartPrefix const& prefix, SegmentAddress const& address);

// The address without the prefix with which it begins.
SegmentAddress without_part(PartPrefix const& prefix, SegmentAddress const& address);
PathAddress without_part(PartPrefix const& prefix, PathAddress const& address);

// One of the plants that a plant was put together from.
struct PlantPart {
    PartPrefix prefix {};
    std::shared_ptr<Plant const> plant {}; // With what is hidden of it in the whole.
    AddressIndex index {};
    // What each of its segments is in the whole; kNone: hidden. In the whole they stand together
    // and in this order, behind those of the parts before.
    std::vector<SegmentId> in_whole {};
};

// Addresses in a plant that may have been put together from several: each segment's address is the
// one that it has in its own part, so addresses stay what they are while other parts come and go
// and branches are hidden and shown.
class PlantAddresses {
public:
    PlantAddresses() = default; // Of a plant without axes.

    // Of one that was not put together; the plant is the one that is asked about afterwards.
    explicit PlantAddresses(Plant const& plant, AxisKeys keys = {})
        : whole_(plant, std::move(keys))
    {
    }

    // Of one that was, at least from one. What it grew from comes first.
    explicit PlantAddresses(std::vector<PlantPart> parts);

    SegmentAddress address_of(Plant const& plant, SegmentId segment) const;

    // `path` as in Association, not empty.
    PathAddress address_of(Plant const& plant, std::vector<SegmentId> const& path) const;

    // No value where the plant has nothing at the address, or has it hidden.
    std::optional<SegmentId> find_segment(Plant const& plant, SegmentAddress const& address) const;

    // No value where one of its ends is missing, or they are no longer on one way from root to tip.
    std::optional<std::vector<SegmentId>> find_path(Plant const& plant,
                                                    PathAddress const& address) const;

    // The index of what a plant that was not put together is.
    AddressIndex const& index() const { return whole_; }

private:
    struct ShownPart : PlantPart {
        SegmentId first = 0;           // Of the whole: the first that is of this part.
        std::vector<SegmentId> own {}; // Its number in the part, and those of all behind it.
    };

    // The part that a segment of the whole belongs to, and its number there.
    std::pair<PlantPart const*, SegmentId> part_with(SegmentId segment) const;

    AddressIndex whole_; // Without parts.
    std::vector<ShownPart> parts_;
};

} // namespace tractus
