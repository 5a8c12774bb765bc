#pragma once

#include "engine/methods/silhouettes/plane.h"
#include "engine/plant/organ_shape.h"

#include <optional>
#include <span>
#include <vector>

namespace tractus::silhouette {

// A silhouette that somebody declared a leaf: nothing is inferred in it, and one organ lies there
// (Wither 2009, section 4.2).
struct LeafBlade {
    // Counter-clockwise, in a frame of its own: the blade's base is the origin, its tip (0, 1).
    std::vector<Vec2> outline;
    // Where these two are in the plane of the drawing.
    Vec2 base = Vec2::Zero();
    Vec2 tip = Vec2::UnitY();
    bool mirrors = false; // It lies there with its other side up.
    double stalk = 0;     // The share of its parent's length where it begins.
};

// The leaf whose outline lies around the end of a line: it begins where that enters the outline, or
// with the line, and ends at the outline's farthest point from there.
LeafBlade leaf_along(std::span<Vec2 const> outline, std::span<Vec2 const> line);

// The leaf elsewhere.
LeafBlade moved(LeafBlade leaf, Similarity const& way);

// The part of a line that bears a leaf, as its stalk; of one that begins in the leaf a short piece.
std::vector<Vec2> stalk_of(LeafBlade const& leaf, std::span<Vec2 const> line);

// The organ, a millimetre long at scale 1, flat and as it was drawn.
OrganShape leaf_organ(std::vector<Vec2> const& outline, MaterialId material);

} // namespace tractus::silhouette
