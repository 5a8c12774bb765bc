#pragma once

#include "engine/mesh/spine.h"
#include "engine/mesh/triangle_place.h"

#include <span>

namespace tractus::mesh {

// A stretch of one tube's sections, first and last included, that have one material.
struct TubePart {
    std::uint32_t first = 0;
    std::uint32_t last = 0; // Greater than first.
};

// A cross-section ready to be written.
struct Section {
    Vec3f center_mm;
    Vec3f normal;   // Points from the centre to the seam.
    Vec3f binormal; // tangent x normal.
    Vec3f tangent;
    float radius_mm; // 0 for a point.
    float slope;     // Change of radius along the axis.
    float v;         // Texture coordinate: the length so far in units of the circumference there.
};

// The sections of a spine: a rotation-minimising frame carried along, slopes for the normals, and
// texture coordinates. What was in `sections` is lost.
void frame_sections(Spine const& spine, std::vector<Section>& sections);

// Returns what write_tube() will write.
MeshExtent tube_extent(Spine const& spine, TubePart const& part);

// Writes one part of a tube, with its caps if it is the first or the last one. Parts that do not
// overlap may be written at the same time.
void write_tube(Spine const& spine, std::span<Section const> sections, TubePart const& part,
                TrianglePlace& place);

} // namespace tractus::mesh
