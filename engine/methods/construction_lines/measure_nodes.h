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
// Azimuth of a side in degrees: 0 for the left, 180 for the right.
double azimuth_of_side(Side side);

// Returns the value on the left side, and its negative on the right.
double signed_on(Side side, double value);

// A node's organ on one side of the stem, or at an azimuth around it. `size`, a share of the stem's
// length, has no value if the organ's direction misses the boundary.
struct SideNode {
    double x = 0;
    double angle_deg = 0; // Angle between organ and stem in space.
    std::optional<double> size {};
};

// Returns a construction's nodes on one side, from below. They are distributed evenly in the layers
// between inclination lines; their sizes are measured at a boundary on the sheet.
std::vector<SideNode> measure_nodes(Construction const& of, DrawnLine const& boundary, Side side);
// Returns a construction's nodes with sizes measured at a boundary in space, at `azimuth_deg`
// around the stem. `of.nodes` must already have positions and angles.
std::vector<SideNode> measure_nodes(Construction const& of, std::span<Vec3 const> boundary,
                                    double azimuth_deg);
// Returns a construction's nodes with positions and angles; their sizes are 0.
std::vector<OrganNode> nodes_without_sizes(Construction const& of);

// Names of a side of the stem and of its boundary, for messages.
struct SideName {
    std::string where;    // Position in words, such as "on the left".
    std::string boundary; // Name of the boundary on that side, such as "the left boundary".
};
SideName side_named(Side side);
SideName azimuth_named(double azimuth_deg);

// Interpolates missing sizes linearly between the nearest nodes that have a size, and reports this
// in `notes`. Fails with a user error if no node has a size.
Result<void> fill_sizes(std::vector<SideNode>& nodes, SideName const& name,
                        std::vector<std::string>& notes);

} // namespace tractus::lines
