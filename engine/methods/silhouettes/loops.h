#pragma once

#include "engine/methods/silhouettes/plane.h"

#include <span>
#include <vector>

namespace tractus::silhouette {

bool crosses_itself(std::span<Vec2 const> outline);

// An outline that crosses itself, cut at its crossings: the loop of the largest area, and what all
// loops have together. Of one that does not cross itself: itself. Empty if nothing has an area.
struct LargestLoop {
    std::vector<Vec2> outline;
    double area = 0;
    double area_of_all = 0;
};
LargestLoop largest_loop(std::vector<Vec2> const& outline);

// A stroke whose first and last quarter cross each other, without what sticks out there.
std::vector<Vec2> without_overshoot(std::vector<Vec2> const& stroke);

} // namespace tractus::silhouette
