#pragma once

#include "engine/variation/limb.h"

#include <vector>

namespace tractus::variation {

// A node of a limb that carries twigs or organs.
struct LimbNode {
    double share = 0;      // Position of the node as a share of the limb's length; above 0.
    SegmentId pattern = 0; // The pattern's segment whose end carries the same twigs and organs.
    // Rotation about the limb, relative to the pattern's node. It keeps the pattern's divergence
    // angles where the limb has more or fewer nodes than the pattern.
    double turn_rad = 0;
};

// Returns the nodes that carry twigs or organs on a limb whose pattern is an axis of `plant`, base
// first. `length_ratio`: length of the limb divided by that of the pattern.
std::vector<LimbNode> limb_nodes(Plant const& plant, RestShape const& rest, AxisId pattern,
                                 double length_ratio);

// Minimum number of segments of a limb, enough to follow the drawn stroke.
constexpr double kMinLimbSegments = 32;

// A node of a limb's own axis, with or without twigs and organs.
struct LimbStation {
    double share = 0; // Position of the node as a share of the limb's length.
    std::vector<LimbNode> bears {};
};

// Returns the nodes of a limb's axis, at least two, whose shares rise from 0 to 1: those of
// `nodes`, one where the drawn part begins (the share `drawn_from`), and others between them. The
// first node carries nothing.
std::vector<LimbStation> limb_stations(std::vector<LimbNode> const& nodes, double drawn_from);

// Returns the arc length from the base of an axis to a point on one of its segments, as a share of
// the axis' length. `part`: position of the point on the segment, from 0 at its base to 1 at its
// end.
double share_on_axis(Axis const& axis, AxisId id, RestShape const& rest, SegmentId segment,
                     double part);

} // namespace tractus::variation
