#pragma once

#include "engine/base/vectors.h"

#include <cstddef>
#include <span>
#include <vector>

namespace tractus::leaf {

// Lines in a plane, as points; each has at least one.
using FlatLine = std::vector<Vec2>;

double length_of(std::span<Vec2 const> line);

// Area on the left of a closed line that runs counter-clockwise; negative the other way round.
double area_of(std::span<Vec2 const> ring);

// Whether a place lies inside a closed line.
bool is_inside(std::span<Vec2 const> ring, Vec2 const& place);

// Share of a closed line's area that lies to the left of the line through two places.
double share_left_of(std::span<Vec2 const> ring, Vec2 const& from, Vec2 const& to);

// Diagonal of the box round a line.
double extent_of(std::span<Vec2 const> line);

// Where a line is nearest to a place.
struct NearestOnLine {
    double distance = 0;
    double along = 0; // In points: 2.5 is halfway from the third to the fourth one.
};
NearestOnLine nearest_on(std::span<Vec2 const> line, Vec2 const& place);

// A line's place at so many points from its begin.
Vec2 place_at(std::span<Vec2 const> line, double along);

// So many places (at least 2) at equal distances along the line, both ends among them.
FlatLine evenly(std::span<Vec2 const> line, std::size_t count);

} // namespace tractus::leaf
