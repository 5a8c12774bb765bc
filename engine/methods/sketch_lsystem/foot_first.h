#pragma once

#include "engine/base/vectors.h"
#include "engine/stroke/stroke.h"

#include <optional>
#include <span>

namespace tractus::sketch {

// True if a stroke was drawn from a plant's tip to its foot: the stroke runs down, and its end is
// its lowest point and is on the ground. Tips in the plant's frame (plant_tips()). `ground_mm` is
// the height of the ground in that frame; no value: the stroke's end is taken to be on the ground.
bool is_drawn_to_foot(std::span<Vec3 const> tips_mm, std::optional<double> ground_mm);

// The stroke in reverse: the tips' positions and pressures are in reverse order, while their times
// stay in order.
Stroke turned_round(Stroke const& stroke);

} // namespace tractus::sketch
