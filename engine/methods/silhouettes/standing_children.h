#pragma once

#include "engine/plant/plant.h"

#include <span>
#include <vector>

namespace tractus::silhouette {

// A child as it stands on its parent.
struct StandingChild {
    double u = 0;
    double angle_deg = 0;
    double azimuth_deg = 0; // From a direction that goes along with the parent without turning.
    double length = 0;      // A share of the parent's.
};

// An axis' children, whose ids are given, by their places from its base on. One that goes straight
// on from its tip is the axis' continuation and counts as none, as does one without a length.
std::vector<StandingChild> children_of(Plant const& plant, AxisId parent,
                                       std::span<AxisId const> ids);

// Children that stand at one place of their parent.
struct NodeOfChildren {
    double u = 0;
    std::span<StandingChild const> children;
};

// At least one child, in order of their places. Those within a fifth of the mean distance of
// children are at one place. The nodes look into what they are given.
std::vector<NodeOfChildren> nodes_of(std::span<StandingChild const> children);

} // namespace tractus::silhouette
