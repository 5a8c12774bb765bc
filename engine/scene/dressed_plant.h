#pragma once

#include "engine/lsystem/view/leaf_sheet.h"
#include "engine/plant/plant.h"

namespace tractus::scene {

// Whether organs of that shape are leaves: flat ones of a leaf's material. Needles, discs and balls
// are none.
bool is_leaf(Plant const& plant, OrganShape const& shape);

// The plant with the grown leaves of a sheet in the place of its own, by chance one of them for
// each; the same plant and sheet give the same ones. A leaf's blade is as long as the one that it
// stands for, and folds and bends as that does. All other organs stay, and so does the plant where
// it has no leaves.
Plant dressed(Plant const& plant, lsystem::LeafSheet const& sheet);

} // namespace tractus::scene
