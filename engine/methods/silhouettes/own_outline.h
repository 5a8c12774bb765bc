#pragma once

#include "engine/base/result.h"
#include "engine/methods/silhouettes/own_branch.h"
#include "engine/methods/silhouettes/skeleton.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tractus::silhouette {

// The branch of a system whose crown a closed stroke outlines; no value if the stroke outlines the
// whole crown or no branch.
//
// `shared` is the intersection over union of the stroke's area and the branch's crown.
//
// The outline of a branch encloses at most half of the crown's area and at most half of the trunk
// inside the crown. It surrounds the branch: the branch ends in it, it encloses at least a third of
// the branch's crown, and their intersection over union is at least a fifth. Of several branches,
// the one with the greatest intersection over union is taken. The system and the stroke share one
// frame, in millimetres.
struct OutlinedBranch {
    std::size_t branch = 0;
    double shared = 0;
};
std::optional<OutlinedBranch> outlined_in(BranchingSystem const& system,
                                          std::span<Vec2 const> stroke);
// Index of the branch that outlined_in() finds.
std::optional<std::size_t> branch_in(BranchingSystem const& system, std::span<Vec2 const> stroke);

// Replaces the crowns of branches by the outlines drawn for them. A copy that gets an outline is no
// longer a copy. Copies of a branch that gets one copy the drawn crown, as large as their places
// allow. All other branches stay. Outlines that belong to no branch, that contain no part of their
// branch or that clean_drawing() refuses are ignored. Updates `coverage_after`.
void take_own_outlines(BranchingSystem& system, std::span<OwnOutline const> outlines);

// Adds a closed stroke to a drawing as the outline of the branch that it surrounds, replacing an
// earlier outline, and optionally declares the outline a leaf. A branch that is a leaf already
// stays one. Fails with a user error if the stroke surrounds no branch, and like infer_system() and
// clean_drawing().
Result<void> add_own_outline(Drawing& drawing, std::vector<Vec2> stroke,
                             SkeletonOptions const& options = {},
                             StyleScope style_to = StyleScope::None,
                             Search search = Search::OnTrunk, bool is_leaf = false);

// Path of the branch to which add_own_outline() would assign the stroke; no value if there is no
// such branch.
Result<std::optional<std::string>> branch_outlined_by(Drawing const& drawing,
                                                      std::span<Vec2 const> stroke,
                                                      SkeletonOptions const& options = {},
                                                      Search search = Search::OnTrunk);

} // namespace tractus::silhouette
