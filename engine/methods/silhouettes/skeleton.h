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

// Options for inferring a skeleton: the number of branching levels, and how each is inferred.
struct SkeletonOptions {
    int levels = 2; // Number of branching levels, 1 to 3; 1: only the trunk has branches.
    InferenceOptions tree {};
    // Options for inferred crowns, for which fewer samples are enough.
    InferenceOptions below { .outline = { .samples = 80, .smoothing_samples = 1 },
                             .bumps = {},
                             .fill = { .steps = 12, .most_branches = 16, .enough = 0.85 },
                             .angles = {} };
    // Options for the branches' crowns whose outlines were drawn.
    InferenceOptions outlined { .outline = { .samples = 160 },
                                .bumps = {},
                                .fill = { .steps = 16, .most_branches = 32, .enough = 0.92 },
                                .angles = {} };
    // Names of branches in their order, by the path of their parent (Skeleton::at()); "" is the
    // trunk. Branches without an entry are named by name_of().
    BranchNames names {};
    // Styles by level: the trunk's branches, then their branches. A style that is set replaces the
    // branching angles of the InferenceOptions, and no branch is inferred below the position of the
    // style's first child.
    std::vector<BranchStyle> styles {};
    // Seed for the distances between branches that follow a sibling's style.
    std::uint64_t seed = 1;
};

// Reference to a branch of one of a skeleton's systems.
struct BranchRef {
    std::size_t system = 0;
    std::size_t branch = 0;
};

// A tree of branching systems: the crown of each branch is the silhouette from which its own system
// is inferred. Copies of a branch share its system, transformed by the similarity from the model to
// the copy.
struct Skeleton {
    std::vector<BranchingSystem> systems; // Branching systems, the trunk's first.
    // Index of the system of each branch of each system; kNoSystem: the branch has no children.
    std::vector<std::vector<std::size_t>> system_of;
    // Path of each system's parent branch (for a branch with copies, its own path); "": the trunk.
    std::vector<std::string> parents;
    std::vector<Meridian> surface {}; // Surface of the whole tree's crown (Drawing::surface).

    // The branch with this path, such as "b3/d0": the names of the branch's ancestors, from the
    // branch of the trunk on, and its own name. For copies the path uses the model's names. No
    // value if there is none.
    std::optional<BranchRef> at(std::string_view path) const;
    std::string path_of(BranchRef const& branch) const;

    // Indices of the trunk's system and of the systems of branches that were drawn on, at any
    // level.
    std::vector<std::size_t> drawn_systems() const;

    // Number of branches of all levels, including those of copies.
    std::size_t branch_count() const;

    // Number of children of a branch.
    std::size_t branches_on(BranchRef const& branch) const;
};

// Infers only the trunk's branches, with what was drawn on them. Fails like infer_system().
Result<BranchingSystem> infer_on_trunk(Drawing const& drawing, SkeletonOptions const& options = {});

// Callback that names branches during inference, before lines drawn on them are assigned by name.
class BranchNamer {
public:
    virtual ~BranchNamer() = default;

    // A newly inferred system, before drawn lines are applied to its branches. Branches that have
    // names in SkeletonOptions are already named.
    struct NewSystem {
        BranchingSystem& system;
        std::size_t index;         // Index of the system in the skeleton.
        std::string const& parent; // Path of the system's parent; "": the trunk.
        // Index of the system to which the parent branch belongs, kNoSystem if the parent is the
        // trunk; and the indices in that system of the parent and its copies.
        std::size_t parent_system;
        std::vector<std::size_t> const& parents;
    };
    // May name the system's branches and may reassign lines of the drawing to other branches.
    virtual void name(NewSystem const& made, Drawing& drawing) = 0;
};

// Infers the whole tree of a drawing. Branches with their own outline have children even on levels
// where others have none. Branches that were drawn on get the drawn children, and siblings that
// follow their style get children as well. Fails like infer_system().
Result<Skeleton> infer_skeleton(Drawing const& drawing, SkeletonOptions const& options = {});

// Infers the whole tree with names from `namer`, which may change the drawing's assignment of lines
// to branches.
Result<Skeleton> infer_skeleton(Drawing& drawing, SkeletonOptions const& options,
                                BranchNamer& namer);

// Separates the names in a path, which begins at the trunk.
constexpr char kPathSeparator = '/';
std::string_view parent_in(std::string_view path); // The path without its last name.
std::string_view last_name_in(std::string_view path);

// Default name of a branch: "b4" ends in bump 4; "L7" and "R7" are copies at step 7 on the left and
// right; "g2" fills gap 2; "s3" ends where the outline has no bump, at position 3
// (SpacedBranch::number); "d1" was drawn; "apex" is the trunk's own end. A name kept from an
// earlier drawing takes precedence.
std::string name_of(Branch const& branch);

// Index of the branch with this name in a system; no value if there is none.
std::optional<std::size_t> number_of(BranchingSystem const& system, std::string const& name);

} // namespace tractus::silhouette
