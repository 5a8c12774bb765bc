#pragma once

#include "engine/plant/plant.h"
#include "engine/variation/rest_shape.h"

#include <cstdint>
#include <span>
#include <vector>

namespace tractus::variation {

// A point of a drawn limb. Millimetres at the plant's natural size.
struct LimbPoint {
    Vec3 place_mm = Vec3::Zero(); // Relative to the point where the limb joins its parent axis.
    double width_mm = 0;          // Diameter of the limb at this point.

    bool operator==(LimbPoint const&) const = default;
};

// The place where a limb is attached to its parent axis.
struct LimbAttachment {
    std::uint32_t order = 0;        // Branching order of the parent axis.
    Vec3 direction = Vec3::UnitZ(); // Direction of the parent axis at this place; unit vector.
    double radius_mm = 0;           // Radius of the parent axis at this place; 0 if unknown.
};

// Returns the axis of `plant` on which a limb of this length, attached to an axis of `order`, is
// modelled: the one whose length is nearest, compared by ratio. Each order of difference from the
// limb's counts like a factor of 1.28 in length. A trunk is considered only if the plant has no
// branches.
// `rest` is the rest shape of `plant`, which has an axis.
AxisId pattern_for_limb(Plant const& plant, RestShape const& rest, std::uint32_t order,
                        double length_mm);

// Returns a limb along `points`, of which at least two are distinct, with twigs and organs like
// those of an axis of `plant`, its pattern (pattern_for_limb()).
//
// If the first point is off the parent axis a short curve joins it to the seat. The limb has as
// many nodes per length as its pattern. Each node carries the twigs and organs of the pattern's
// node at the same share of the length, rotated so that the divergence angles of the pattern
// continue. Twigs and organs take their heading from the limb and keep their pitch: what hangs or
// rises on the pattern does so on the limb, and upper sides stay upper sides. Twigs are scaled by
// the ratio of the lengths, by its square root if the limb is longer; organs likewise, but they are
// never enlarged.
//
// The limb is as thick as its points, multiplied by the taper of the pattern, but thinner than its
// parent axis. Over its first tenth it is at least as thick as at the end of that tenth, since a
// pen is pressed down gradually. Twigs are at most as thick as the limb.
//
// The limb's first axis is the limb itself and begins at the origin. Numbers of materials, shapes
// and contours are those in `plant`; the limb has copies of them.
Plant make_limb(Plant const& plant, RestShape const& rest, std::span<LimbPoint const> points,
                LimbAttachment const& seat);

} // namespace tractus::variation
