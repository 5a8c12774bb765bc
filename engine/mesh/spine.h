#pragma once

#include "engine/mesh/make_mesh.h"

#include <span>
#include <vector>

namespace tractus::mesh {

// One cross-section of a tube before it has a frame.
struct SpineStation {
    Vec3 center_mm;
    Vec3 tangent;      // Unit length.
    double radius_mm;  // Above 0, but for a point at the tip.
    double arc_mm;     // Along the spine from its first station.
    SegmentId segment; // Segment that the stretch from the station before belongs to.
};

// An axis made ready for sections: bends rounded, collar flared, coinciding nodes joined.
struct Spine {
    std::span<SpineStation const> stations; // None, or two and more. Whoever traced it has them.
    int sides = 0;
    bool closed_base = false; // Stands on nothing: its first section is filled.
    enum class Tip { Dome, Point, Open };
    Tip tip = Tip::Dome;
};

// Room for one spine after another, allocated once.
struct SpineRoom {
    std::vector<SpineStation> stations {};

    struct Node {
        Vec3 position_mm;
        // Direction of the stretch that starts here; the last node repeats the one before.
        Vec3 direction;
        double length_mm;
        double radius_mm;
        SegmentId segment; // Segment that ends here.
    };
    std::vector<Node> nodes {}; // Scratch space.
};

// The spine of `axis`, with its stations in `room`: what was in there is lost. `thickest_mm` is the
// plant's greatest radius.
Spine trace_spine(Plant const& plant, Axis const& axis, MeshOptions const& options,
                  double thickest_mm, SpineRoom& room);

} // namespace tractus::mesh
