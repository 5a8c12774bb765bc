#pragma once

#include "engine/methods/silhouettes/branch_style.h"
#include "engine/methods/silhouettes/branching_system.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::silhouette {

constexpr std::size_t kNoSystem = ~std::size_t { 0 };

using BranchNames = std::map<std::string, std::vector<std::string>>;

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
    // What branches are called, in their order, by the path of what bears them (Skeleton::at());
    // "" is the trunk. The rest as name_of() says.
    BranchNames names {};
    // Styles of the trunk's branches, then of theirs. Where one is set, its angles are in place
    // of those above, and no branch is inferred below its first.
    std::vector<BranchStyle> styles {};
    std::uint64_t seed = 1; // Of the distances of branches in a sibling's style.
};

// A branch of one of a skeleton's systems.
struct BranchAt {
    std::size_t system = 0;
    std::size_t branch = 0;
};

// A tree of branching systems: the crown of each branch is the silhouette of the next one. Copies
// of a branch share its system, which is seen through the way from the model to the copy.
struct Skeleton {
    std::vector<BranchingSystem> systems; // The whole tree first.
    // Of each system's branches the system of its own branches; kNoSystem: it bears none.
    std::vector<std::vector<std::size_t>> system_of;
    // Of each system the path of what bears it, of what has copies the model's; "": the trunk.
    std::vector<std::string> parents;
    std::vector<Meridian> surface {}; // Of the whole tree's crown: Drawing::surface.

    // Which branch has this path, the names from one of the trunk's branches on, as "b3/d0"; where
    // these are of copies, it is their models'. No value: none.
    std::optional<BranchAt> at(std::string_view path) const;
    std::string path_of(BranchAt const& branch) const;

    // The trunk's system, and those of branches that somebody drew on, at any level.
    std::vector<std::size_t> drawn_systems() const;

    // Of all levels, those of copies too.
    std::size_t branch_count() const;

    // How many branches a branch bears.
    std::size_t branches_on(BranchAt const& branch) const;
};

// Infers the branches of the trunk alone, with what was drawn on them. Fails like infer_system().
Result<BranchingSystem> infer_on_trunk(Drawing const& drawing, SkeletonOptions const& options = {});

// Says what branches are called while a skeleton is inferred, before what was drawn on them is
// looked for by their names.
class BranchNamer {
public:
    virtual ~BranchNamer() = default;

    // A system that was inferred, without what was drawn on its branches. Those have names already
    // if SkeletonOptions have them.
    struct NewSystem {
        BranchingSystem& system;
        std::size_t index;         // In the skeleton.
        std::string const& parent; // Its path; "": the trunk.
        // The system of the parent, kNoSystem for the trunk's; the parent and its copies there.
        std::size_t parent_system;
        std::vector<std::size_t> const& parents;
    };
    // May name the system's branches, and say otherwise of which branches lines of the drawing are.
    virtual void name(NewSystem const& made, Drawing& drawing) = 0;
};

// Infers the whole tree of a drawing. Branches with outlines of their own bear branches even where
// no others do; those that were drawn on bear what was drawn, and where their style goes to their
// siblings these bear branches, too. Fails like infer_system().
Result<Skeleton> infer_skeleton(Drawing const& drawing, SkeletonOptions const& options = {});

// Likewise, with names from elsewhere; the drawing's lines are of the branches then that these say.
Result<Skeleton> infer_skeleton(Drawing& drawing, SkeletonOptions const& options,
                                BranchNamer& namer);

// Names from the trunk on, and what stands between two of them.
constexpr char kPathSeparator = '/';
std::string_view parent_in(std::string_view path); // Without the last name.
std::string_view last_name_in(std::string_view path);

// What a branch is called: "b4", ends in bump 4; "L7" and "R7", copies at the seventh place on the
// left and right; "g2", fills gap 2; "d1", was drawn; "apex"; or as an earlier drawing has it.
std::string name_of(Branch const& branch);

// Which of a system's branches is called so; no value: none.
std::optional<std::size_t> number_of(BranchingSystem const& system, std::string const& name);

} // namespace tractus::silhouette
