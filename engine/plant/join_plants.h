#pragma once

#include "engine/plant/plant.h"

namespace tractus {

// Adds another plant to a plant, moved: its axes, organs, polygons, materials and shapes behind
// those that are there. Both keep their order.
void append_plant(Plant& plant, Plant const& other, Vec3 const& moved_mm);

} // namespace tractus
