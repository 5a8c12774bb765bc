#pragma once

#include "engine/base/result.h"
#include "engine/methods/silhouettes/own_branch.h"
#include "engine/methods/silhouettes/skeleton.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace tractus::silhouette {

// What a touch is on. A split is on the bump that it lies in, else on one around whose end it is,
// or whose arc is within 4 % of the outline's diagonal of it; a bump of fewer than eight samples is
// too small. A join is on the nearest of the places where two bumps meet, of those within 8 % of
// the diagonal: the outline from the one's end to the other's beginning.
//
// `bump`: which one, of a join the first of the two along the outline; no value: on none. The
// touch, the bumps and the outline are in the same millimetres, whichever these are.
std::optional<std::size_t> touched_bump(std::span<Bump const> bumps, std::span<Vec2 const> outline,
                                        BumpTouch const& touch);

// The systems of outlines that somebody drew, the smallest first; Search::OnTrunk: the crown's.
std::vector<std::size_t> outlined_systems(Skeleton const& skeleton, Search search);

// Splits and joins bumps, one touch after the other, before roles are set; returns how many of the
// touches found theirs.
//
// A bump is split where the ray through the touch leaves it that comes from the middle of its
// chord, or from behind its end, at least a fifth of its arc away from where that begins and ends:
// each half has its part of the arc. What is joined has both arcs and ends between the two.
std::size_t take_touches(std::vector<Bump>& bumps, std::span<Vec2 const> outline,
                         std::span<BumpTouch const> touches);

// What a touch does to a drawing: it is added to its touches, of the smallest outline on whose
// bumps it is, or takes an earlier one back: a join of two halves the split that made them, a split
// near the place of a join that one.
struct TouchedDrawing {
    BumpTouch added {};
    std::optional<std::size_t> taken_back {}; // Of the drawing's touches, in place of `added`.
};

// Finds that. Search::OnTrunk looks at the crown's bumps alone. Fails, as the user's fault, where
// the touch is on no bump, and like infer_skeleton().
Result<TouchedDrawing> touched(Drawing const& drawing, BumpTouch const& touch,
                               SkeletonOptions const& options = {},
                               Search search = Search::AnyLevel);

// Likewise, and does it.
Result<void> add_touch(Drawing& drawing, BumpTouch const& touch,
                       SkeletonOptions const& options = {}, Search search = Search::AnyLevel);

// How many of a drawing's touches wait for their bumps.
std::size_t touches_waiting(Drawing const& drawing, Skeleton const& skeleton);

} // namespace tractus::silhouette
