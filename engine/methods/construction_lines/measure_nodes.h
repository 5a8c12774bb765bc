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
double azimuth_of_side(Side side); // 0 and 180.

// The value where the left counts as positive.
double signed_on(Side side, double value);

// What stands at a node on one side of the stem, or at an azimuth around it. No size where it
// misses the boundary.
struct SideNode {
    double x = 0;
    double angle_deg = 0; // In space.
    std::optional<double> size {};
};

// A construction's nodes, from below, as the layers between its inclination lines have them: those
// along a boundary on the sheet,
std::vector<SideNode> measure_nodes(Construction const& of, DrawnLine const& boundary, Side side);
// those along one in space, given the nodes' angles,
std::vector<SideNode> measure_nodes(Construction const& of, std::span<Vec3 const> boundary,
                                    double azimuth_deg);
// and with their angles alone.
std::vector<OrganNode> nodes_without_sizes(Construction const& of);

// A side's name for people.
struct SideName {
    std::string where;    // "on the left",
    std::string boundary; // "the left boundary".
};
SideName side_named(Side side);
SideName azimuth_named(double azimuth_deg);

// Makes sizes that are missing linear between those of the nearest nodes that have one, and says so
// in the notes. Fails, as the user's fault, where none has.
Result<void> fill_sizes(std::vector<SideNode>& nodes, SideName const& name,
                        std::vector<std::string>& notes);

} // namespace tractus::lines
