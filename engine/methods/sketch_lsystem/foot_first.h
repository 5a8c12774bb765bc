#pragma once

#include "engine/base/vectors.h"
#include "engine/stroke/stroke.h"

#include <optional>
#include <span>

namespace tractus::sketch {

// True if a stroke was drawn from a plant's tip to its foot: it runs down, its lowest point is its
// end, and that is on the ground. Tips in the plant's frame (plant_tips()). `ground_mm` is the
// height of the ground in that frame; no value: the stroke's end is on the ground, wherever it is.
bool is_drawn_to_foot(std::span<Vec3 const> tips_mm, std::optional<double> ground_mm);

// The stroke in reverse: the places and pressures of the tips in reverse order, at the times of the
// tips as drawn.
Stroke turned_round(Stroke const& stroke);

} // namespace tractus::sketch
