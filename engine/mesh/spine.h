#pragma once

#include "engine/mesh/make_mesh.h"

#include <vector>

namespace tractus {

// One cross-section of a tube before it has a frame.
struct SpineStation {
    Vec3 center_mm;
    Vec3 tangent;      // Unit length.
    double radius_mm;  // Above 0, but for a point at the tip.
    double arc_mm;     // Along the spine from its first station.
    SegmentId segment; // That the stretch from the station before belongs to.
};

// An axis made ready for sections: bends rounded, collar flared, coinciding nodes joined.
struct Spine {
    std::vector<SpineStation> stations; // None, or two and more.
    int sides = 0;
    bool closed_base = false; // Stands on nothing: its first section is filled.
    enum class Tip { Dome, Point, Open };
    Tip tip = Tip::Dome;

    // Scratch space of trace_spine(), kept so that it is allocated once.
    struct Node {
        Vec3 position_mm;
        Vec3 direction; // Of the stretch that starts here; the last node repeats the one before.
        double length_mm;
        double radius_mm;
        SegmentId segment; // That ends here.
    };
    std::vector<Node> nodes;
};

// Fills `spine` with the stations of `axis`; what was in it is lost. `thickest_mm` is the plant's
// greatest radius. A pure function of its arguments, so that counting and writing see the same.
void trace_spine(Plant const& plant, Axis const& axis, MeshOptions const& options,
                 double thickest_mm, Spine& spine);

} // namespace tractus
