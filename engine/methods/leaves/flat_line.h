#pragma once

#include "engine/base/vectors.h"

#include <cstddef>
#include <span>
#include <vector>

namespace tractus::leaf {

// A polyline in a plane, of at least one point.
using FlatLine = std::vector<Vec2>;

double length_of(std::span<Vec2 const> line);

// Signed area of a closed polyline, positive if it is counter-clockwise.
double area_of(std::span<Vec2 const> ring);

// True if the point is inside a closed polyline.
bool is_inside(std::span<Vec2 const> ring, Vec2 const& place);

// Share of a closed polyline's area that lies to the left of the line through two points.
double area_share_left_of(std::span<Vec2 const> ring, Vec2 const& from, Vec2 const& to);

// Diagonal of a polyline's bounding box.
double extent_of(std::span<Vec2 const> line);

// The place on a polyline that is nearest to a given point, and its distance from that point.
struct NearestOnLine {
    double distance = 0;
    // Position on the polyline as an index: 2.5 is half-way between the third and the fourth point.
    double along = 0;
};
NearestOnLine nearest_on(std::span<Vec2 const> line, Vec2 const& place);

// The point of a polyline at a fractional index.
Vec2 place_at(std::span<Vec2 const> line, double along);

// Returns `count` (at least 2) evenly spaced points along the polyline, both ends included.
FlatLine evenly(std::span<Vec2 const> line, std::size_t count);

} // namespace tractus::leaf
