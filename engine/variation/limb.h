#pragma once

#include "engine/plant/plant.h"
#include "engine/variation/rest_shape.h"

#include <cstdint>
#include <span>
#include <vector>

namespace tractus::variation {

// A point of a drawn limb. Millimetres at the plant's natural size.
struct LimbPoint {
    Vec3 place_mm = Vec3::Zero(); // Relative to the place where the limb is joined to its bearer.
    double width_mm = 0;          // The limb's diameter there.

    bool operator==(LimbPoint const&) const = default;
};

// The place where a limb is joined to its bearer.
struct LimbAttachment {
    std::uint32_t order = 0;        // Branching order of the bearer.
    Vec3 direction = Vec3::UnitZ(); // Direction of the bearer there; unit vector.
    double radius_mm = 0;           // Radius of the bearer there; 0 if it is not known.
};

// Returns the axis of `plant` that a limb of this length on an axis of `order` is modelled on: the
// one whose length is nearest by its ratio. Each order more or less than the limb has counts like a
// length that differs by a factor of 1.28. A trunk is considered only if the plant has no branches.
// `rest` is the rest shape of `plant`, which has an axis.
AxisId pattern_for_limb(Plant const& plant, RestShape const& rest, std::uint32_t order,
                        double length_mm);

// Returns a limb along `points`, of which at least two are distinct, with twigs and organs like
// those of an axis of `plant`, its pattern (pattern_for_limb()).
//
// If the first point is off the bearer a short curve joins it to the seat. The limb has as many
// nodes per length as its pattern, and a node bears what the pattern's node at the same share of
// the length bears, turned so that the divergence angles of the pattern continue. Twigs and organs
// take their heading from the limb and keep their pitch: what hangs or rises on the pattern does so
// on the limb, and upper sides stay upper sides. Twigs are scaled by the
// ratio of the lengths, by its square root if the limb is longer; organs likewise, but they are
// never enlarged.
//
// The limb is as thick as its points, multiplied by the taper of the pattern, but thinner than its
// bearer. Over its first tenth it is at least as thick as at the end of that, since a pen is
// pressed down gradually. Twigs are at most as thick as the limb.
//
// The limb's first axis is the limb itself and begins at the origin. Numbers of materials, shapes
// and contours are those in `plant`; the limb has copies of them.
Plant make_limb(Plant const& plant, RestShape const& rest, std::span<LimbPoint const> points,
                LimbAttachment const& seat);

} // namespace tractus::variation
