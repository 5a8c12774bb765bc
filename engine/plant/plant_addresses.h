#pragma once

#include "engine/plant/branch_address.h"
#include "engine/plant/plant.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace tractus {

// Prefix of the addresses in a part of a plant; the part was a separate plant before it was added.
// The prefix has four numbers for each level of nesting, outermost first, and is followed by the
// address within the part. It is empty in the original plant, to which the parts were added.
using PartPrefix = SegmentAddress;
constexpr std::uint32_t kPartOfPlant = 0xFFFFFFFE;

// Returns the prefix of the part with the number `id`, which is unique within the plant.
PartPrefix part_prefix(std::uint64_t id);

// Returns the id of the outermost part that contains the address, or 0 if no part contains it.
std::uint64_t part_of(SegmentAddress const& address);

// Puts `prefix` before the address.
SegmentAddress in_part(PartPrefix const& prefix, SegmentAddress const& address);
PathAddress in_part(PartPrefix const& prefix, PathAddress const& address);

// True if the address is in the part with this prefix, or in a part nested in it.
bool is_in_part(PartPrefix const& prefix, SegmentAddress const& address);

// Removes the prefix; the address must begin with it.
SegmentAddress without_part(PartPrefix const& prefix, SegmentAddress const& address);
PathAddress without_part(PartPrefix const& prefix, PathAddress const& address);

// One of the plants from which a plant was composed.
struct PlantPart {
    PartPrefix prefix {};
    // The part, including the branches that are hidden in the whole plant.
    std::shared_ptr<Plant const> plant {};
    AddressIndex index {};
    // For each segment of the part, its number in the whole plant, or kNone if it is hidden. The
    // numbers ascend without gaps, and follow those of the preceding parts.
    std::vector<SegmentId> in_whole {};
};

// Addresses in a plant that may be composed of several. The address of a segment is its address
// within its own part, so it is unaffected when other parts are added or removed, or branches are
// hidden or shown.
class PlantAddresses {
public:
    PlantAddresses() = default; // Addresses of a plant without axes.

    // Addresses of a plant that is not composed of others. The same plant must be passed to the
    // other functions.
    explicit PlantAddresses(Plant const& plant, AxisKeys keys = {})
        : whole_(plant, std::move(keys))
    {
    }

    // Addresses of a composed plant. `parts`: at least one; the original plant comes first.
    explicit PlantAddresses(std::vector<PlantPart> parts);

    SegmentAddress address_of(Plant const& plant, SegmentId segment) const;

    // `path`: segments from root to tip, each a child of the one before; not empty.
    PathAddress address_of(Plant const& plant, std::vector<SegmentId> const& path) const;

    // Returns no value if there is no segment at the address, or it is hidden.
    std::optional<SegmentId> find_segment(Plant const& plant, SegmentAddress const& address) const;

    // Returns no value if the first or the last segment is missing, or if the last one no longer
    // descends from the first.
    std::optional<std::vector<SegmentId>> find_path(Plant const& plant,
                                                    PathAddress const& address) const;

    // The index of a plant that is not composed.
    AddressIndex const& index() const { return whole_; }

private:
    struct ShownPart : PlantPart {
        SegmentId first = 0; // First segment of the whole plant that belongs to this part.
        // For each visible segment of the part, which is segment `first`, `first` + 1, ... of the
        // whole plant, its number within the part.
        std::vector<SegmentId> own {};
    };

    // Returns the part that contains a segment of the whole plant, and the segment's number in the
    // part.
    std::pair<PlantPart const*, SegmentId> part_with(SegmentId segment) const;

    AddressIndex whole_; // Used if there are no parts.
    std::vector<ShownPart> parts_;
};

} // namespace tractus
