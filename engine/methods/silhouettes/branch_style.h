#pragma once

#include <algorithm>

namespace tractus::silhouette {

constexpr double kLeastAngle_deg = 5; // At which a branch of a style leaves its parent.
constexpr double kMostAngle_deg = 175;
constexpr double kMostChildren = 500;
constexpr double kMostBare = 0.99;
constexpr double kMostUneven = 10;

// How many branches the axes of one level bear, where, and at which angles. Lengths are shares of
// the parent's, so that a style goes from one plant to another of any size.
struct BranchStyle {
    double children = 0; // Of an axis that bears any, on average; 0: there is no style.
    double children_deviation = 0;
    double bare = 0;       // The share of the axes that bear none, below 1. The trunk always bears.
    double unbranched = 0; // Where the first child stands.
    double spacing = 0;    // From a child to the next, on average; 0 for those at one node.
    double unevenness = 0; // Deviation from node to node, in units of the average.
    // From a child to the next, those at one node and the differences between parents among it;
    // a share of the parent's length. 0: distances are as uneven as `unevenness` says, about.
    double spacing_deviation = 0;
    // Between the parent and its first child, and its last one; linear between.
    double first_angle_deg = 0;
    double last_angle_deg = 0;
    double angle_deviation_deg = 0;

    bool is_set() const { return children > 0; }
    // From the first child to the last.
    double extent() const { return children > 1 ? spacing * (children - 1) : 0; }
    // At a share of the way from a parent's first child to its last.
    double angle_at_deg(double share) const
    {
        return first_angle_deg + share * (last_angle_deg - first_angle_deg);
    }

    bool operator==(BranchStyle const&) const = default;
};

// The angle of a branch is that between its parent's direction where it stands and the way from
// there to this share of its length: what its line is like at its very base says little.
constexpr double kAngleOver = 0.125;

} // namespace tractus::silhouette
