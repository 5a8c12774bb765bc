#pragma once

#include "engine/lsystem/view/leaf_sheet.h"
#include "engine/plant/plant.h"

namespace tractus::scene {

// True if organs of this shape are leaves: flat shapes with a leaf's material. Needles, discs and
// balls are not leaves.
bool is_leaf(Plant const& plant, OrganShape const& shape);

// Returns the plant with its leaves replaced by grown leaves of a sheet. The new leaves are chosen
// at random, but reproducibly for the same plant and sheet. Each has the place, fold and curl of
// the leaf that it replaces, and its length, apart from the differences between the sheet's leaves.
// An organ that is a spray of leaves (OrganShape::spray) becomes as many organs as it has leaves.
// Other organs stay unchanged.
Plant foliated(Plant const& plant, lsystem::LeafSheet const& sheet);

} // namespace tractus::scene
