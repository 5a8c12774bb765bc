#pragma once

#include "engine/variation/association.h"
#include "engine/variation/rest_shape.h"

#include <vector>

namespace tractus::variation {

// Computes the node positions of `plant` in its predefined shape, plant frame. They are the preview
// of a stroke before the plant grows. `rest` and `shape` must belong to `plant`. Reuses the memory
// of `nodes_mm`.
void place_nodes(Plant const& plant, RestShape const& rest, PredefinedShape const& shape,
                 std::vector<Vec3>& nodes_mm);

} // namespace tractus::variation
