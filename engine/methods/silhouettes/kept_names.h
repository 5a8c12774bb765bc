#pragma once

#include "engine/methods/silhouettes/skeleton.h"

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace tractus::silhouette {

// What is inferred of a drawing, and what a later drawing is compared with.
struct InferredDrawing {
    Skeleton skeleton {};
    // Its systems without what was drawn on their branches; empty where nothing was.
    std::vector<BranchingSystem> as_inferred {};

    BranchingSystem const& bare(std::size_t system) const
    {
        return as_inferred.empty() ? skeleton.systems[system] : as_inferred[system];
    }
};

// Gives branches of a tree whose lines have changed the names that they had in the one before
// (match.h); those that are new get names that begin with `fresh`. What was drawn on branches goes
// with the names: an outline whose branch is gone goes to the branch of its parent that it lies
// around, if that has none, and a branch whose parent is gone to a new one that it begins on. What
// stands on those goes with them.
class KeptNames final : public BranchNamer {
public:
    // What it is given must outlive it.
    KeptNames(InferredDrawing const& earlier, std::string fresh)
        : earlier_(earlier)
        , fresh_(std::move(fresh))
    {
    }

    void name(NewSystem const& made, Drawing& drawing) override;

    // Of all branches that are named.
    BranchNames const& names() const { return names_; }

    // Of each system what it is without what was drawn on its branches; empty where nothing was.
    std::vector<BranchingSystem> take_systems() { return std::move(systems_); }

    // Whether a path has borne branches twice, the ones in place of the others, which names alone
    // cannot tell apart.
    bool has_borne_twice() const { return has_borne_twice_; }

private:
    using Partners = std::vector<std::optional<std::size_t>>;

    std::optional<std::size_t> earlier_system(NewSystem const& made) const;

    InferredDrawing const& earlier_;
    std::string fresh_;
    BranchNames names_;
    std::vector<BranchingSystem> systems_;
    std::set<std::string> parents_; // Whose branches were named.
    bool has_borne_twice_ = false;
    std::vector<std::optional<std::size_t>> earlier_of_; // Of each later system.
    std::vector<Partners> partners_;                     // Of its branches.
};

// Infers a drawing. Fails like infer_skeleton().
Result<InferredDrawing> infer_drawing(Drawing const& drawing, SkeletonOptions const& options);

// The names of a drawing's branches where its lines have changed.
struct Renamed {
    BranchNames names {};
    // The drawing as it is with these names, since they cannot be found without; no value: it is to
    // be inferred with them once more, because lines on branches have gone to others.
    std::optional<InferredDrawing> inferred {};
};

// The names of the later drawing, by those of the earlier one. Says in it of which branches its
// lines are. A crown that is a leaf has the names that it would have without, and so must have the
// earlier one. Fails like infer_skeleton().
Result<Renamed> kept_names(InferredDrawing const& earlier, Drawing& after, SkeletonOptions options,
                           std::string const& fresh);

// A drawing, and how its branches are inferred.
struct DrawingToInfer {
    Drawing const& drawing;
    SkeletonOptions const& options;
};

// Likewise, after a drawing that is inferred for this.
Result<Renamed> kept_names(DrawingToInfer const& before, Drawing& after,
                           SkeletonOptions const& options, std::string const& fresh);

// Finds branches again for what was drawn on them, where the tree had no crown for a while: names
// say nothing of those of the trunk before.
class FoundAgain final : public BranchNamer {
public:
    void name(NewSystem const& made, Drawing& drawing) override;
};

} // namespace tractus::silhouette
