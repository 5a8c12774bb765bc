#pragma once

#include "engine/methods/silhouettes/plane.h"
#include "engine/plant/organ_shape.h"

#include <optional>
#include <span>
#include <vector>

namespace tractus::silhouette {

// A silhouette that was declared a leaf: nothing is inferred inside it, and it becomes one organ
// (Wither 2009, section 4.2).
struct LeafBlade {
    // Outline in the blade's own frame, counter-clockwise: base at the origin, tip at (0, 1).
    std::vector<Vec2> outline;
    // Base and tip in the drawing plane.
    Vec2 base = Vec2::Zero();
    Vec2 tip = Vec2::UnitY();
    bool mirrors = false; // True: the blade lies with its lower side up.
    double stalk = 0;     // Position where the blade begins, as a share of the parent's length.
};

// The leaf whose outline surrounds the end of a line. Its base is where the line enters the
// outline, or the line's beginning if that is inside. Its tip is the outline's farthest point from
// the base.
LeafBlade leaf_along(std::span<Vec2 const> outline, std::span<Vec2 const> line);

// The leaf transformed by a similarity.
LeafBlade moved(LeafBlade leaf, Similarity const& way);

// The part of a line outside the leaf, as its petiole; a short piece if the line begins inside the
// leaf.
std::vector<Vec2> stalk_of(LeafBlade const& leaf, std::span<Vec2 const> line);

// The blade as a flat organ with the drawn outline, 1 mm long at scale 1.
OrganShape leaf_organ(std::vector<Vec2> const& outline, MaterialId material);

} // namespace tractus::silhouette
