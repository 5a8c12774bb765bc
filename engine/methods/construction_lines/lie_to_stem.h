#pragma once

#include "engine/methods/construction_lines/drawn_line.h"

#include <string>

namespace tractus::lines {

// Position of a stroke relative to the stem, as seen on the sheet.
struct Lie {
    // Signed distances of the stroke's two ends from the stem, positive on the left.
    double first_mm = 0;
    double last_mm = 0;
    int crossings = 0;     // Number of times that the stroke changes sides beside the stem.
    double along = 0;      // Share of the stem beside which the stroke runs.
    double left_share = 0; // Share of the stroke's points on the left.
    // Greatest distance from the stem on the side that has fewer of the stroke's points.
    double min_side_mm = 0;
    double lean_deg = 0; // Angle between the chords of stroke and stem, 0 to 90.
};

// Computes a stroke's position relative to the stem. Both lines must be sampled densely, with
// points at most a few millimetres apart.
Lie lie_of(DrawnLine const& stroke, DrawnLine const& stem);

// Tests for the roles that are possible for a stroke in this position. Several may apply; the
// caller decides.
bool is_inclination(Lie const& lie);
bool is_boundary(Lie const& lie);
// True for a boundary in space, provided that the stroke also leaves the sheet.
bool is_boundary_in_space(Lie const& lie);

// True for half an inclination line; `length` is the stroke's length as a share of the stem's.
bool is_half(Lie const& lie, double length);

// True if the stroke runs along most of the stem.
bool is_along_stem(Lie const& lie);

// Returns one sentence: why a stroke in this position has none of these roles, and what to draw
// instead.
std::string explain_no_role(Lie const& lie);

} // namespace tractus::lines
