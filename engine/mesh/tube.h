#pragma once

#include "engine/mesh/spine.h"
#include "engine/mesh/triangle_place.h"

#include <cstddef>
#include <span>

namespace tractus::mesh {

// A range of consecutive sections of one tube with the same material, first and last included.
struct TubePart {
    std::uint32_t first = 0;
    std::uint32_t last = 0; // Greater than `first`.
};

// A cross-section with its frame, ready to be written.
struct Section {
    Vec3f center_mm;
    Vec3f normal;   // Points from the centre to the seam of the texture.
    Vec3f binormal; // tangent x normal.
    Vec3f tangent;
    float radius_mm; // 0 at a pointed tip.
    float slope;     // Change of the radius per unit of length along the axis.
    float ridge;     // Height of the ridges here (Ridges::depth_at()), 0 for a round section.
    float v;         // Texture coordinate: arc length in units of the local circumference.
};

// Computes the sections of a spine: their rotation-minimising frames, the slopes for the normals,
// and the texture coordinates. Replaces the contents of `sections`.
void frame_sections(Spine const& spine, std::vector<Section>& sections);

// Returns the number of vertices of the cap that closes a spine's base: its corners and, if the
// section has ridges, its centre, as it is not convex then.
std::size_t base_vertex_count(Spine const& spine);

// Returns the numbers of vertices and indices that write_tube() writes.
MeshExtent tube_extent(Spine const& spine, TubePart const& part);

// Writes one part of a tube: with the base cap if it is the tube's first part, and with the tip if
// it is the last one. Different parts may be written concurrently, to different places.
void write_tube(Spine const& spine, std::span<Section const> sections, TubePart const& part,
                TrianglePlace& place);

} // namespace tractus::mesh
