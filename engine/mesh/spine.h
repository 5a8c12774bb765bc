#pragma once

#include "engine/mesh/make_mesh.h"

#include <cmath>
#include <span>
#include <vector>

namespace tractus::mesh {

// One cross-section of a tube, before its frame is computed.
struct SpineStation {
    Vec3 center_mm;
    Vec3 tangent;      // Unit length.
    double radius_mm;  // Above 0, except at a pointed tip.
    double arc_mm;     // Arc length along the spine from its first station.
    SegmentId segment; // The segment between the previous station and this one.
};

// The union of a lateral axis with its parent: near the parent the axis widens, and its sections
// lean until the last one lies on the parent's surface, so that the two surfaces meet in a saddle.
struct Saddle {
    Vec3 base_mm = Vec3::Zero();           // Base of the axis, in the parent's wood.
    Vec3 parent_direction = Vec3::UnitZ(); // Unit length.
    double parent_radius_mm = 0;           // 0: the axis has no saddle.
    double level_mm = 0; // Arc length at which the axis' centre line leaves the parent.
    double end_mm = 0;   // Arc length at which the axis has its own width; above level_mm.

    bool contains(double arc_mm) const
    {
        return parent_radius_mm > 0 && arc_mm >= level_mm && arc_mm < end_mm;
    }
    // Share of the saddle that is left at an arc length that it contains: 1 at the parent's
    // surface, falling to 0.
    double share(double arc_mm) const { return (end_mm - arc_mm) / (end_mm - level_mm); }
};

// Ridges of a trunk at the ground (RootFlare); their height falls exponentially along the axis.
struct Ridges {
    int count = 0; // 0: none.
    double depth = 0;
    double turn_rad = 0;
    double reach_mm = 1; // Arc length over which the height falls to 1/e.

    // Height of the outline at an angle about +z, for depth 1; the mean over all angles is nearly
    // 0. Ridges are narrower than the furrows between them, and not evenly spaced.
    double outline(double angle_rad) const
    {
        double const phase = count * angle_rad + 0.7 * std::sin(angle_rad + turn_rad) + turn_rad;
        return std::cos(phase) + 0.3 * std::cos(2 * phase);
    }
    // Derivative of outline() by the angle.
    double outline_slope(double angle_rad) const
    {
        double const phase = count * angle_rad + 0.7 * std::sin(angle_rad + turn_rad) + turn_rad;
        double const change = count + 0.7 * std::cos(angle_rad + turn_rad);
        return -change * (std::sin(phase) + 0.6 * std::sin(2 * phase));
    }
    static constexpr double kHighest = 1.3; // Greatest value of outline().

    double depth_at(double arc_mm) const { return depth * std::exp(-arc_mm / reach_mm); }
};

// An axis prepared for meshing: its bends are rounded, its base is widened to a collar, and
// coincident nodes are merged.
struct Spine {
    // Cross-sections from base to tip: none, or at least two. Owned by the caller's SpineBuffers.
    std::span<SpineStation const> stations;
    int sides = 0;
    bool closed_base = false; // True: the base has a flat cap (only if the axis has no parent).
    enum class Tip { Dome, Point, Open };
    Tip tip = Tip::Dome;
    Saddle saddle {};
    Ridges ridges {};
    // Greatest distance by which a corner of a section lies outside the ball around the section's
    // centre with the section's radius.
    double overhang_mm = 0;
};

// Reusable memory for tracing spines one after another.
struct SpineBuffers {
    std::vector<SpineStation> stations {};

    struct Node {
        Vec3 position_mm;
        // Direction from this node to the next; the last node repeats the direction of the node
        // before.
        Vec3 direction;
        double length_mm;
        double radius_mm;
        SegmentId segment; // The segment that ends at this node.
    };
    std::vector<Node> nodes {}; // Nodes of the axis being traced; coincident nodes are merged.
};

// Returns the spine of `axis`. Its stations replace those in `room`. `thickest_mm`: the greatest
// radius in the plant.
Spine trace_spine(Plant const& plant, Axis const& axis, MeshOptions const& options,
                  double thickest_mm, SpineBuffers& room);

} // namespace tractus::mesh
