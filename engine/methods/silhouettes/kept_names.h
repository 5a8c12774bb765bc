#pragma once

#include "engine/methods/silhouettes/skeleton.h"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace tractus::silhouette {

// Keeps what is inferred of a tree, without what was drawn on branches: what a later drawing is
// compared with.
class SystemRecord final : public BranchNamer {
public:
    void name(NewSystem const& made, Drawing&) override { systems_.push_back(made.system); }

    BranchingSystem const& system(std::size_t index) const { return systems_[index]; }

private:
    std::vector<BranchingSystem> systems_; // In the skeleton's order.
};

// Gives branches of a tree whose lines have changed the names that they had in the one before
// (match.h); those that are new get names that begin with `fresh`. What was drawn on branches goes
// with the names: an outline whose branch is gone goes to the branch of its parent that it lies
// around, if that has none, and a branch whose parent is gone to a new one that it begins on. What
// stands on those goes with them.
class KeptNames final : public BranchNamer {
public:
    // What it is given must outlive it.
    KeptNames(Skeleton const& earlier, SystemRecord const& record, std::string fresh)
        : earlier_(earlier)
        , record_(record)
        , fresh_(std::move(fresh))
    {
    }

    void name(NewSystem const& made, Drawing& drawing) override;

    // Of all branches that are named.
    BranchNames const& names() const { return names_; }

private:
    using Partners = std::vector<std::optional<std::size_t>>;

    std::optional<std::size_t> earlier_system(NewSystem const& made) const;

    Skeleton const& earlier_;
    SystemRecord const& record_;
    std::string fresh_;
    BranchNames names_;
    std::vector<std::optional<std::size_t>> earlier_of_; // Of each later system.
    std::vector<Partners> partners_;                     // Of its branches.
};

// A drawing, and how its branches are inferred.
struct DrawingToInfer {
    Drawing const& drawing;
    SkeletonOptions const& options;
};

// The names of a drawing's branches where its lines have changed, by the ones that they had before.
// Says in the later drawing of which branches its lines are. A crown that is a leaf has the names
// that it would have without. Fails like infer_skeleton().
Result<BranchNames> kept_names(DrawingToInfer const& before, Drawing& after,
                               SkeletonOptions options, std::string const& fresh);

// Finds branches again for what was drawn on them, where the tree had no crown for a while: names
// say nothing of those of the trunk before.
class FoundAgain final : public BranchNamer {
public:
    void name(NewSystem const& made, Drawing& drawing) override;
};

} // namespace tractus::silhouette
