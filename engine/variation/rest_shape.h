#pragma once

#include "engine/plant/plant.h"
#include "engine/plant/plant_addresses.h"
#include "engine/variation/axis_levels.h"

#include <memory>
#include <vector>

namespace tractus::variation {

// The shape of a plant from which strokes and growth start: found once for a base plant, and then
// used for every stroke and every variation.
//
// The frame of a segment is a rotation that takes +x to its direction and +y to its normal, plant
// frame (frame_rotation.h). Along an axis the frames turn no more than the segments do. At the
// axis' base the normal leans towards the direction of what bears it; for the trunk, and for a
// branch that goes straight on, towards +x and the parent's normal. A segment without length points
// as the one before it.
struct RestShape {
    AxisLevels levels;
    std::vector<Quat> frame; // Per segment, as the next one.
    std::vector<double> length_mm;
    std::vector<double> end_mm;         // Length from the axis' base along it to the segment's end.
    std::vector<double> axis_length_mm; // Per axis, along its segments.
    std::vector<AxisId> drawing_order;  // See axes_in_drawing_order().
    PlantAddresses addresses;           // Addresses of what was drawn.
};

// The rest shape of a plant that nobody changes, found when it is first asked for, by any thread:
// who only writes a plant to a file does without. Copies share it.
class SharedRestShape {
public:
    SharedRestShape() = default; // Of a plant without axes.
    explicit SharedRestShape(std::shared_ptr<Plant const> plant, AxisKeys keys = {});
    SharedRestShape(std::shared_ptr<Plant const> plant, PlantAddresses addresses);

    RestShape const& operator*() const;
    RestShape const* operator->() const { return &**this; }

    // Whether the two are one.
    bool operator==(SharedRestShape const&) const = default;

private:
    struct Found;

    std::shared_ptr<Found> found_ {};
};

// `addresses` are the plant's.
RestShape find_rest_shape(Plant const& plant, PlantAddresses addresses);

// Of a plant that was not put together from others; `keys` as of AddressIndex.
RestShape find_rest_shape(Plant const& plant, AxisKeys keys = {});

} // namespace tractus::variation
