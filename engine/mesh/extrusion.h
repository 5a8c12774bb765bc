#pragma once

#include "engine/mesh/make_mesh.h"
#include "engine/mesh/triangle_place.h"
#include "engine/mesh/tube.h"

#include <vector>

namespace tractus::mesh {

// An axis with at least one cross-section that is not round (NodeSection), prepared for meshing.
//
// Each node has one section, in the plane that bisects the segments meeting there. If all contours
// are closed, the axis becomes a tube, with filled ends unless MeshOptions::ends is Open. If any
// contour is open, it becomes a sheet with a front and a back.
struct Extrusion {
    struct Station {
        Vec3 center_mm;
        Vec3 tangent; // Unit length.
        Vec3 normal;  // Reference direction of the section, orthogonal to the tangent.
        double radius_mm;
        double arc_mm;
        SegmentId segment; // The segment between the previous station and this one.
        NodeId node;       // The node whose NodeSection the station has.
    };

    std::vector<Station> stations; // Cross-sections from base to tip: none, or at least two.
    std::uint32_t sides = 0;
    bool is_sheet = false;
    bool has_caps = false;
};

// Prepares an axis for meshing. The result replaces the contents of `extrusion`.
void trace_extrusion(Plant const& plant, Axis const& axis, MeshOptions const& options,
                     Extrusion& extrusion);

// Returns the numbers of vertices and indices that write_extrusion() writes for `part`.
MeshExtent extrusion_extent(Plant const& plant, Extrusion const& extrusion, TubePart const& part);

void write_extrusion(Plant const& plant, Extrusion const& extrusion, TubePart const& part,
                     TrianglePlace& place);

} // namespace tractus::mesh
