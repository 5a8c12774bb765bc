#pragma once

#include "engine/base/vectors.h"
#include "engine/stroke/stroke.h"

#include <optional>
#include <span>

namespace tractus {

// Functions for strokes that were drawn from the tip of a plant or branch to its foot.

// True if a stroke was drawn from a plant's top to its foot: the stroke runs down, and its end is
// about its lowest point and near the ground. `tips_mm` are the pen's positions in the plant's
// frame (plant_tips()). `ground_mm` is the height of the ground in that frame; no value: the
// stroke's end is taken to be on the ground.
bool is_drawn_to_foot(std::span<Vec3 const> tips_mm, std::optional<double> ground_mm);

// True if a stroke was drawn from the tip of a branch to its foot: the stroke ends at the branch's
// foot and begins far from it, nearer to the branch's tip. All positions are in one frame.
bool is_drawn_to_foot_of(std::span<Vec3 const> tips_mm, Vec3 const& foot_mm, Vec3 const& tip_mm);

// The stroke in reverse: positions and pressures of the pen's tip in reverse order, but times in
// their original order. If the stroke's tips have a source, those of the reverse have one, too.
Stroke turned_round(Stroke const& stroke);

} // namespace tractus
