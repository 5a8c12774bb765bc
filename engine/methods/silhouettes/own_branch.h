#pragma once

#include "engine/base/result.h"
#include "engine/methods/silhouettes/skeleton.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tractus::silhouette {

// Among which branches one is looked for.
enum class Search {
    OnTrunk,  // The trunk's.
    AnyLevel, // And those of branches that somebody drew on.
};

// The branch of a system that a place is on, and how far it is from that one's line; no value:
// there is none.
//
// It is on a branch if it is within 2.5 % of the outline's diagonal of that one's line, nearer to
// it than to all others and to the trunk, and at least 2 % of the diagonal away from the trunk. The
// apex is none.
struct NearBranch {
    std::size_t branch = 0;
    double distance = 0;
};
std::optional<NearBranch> branch_near(BranchingSystem const& system, Vec2 const& place);

// Likewise, of all branches of a skeleton that are searched, the nearest.
std::optional<BranchAt> branch_near(Skeleton const& skeleton, Vec2 const& place);

// The branch of a system that a stroke is a branch of: it begins on it (branch_near()) and does not
// come back; no value: there is none. The system and the stroke are in the same millimetres.
std::optional<std::size_t> parent_of(BranchingSystem const& system, std::span<Vec2 const> stroke);

// Gives branches the strokes that were drawn on them. A branch that was a copy is one no more;
// copies of a branch stay copies of it. Strokes on branches that there are not are left out.
void take_own_branches(BranchingSystem& system, std::span<OwnBranch const> branches);

// Adds a stroke to a drawing as a branch of the branch that it begins on. Fails, as the user's
// fault, where it begins on none or is shorter than 2 % of that one, and like infer_system().
Result<void> add_own_branch(Drawing& drawing, std::vector<Vec2> stroke, StyleTo style_to,
                            SkeletonOptions const& options = {}, Search search = Search::OnTrunk);

// The path of the branch that add_own_branch() would give the stroke to; no value: none.
Result<std::optional<std::string>> branch_borne_by(Drawing const& drawing,
                                                   std::span<Vec2 const> stroke,
                                                   SkeletonOptions const& options = {},
                                                   Search search = Search::OnTrunk);

} // namespace tractus::silhouette
