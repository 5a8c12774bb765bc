#pragma once

#include "engine/stroke/stroke.h"

#include <vector>

namespace tractus {

// What a stroke was drawn on, and so how it is read.
enum class StrokeSurface {
    Space,   // Keeps the stroke as it was drawn in space.
    Paper,   // The tablet is a sheet that stands upright: what was drawn away from the user is up.
    Decided, // Paper where the surface has hardly moved: by less than a twentieth of the stroke's
             // length on the tablet.
};

// The surface that counts for a stroke; never Decided.
StrokeSurface decide_surface(std::vector<TipSample> const& tips, StrokeSurface wanted);

// The stroke's tips in the plant's frame, millimetres on the desk, z up. On paper the height above
// pen-down is towards the user: (x, height at pen-down - height, y).
std::vector<Vec3> plant_tips(std::vector<TipSample> const& tips, StrokeSurface surface);

} // namespace tractus
