#pragma once

#include "engine/base/vectors.h"

#include <span>
#include <vector>

namespace tractus::leaf {

// A closed line of points with the leaf on its left, y upwards: counter-clockwise around a part of
// the leaf, clockwise around a hole.
using Contour = std::vector<Vec2>;

// Signed area within a contour, positive if it is counter-clockwise.
double contour_area(Contour const& contour);

// Traces where a square picture's alpha (0 to 1, rows from the top) passes `level`, by marching
// squares: pixel values are those of pixel centres, and points are interpolated between them. The
// points are in pixels from the picture's lower left corner. Contours of less than `min_area`
// square pixels are left out.
std::vector<Contour> trace_contours(std::span<float const> alpha, int side, double level,
                                    double min_area);

// Leaves out points of a contour that are within `tolerance` of the line between those that stay
// (Douglas, Peucker 1973).
Contour thinned(Contour const& contour, double tolerance);

// Leaves out points and sides of a contour so that the leaf's side only grows: inner corners are
// bridged, and outer sides replaced by the intersection of their neighbours. Steps that add least
// area come first, up to `area` in total; a single step adds at most `step_area`. Steps that would
// make the contour cross itself or leave the square from 0 to `side` are left out.
void grow_simpler(Contour& contour, double area, double step_area, double side);

} // namespace tractus::leaf
