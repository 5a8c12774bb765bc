#pragma once

#include "engine/plant/plant.h"

#include <span>
#include <vector>

namespace tractus::silhouette {

// Position, direction and length of a child axis relative to its parent.
struct PositionedLateral {
    double u = 0;
    double angle_deg = 0;
    // Azimuth relative to a direction that is parallel transported along the parent.
    double azimuth_deg = 0;
    double length = 0; // Length as a share of the parent's length.
};

// The children of an axis, given their ids, sorted by position from its base. A child that goes
// straight on from the axis's tip continues the axis and is left out, as is a child without length.
std::vector<PositionedLateral> children_of(Plant const& plant, AxisId parent,
                                           std::span<AxisId const> ids);

// Children that share one node of their parent.
struct NodeOfChildren {
    double u = 0;
    std::span<PositionedLateral const> children;
};

// Groups children, at least one and sorted by position, into nodes: those within a fifth of the
// mean distance share a node. The returned spans refer to `children`.
std::vector<NodeOfChildren> nodes_of(std::span<PositionedLateral const> children);

} // namespace tractus::silhouette
