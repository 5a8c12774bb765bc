#pragma once

#include "engine/mesh/spine.h"
#include "engine/mesh/tube.h"

#include <cstddef>
#include <span>

namespace tractus::mesh {

// Shapes that a tube's round rings are given after they were written: the ridges of a trunk's root
// flare, and the saddle between a branch and its parent.

// Returns the height of the ridges at an arc length, as a share of the radius; exactly 0 where they
// are too low to be seen.
double ridge_height(Ridges const& ridges, double arc_mm);

// Gives the first `count` corners of a round ring the outline of a trunk with ridges. `normals` may
// be null.
void add_ridges(Ridges const& ridges, Section const& section, std::size_t count, Vec3f* positions,
                Vec3f* normals);

// Shapes those rings of a part of a tube that belong to its saddle. The corners of the ring at the
// level of the parent's surface move along the tube onto that surface and take its normals; the
// rings after it follow less and less. `part`: the stations whose rings were written one after
// another from `positions` and `normals` on.
void shape_saddle(Spine const& spine, std::span<Section const> sections, TubePart const& part,
                  Vec3f* positions, Vec3f* normals);

} // namespace tractus::mesh
