#pragma once

#include "engine/plant/plant.h"
#include "engine/variation/rest_shape.h"

#include <cstdint>
#include <span>
#include <vector>

namespace tractus::variation {

// A point of a drawn limb. Millimetres at the plant's natural size.
struct LimbPoint {
    // Position relative to the point where the limb joins its parent axis.
    Vec3 place_mm = Vec3::Zero();
    double width_mm = 0; // Diameter of the limb at this point.

    bool operator==(LimbPoint const&) const = default;
};

// The place where a limb is attached to its parent axis.
struct LimbAttachment {
    std::uint32_t order = 0;        // Branching order of the parent axis.
    Vec3 direction = Vec3::UnitZ(); // Direction of the parent axis at this place; unit vector.
    double radius_mm = 0;           // Radius of the parent axis at this place; 0 if unknown.
};

// Returns the axis of `plant` to use as the pattern of a limb of this length that is attached to an
// axis of `order`: the axis whose length differs from the limb's by the smallest factor. Each order
// by which its branching order differs from the limb's counts like a factor of 1.28 in length.
// Trunks are considered only if the plant has no laterals. `rest` is the rest shape of `plant`,
// which must have an axis.
AxisId pattern_for_limb(Plant const& plant, RestShape const& rest, std::uint32_t order,
                        double length_mm);

// Returns a limb along `points`, of which at least two must be distinct. Its twigs and organs are
// like those of an axis of `plant`, the pattern (pattern_for_limb()).
//
// If the first point is off the parent axis, a short curve joins it to the seat. The limb has as
// many nodes with twigs or organs per length as its pattern. Each node carries the twigs and organs
// of the pattern's node at the same share of the length, rotated so that the divergence angles of
// the pattern continue. Twigs and organs take their heading from the limb and keep their pitch: a
// twig that hangs or rises on the pattern does so on the limb, and upper sides stay upper sides.
// The size of twigs is multiplied by the ratio of the limb's length to the pattern's, or by its
// square root if the limb is longer. Organs are scaled likewise, but never enlarged.
//
// The limb is as thick as its points, multiplied by the taper of the pattern, but thinner than its
// parent axis. Over its first tenth it is at least as thick as at the end of that tenth, since a
// pen is pressed down gradually. Twigs are at most as thick as the limb.
//
// The limb's first axis is the limb itself and begins at the origin. The limb has copies of the
// materials, shapes and contours of `plant`, under the same numbers.
Plant make_limb(Plant const& plant, RestShape const& rest, std::span<LimbPoint const> points,
                LimbAttachment const& seat);

} // namespace tractus::variation
