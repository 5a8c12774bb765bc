#pragma once

#include <algorithm>

namespace tractus::silhouette {

constexpr double kMinAngle_deg = 5; // Smallest branching angle of a style, degrees.
constexpr double kMaxAngle_deg = 175;
constexpr double kMaxChildren = 500;
constexpr double kMaxBare = 0.99;
constexpr double kMaxUneven = 10;

// The number of branches of the axes of one level, their positions and their angles. Lengths are
// shares of the parent's length, so a style applies to plants of any size.
struct BranchStyle {
    double children = 0; // Mean number of children of an axis that has any; 0: no style is set.
    double children_deviation = 0;
    double bare = 0; // Share of the axes without children, below 1. The trunk always has some.
    double unbranched = 0; // Position of the first child, as a share of the parent's length.
    // Mean distance between consecutive children as a share of the parent's length; within a node
    // the distance is 0.
    double spacing = 0;
    double unevenness = 0; // Coefficient of variation of the distance between nodes.
    // Standard deviation of the distance between consecutive children, including the zero distances
    // within a node and the differences between parents, as a share of the parent's length. 0:
    // distances vary by `unevenness` alone.
    double spacing_deviation = 0;
    // Branching angles of the first and the last child, interpolated linearly in between.
    double first_angle_deg = 0;
    double last_angle_deg = 0;
    double angle_deviation_deg = 0;

    bool is_set() const { return children > 0; }
    // Distance along the parent from the first child to the last.
    double extent() const { return children > 1 ? spacing * (children - 1) : 0; }
    // Branching angle at a share of the distance from a parent's first child to its last.
    double angle_at_deg(double share) const
    {
        return first_angle_deg + share * (last_angle_deg - first_angle_deg);
    }

    bool operator==(BranchStyle const&) const = default;
};

// A branching angle is measured between the parent's direction at the branching point and the chord
// over this share of the branch's length. The tangent at the very base would be unreliable.
constexpr double kAngleOver = 0.125;

} // namespace tractus::silhouette
