#pragma once

#include "engine/base/vectors.h"
#include "engine/stroke/stroke.h"

#include <optional>
#include <span>

namespace tractus::sketch {

// True if a stroke was drawn from a plant's top to its foot: the stroke runs down, and its end is
// about its lowest point and near the ground. `tips_mm` are the pen's positions in the plant's
// frame (plant_tips()). `ground_mm` is the height of the ground in that frame; no value: the
// stroke's end is taken to be on the ground.
bool is_drawn_to_foot(std::span<Vec3 const> tips_mm, std::optional<double> ground_mm);

// The stroke in reverse: positions and pressures of the pen's tip in reverse order, but times in
// their original order.
Stroke turned_round(Stroke const& stroke);

} // namespace tractus::sketch
