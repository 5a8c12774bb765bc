#pragma once

#include "engine/stroke/stroke.h"

#include <vector>

namespace tractus {

// The surface on which a stroke was drawn, which determines how its coordinates are interpreted.
enum class StrokeSurface {
    Space, // The stroke is kept as drawn in space.
    Paper, // The tablet is an upright sheet: away from the user (+y) on the tablet is up.
    // Means Paper if the surface moved by less than a twentieth of the stroke's length on the
    // tablet, otherwise Space.
    Decided,
};

// Returns Space or Paper for Decided, depending on the tips; returns the other values unchanged.
StrokeSurface resolve_surface(std::vector<TipSample> const& tips, StrokeSurface wanted);

// Returns the stroke's tips in the plant's frame: millimetres, z up. On paper, a tip above the
// height at pen-down lies towards the user: its position is (x, height at pen-down - height, y).
std::vector<Vec3> plant_tips(std::vector<TipSample> const& tips, StrokeSurface surface);

} // namespace tractus
