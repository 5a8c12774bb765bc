#pragma once

#include "engine/methods/construction_lines/drawn_line.h"

#include <string>

namespace tractus::lines {

// Position of a stroke relative to the stem, as seen on the sheet.
struct Lie {
    // Signed distance from the stem of the stroke's first point, positive on the left; `last_mm`:
    // of its last point.
    double first_mm = 0;
    double last_mm = 0;
    // Number of times that the stroke changes sides beside the stem, not beyond the stem's ends.
    int crossings = 0;
    double along = 0;      // Share of the stem along which the stroke runs.
    double left_share = 0; // Share of the stroke's points to the left of the stem.
    // Greatest distance of the stroke from the stem on the side with fewer of its points.
    double min_side_mm = 0;
    double lean_deg = 0; // Angle between the chords of stroke and stem, 0 to 90.
};

// Computes a stroke's position relative to the stem. The points of either line must be at most a
// few millimetres apart.
Lie lie_of(DrawnLine const& stroke, DrawnLine const& stem);

// These tests say whether a stroke in this position may have a role. Several may be true; the
// caller decides.
bool is_inclination(Lie const& lie);
bool is_boundary(Lie const& lie);
// True if the stroke may be a boundary in space. The caller must check that it also leaves the
// sheet.
bool is_boundary_in_space(Lie const& lie);

// True if the stroke may be half an inclination line. `length` is the stroke's length as a share of
// the stem's.
bool is_half(Lie const& lie, double length);

// True if the stroke runs along most of the stem.
bool is_along_stem(Lie const& lie);

// Explains in one sentence why a stroke in this position has no role, and what to draw instead.
std::string explain_no_role(Lie const& lie);

} // namespace tractus::lines
