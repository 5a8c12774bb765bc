#pragma once

#include "engine/methods/silhouettes/branch_style.h"
#include "engine/methods/silhouettes/branching_system.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tractus::silhouette {

constexpr std::size_t kNoSystem = ~std::size_t { 0 };

// How often branches branch, and how finely that is inferred.
struct SkeletonOptions {
    int levels = 2; // Of branches: 1 for those of the trunk alone; 1 to 3.
    InferenceOptions tree {};
    // For crowns that nobody drew: fewer samples are enough.
    InferenceOptions below { .outline = { .samples = 80, .smoothing_samples = 1 },
                             .bumps = {},
                             .fill = { .steps = 12, .most_branches = 16, .enough = 0.85 },
                             .angles = {} };
    // For crowns of branches that somebody drew.
    InferenceOptions outlined { .outline = { .samples = 160 },
                                .bumps = {},
                                .fill = { .steps = 16, .most_branches = 32, .enough = 0.92 },
                                .angles = {} };
    // What the trunk's branches are called, in their order; the rest as name_of() says.
    std::vector<std::string> names {};
    // Styles of the trunk's branches, then of theirs. Where one is set, its angles are in place
    // of those above, and no branch is inferred below its first.
    std::vector<BranchStyle> styles {};
    std::uint64_t seed = 1; // Of the distances of branches in a sibling's style.
};

// A tree of branching systems: the crown of each branch is the silhouette of the next one. Copies
// of a branch share its system, which is seen through the way from the model to the copy.
struct Skeleton {
    std::vector<BranchingSystem> systems; // The whole tree first.
    // Of each system's branches the system of its own branches; kNoSystem: it bears none.
    std::vector<std::vector<std::size_t>> system_of;

    // Of all levels, those of copies too.
    std::size_t branch_count() const;

    // How many branches the outline of one of the trunk's branches holds; 0: it bears none.
    std::size_t branches_on(std::size_t branch) const;
};

// Infers the branches of the trunk alone, with what was drawn on them. Fails like infer_system().
Result<BranchingSystem> infer_on_trunk(Drawing const& drawing, SkeletonOptions const& options = {});

// Infers the whole tree of a drawing. Branches with outlines of their own bear branches even where
// no others do; those that were drawn on bear what was drawn, and where their style goes to their
// siblings these bear branches, too. Fails like infer_system().
Result<Skeleton> infer_skeleton(Drawing const& drawing, SkeletonOptions const& options = {});

// What a branch is called: "b4", ends in bump 4; "L7" and "R7", copies at the seventh place on the
// left and right; "g2", fills gap 2; "d1", was drawn; "apex"; or as an earlier drawing has it.
std::string name_of(Branch const& branch);

// Which of a system's branches is called so; no value: none.
std::optional<std::size_t> number_of(BranchingSystem const& system, std::string const& name);

} // namespace tractus::silhouette
