#pragma once

#include "engine/base/result.h"
#include "engine/methods/silhouettes/skeleton.h"

#include <set>
#include <span>
#include <string>

namespace tractus::silhouette {

// The paths that occur in `styles`, as target or as source, without duplicates.
std::set<std::string> paths_in(ChosenStyles const& styles);

// Path of the branch from which `branch` takes its style, following chosen styles from source to
// source. Paths are those of Skeleton::at().
std::string source_of(ChosenStyles const& styles, std::string branch);

// Adds chosen styles or replaces existing ones; a source of "" removes the branch's choice. A
// source that has a chosen style itself is replaced by its own source. Fails with a user error if a
// branch does not exist, if a source has no children or is on a deeper level, if branches were
// drawn on the target, or if a style is removed where none was chosen.
Result<void> choose_styles(ChosenStyles& styles, ChosenStyles const& chosen,
                           Skeleton const& skeleton);

// The style choices that a stroke stands for. The style of the branch on which the stroke begins
// (own_branch.h) is copied to the branches of the same level that it crosses, to within 1 % of the
// outline's diagonal. A stroke that crosses no other branch removes the style chosen for its first
// branch. Only the trunk's branches and the children of branches that were drawn on are considered.
// Fails with a user error if the stroke begins on no branch. The skeleton and the stroke share one
// frame, in millimetres.
Result<ChosenStyles> copied_by(Skeleton const& skeleton, std::span<Vec2 const> stroke);

} // namespace tractus::silhouette
