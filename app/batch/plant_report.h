#pragma once

#include "engine/plant/plant.h"

#include <string>

namespace tractus::batch {

// Measurements of a plant (tree_measures.h) as one line of JSON: lengths in metres, the diameter in
// millimetres.
std::string print_plant_report(Plant const& plant);

} // namespace tractus::batch
