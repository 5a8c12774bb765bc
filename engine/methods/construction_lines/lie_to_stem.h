#pragma once

#include "engine/methods/construction_lines/drawn_line.h"

#include <string>

namespace tractus::lines {

// How a stroke of a sketch lies to the stem, seen on the sheet.
struct Lie {
    double first_mm = 0; // Its ends' distances, above 0 on the left.
    double last_mm = 0;
    int crossings = 0;        // Changes from side to side beside the stem.
    double along = 0;         // How much of the stem its points stand beside.
    double left_share = 0;    // Of its points.
    double least_side_mm = 0; // How far it gets on the side where less of it lies.
    double lean_deg = 0;      // Between its ends' chord and the stem's, 0 to 90.
};

// Both lines with points all along them, no more than a few millimetres apart.
Lie lie_of(DrawnLine const& stroke, DrawnLine const& stem);

// What a stroke that lies so may be. More than one may hold: the caller decides which counts.
bool is_inclination(Lie const& lie);
bool is_boundary(Lie const& lie);
bool is_boundary_in_space(Lie const& lie); // If it leaves the sheet, too.

// Half an inclination line; `length` is the stroke's, as a share of the stem's.
bool is_half(Lie const& lie, double length);

// Whether it goes along most of the stem.
bool is_along_stem(Lie const& lie);

// One sentence: why a stroke that lies so is none of these, and what to draw instead.
std::string reason_for(Lie const& lie);

} // namespace tractus::lines
