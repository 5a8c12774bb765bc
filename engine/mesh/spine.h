#pragma once

#include "engine/mesh/make_mesh.h"

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

// An axis prepared for meshing: its bends are rounded, its base is widened to a collar, and
// coincident nodes are merged.
struct Spine {
    // Cross-sections from base to tip: none, or at least two. Owned by the caller's SpineBuffers.
    std::span<SpineStation const> stations;
    int sides = 0;
    bool closed_base = false; // True: the base has a flat cap (only if the axis has no parent).
    enum class Tip { Dome, Point, Open };
    Tip tip = Tip::Dome;
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
