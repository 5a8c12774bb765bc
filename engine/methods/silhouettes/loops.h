#pragma once

#include "engine/methods/silhouettes/plane.h"

#include <span>
#include <vector>

namespace tractus::silhouette {

bool crosses_itself(std::span<Vec2 const> outline);

// Result of cutting a self-intersecting outline at its crossings: the loop of largest area, and the
// total area of all loops. An outline without crossings is returned unchanged. Empty if no loop has
// an area.
struct LargestLoop {
    std::vector<Vec2> outline;
    double area = 0;
    double area_of_all = 0;
};
LargestLoop largest_loop(std::vector<Vec2> const& outline);

// Removes the overshooting ends of a stroke whose first and last quarters cross each other.
std::vector<Vec2> without_overshoot(std::vector<Vec2> const& stroke);

} // namespace tractus::silhouette
