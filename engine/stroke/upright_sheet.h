#pragma once

#include "engine/stroke/stroke.h"

#include <vector>

namespace tractus {

// The surface on which a stroke was drawn, which determines how its coordinates are interpreted.
enum class StrokeSurface {
    Space, // The stroke is kept as drawn in space.
    Paper, // The tablet is an upright sheet: what was drawn away from the user (+y) is up.
    // Chooses Paper if the surface moved by less than a twentieth of the stroke's length on the
    // tablet, and Space otherwise.
    Decided,
};

// Resolves Decided to Space or Paper for these tips; returns the other values unchanged.
StrokeSurface resolve_surface(std::vector<TipSample> const& tips, StrokeSurface wanted);

// Returns the stroke's tips in the plant's frame: millimetres, z up. On paper a height above that
// of pen-down is towards the user: (x, height at pen-down - height, y).
std::vector<Vec3> plant_tips(std::vector<TipSample> const& tips, StrokeSurface surface);

} // namespace tractus
