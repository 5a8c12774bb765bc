#pragma once

#include "engine/variation/limb.h"

#include <vector>

namespace tractus::variation {

// A node of a limb that carries twigs or organs.
struct LimbNode {
    double share = 0;      // Position of the node as a share of the limb's length; above 0.
    SegmentId pattern = 0; // The pattern's segment whose end carries the same twigs and organs.
    // Rotation about the axis relative to the pattern's node. It continues the divergence angles
    // where the limb has more nodes than its pattern, or fewer.
    double turn_rad = 0;
};

// Returns the nodes of a limb that is modelled on an axis of `plant`, base first. `length_ratio`:
// length of the limb divided by that of the axis.
std::vector<LimbNode> limb_nodes(Plant const& plant, RestShape const& rest, AxisId pattern,
                                 double length_ratio);

// Minimum number of segments of a limb, enough to follow the drawn stroke.
constexpr double kMinLimbSegments = 32;

// A node of a limb's own axis.
struct LimbStation {
    double share = 0; // Position of the node as a share of the limb's length.
    std::vector<LimbNode> bears {};
};

// Returns the nodes of a limb's axis, from 0 to 1, at least two: those of `nodes`, one where its
// drawn part begins, and others between them. The first node carries nothing.
std::vector<LimbStation> limb_stations(std::vector<LimbNode> const& nodes, double drawn_from);

// Arc length from the base of a segment's axis to a point of the segment, as a share of the axis'
// length. `part`: the point, from 0 at the segment's base to 1 at its end.
double share_on_axis(Axis const& axis, AxisId id, RestShape const& rest, SegmentId segment,
                     double part);

} // namespace tractus::variation
