#pragma once

#include "engine/mesh/make_mesh.h"
#include "engine/mesh/triangle_place.h"
#include "engine/mesh/tube.h"

#include <vector>

namespace tractus::mesh {

// An axis whose cross-sections are not round (NodeSection), made ready for its triangles.
//
// Each node has one section, across the bisector of the segments that meet there. Closed outlines
// make a tube, filled at both ends (unless MeshOptions leaves ends open); where any outline is
// open the axis is a sheet with a front and a back.
struct Extrusion {
    struct Station {
        Vec3 center_mm;
        Vec3 tangent; // Unit length.
        Vec3 normal;  // Normal of the section, across the tangent.
        double radius_mm;
        double arc_mm;
        SegmentId segment; // Segment that the stretch from the station before belongs to.
        NodeId node;       // Node whose section it has.
    };

    std::vector<Station> stations; // None, or two and more.
    std::uint32_t sides = 0;
    bool is_sheet = false;
    bool has_caps = false;
};

// Fills `extrusion`; what was in it is lost. A pure function of its other arguments.
void trace_extrusion(Plant const& plant, Axis const& axis, MeshOptions const& options,
                     Extrusion& extrusion);

// Returns what write_extrusion() will write of the stretch `part` of stations.
MeshExtent extrusion_extent(Plant const& plant, Extrusion const& extrusion, TubePart const& part);

void write_extrusion(Plant const& plant, Extrusion const& extrusion, TubePart const& part,
                     TrianglePlace& place);

} // namespace tractus::mesh
