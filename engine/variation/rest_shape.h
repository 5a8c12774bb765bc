#pragma once

#include "engine/plant/plant.h"
#include "engine/plant/plant_addresses.h"
#include "engine/variation/axis_levels.h"

#include <memory>
#include <vector>

namespace tractus::variation {

// The rest shape of a plant: frames and lengths before strokes and growth change it. Computed once
// for a base plant, and used for every stroke and variation.
//
// The frame of a segment is the rotation from +x to its direction and from +y to its normal, plant
// frame (frame_rotation.h). Along an axis the frames are rotation-minimising. At the axis' base the
// normal leans towards the direction of the parent. If the branch continues its parent straight on,
// it leans towards the parent's normal; on a trunk, towards +x. A segment without length has the
// direction of the one before it.
struct RestShape {
    AxisLevels levels;
    std::vector<Quat> frame; // Frame of each segment.
    std::vector<double> length_mm;
    std::vector<double> end_mm;         // Arc length from the axis' base to each segment's end.
    std::vector<double> axis_length_mm; // Arc length of each axis.
    std::vector<AxisId> drawing_order;  // All axes, in the order of axes_in_drawing_order().
    PlantAddresses addresses;           // Addresses of segments, to attach drawn items to them.
};

// The rest shape of an immutable plant, computed on first use, by any thread, since the export of a
// plant does not need it. Copies share one rest shape.
class SharedRestShape {
public:
    SharedRestShape() = default; // The rest shape of a plant without axes.
    explicit SharedRestShape(std::shared_ptr<Plant const> plant, AxisKeys keys = {});
    SharedRestShape(std::shared_ptr<Plant const> plant, PlantAddresses addresses);

    RestShape const& operator*() const;
    RestShape const* operator->() const { return &**this; }

    // True if both are copies that share one rest shape.
    bool operator==(SharedRestShape const&) const = default;

private:
    struct Found;

    std::shared_ptr<Found> found_ {};
};

// Computes the rest shape of a plant; `addresses` are those of the plant.
RestShape find_rest_shape(Plant const& plant, PlantAddresses addresses);

// Computes the rest shape of a plant that is not composed of others; `keys` as for AddressIndex.
RestShape find_rest_shape(Plant const& plant, AxisKeys keys = {});

} // namespace tractus::variation
