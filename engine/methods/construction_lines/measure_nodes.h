#pragma once

#include "engine/base/result.h"
#include "engine/base/vectors.h"
#include "engine/methods/construction_lines/construction.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tractus::lines {

// Sides of a stem on the sheet.
enum class Side { Left = 1, Right = -1 };

char const* name_of_side(Side side);
double azimuth_of_side(Side side); // Azimuth of a side, 0 for the left and 180 for the right.

// Returns the value with the sign of the side: positive on the left.
double signed_on(Side side, double value);

// A node's organ on one side of the stem, or at an azimuth around it. `size` has no value if the
// organ's direction misses the boundary.
struct SideNode {
    double x = 0;
    double angle_deg = 0; // Angle between organ and stem in space.
    std::optional<double> size {};
};

// Measures a construction's nodes, from below, as distributed in the layers between inclination
// lines: with sizes from a boundary on the sheet.
std::vector<SideNode> measure_nodes(Construction const& of, DrawnLine const& boundary, Side side);
// Measures a construction's nodes with sizes from a boundary in space at `azimuth_deg` around the
// stem; the nodes' angles must be known.
std::vector<SideNode> measure_nodes(Construction const& of, std::span<Vec3 const> boundary,
                                    double azimuth_deg);
// Returns a construction's nodes with their angles only, without sizes.
std::vector<OrganNode> nodes_without_sizes(Construction const& of);

// The name of a side, for messages.
struct SideName {
    std::string where;    // Position in words, such as "on the left".
    std::string boundary; // Name of the boundary on that side, such as "the left boundary".
};
SideName side_named(Side side);
SideName azimuth_named(double azimuth_deg);

// Interpolates missing sizes linearly between the nearest nodes that have one, and reports this in
// the notes. Fails with a user error if none has a size.
Result<void> fill_sizes(std::vector<SideNode>& nodes, SideName const& name,
                        std::vector<std::string>& notes);

} // namespace tractus::lines
