#pragma once

#include "engine/base/result.h"
#include "engine/methods/silhouettes/own_branch.h"
#include "engine/methods/silhouettes/skeleton.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace tractus::silhouette {

// Finds the bump that a touch refers to. A split refers to the bump that contains the touch;
// failing that, to one whose end is near the touch; failing that, to one whose arc is no further
// from the touch than 4 % of the outline's diagonal. Bumps of fewer than eight samples are too
// small to split. A join refers to the nearest joint within 8 % of the diagonal. A joint is the
// part of the outline from the end of one bump to the beginning of the next.
//
// Returns the index of the bump; for a join, of the first of the two bumps along the outline. No
// value if the touch refers to no bump. The touch, the bumps and the outline share one frame and
// unit.
std::optional<std::size_t> touched_bump(std::span<Bump const> bumps, std::span<Vec2 const> outline,
                                        BumpTouch const& touch);

// Indices of the systems whose outlines were drawn, smallest outline first. Search::OnTrunk: only
// the system of the whole crown.
std::vector<std::size_t> outlined_systems(Skeleton const& skeleton, Search search);

// Splits and joins bumps, one touch after the other, before roles are assigned. Returns the number
// of touches that matched a bump.
//
// A bump is split where a ray through the touch leaves it. The ray starts at the middle of the
// bump's chord, or farther back behind its end. The split point is at least a fifth of the arc away
// from both ends of the arc; each half gets its part of the arc. A joined bump has both arcs and
// ends between the two ends.
std::size_t take_touches(std::vector<Bump>& bumps, std::span<Vec2 const> outline,
                         std::span<BumpTouch const> touches);

// The effect of a touch on a drawing. The touch is added to the touches of the smallest outline
// with a bump there, or it undoes an earlier touch: joining two halves undoes the split that made
// them, and splitting a joined bump near the touch that joined it undoes the join.
struct TouchedDrawing {
    BumpTouch added {};
    // Index, among the drawing's touches, of the earlier touch that is undone; `added` is unused
    // then.
    std::optional<std::size_t> taken_back {};
};

// Finds the effect of a touch. Search::OnTrunk considers only the crown's bumps. Fails with a user
// error if the touch is at no bump, and like infer_skeleton().
Result<TouchedDrawing> touched(Drawing const& drawing, BumpTouch const& touch,
                               SkeletonOptions const& options = {},
                               Search search = Search::AnyLevel);

// Finds the effect of a touch like touched() and applies it to the drawing.
Result<void> add_touch(Drawing& drawing, BumpTouch const& touch,
                       SkeletonOptions const& options = {}, Search search = Search::AnyLevel);

// Number of the drawing's touches that match no bump at present.
std::size_t count_unmatched_touches(Drawing const& drawing, Skeleton const& skeleton);

} // namespace tractus::silhouette
