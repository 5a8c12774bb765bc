#pragma once

#include "engine/variation/association.h"
#include "engine/variation/rest_shape.h"

#include <vector>

namespace tractus::variation {

// The nodes of `plant` in its predefined shape, plant frame: what is to be seen of a stroke before
// the plant grows, and while it is being drawn. `rest` and `shape` must be of `plant`. Put into
// `nodes_mm`, which is kept for its memory.
void place_nodes(Plant const& plant, RestShape const& rest, PredefinedShape const& shape,
                 std::vector<Vec3>& nodes_mm);

} // namespace tractus::variation
