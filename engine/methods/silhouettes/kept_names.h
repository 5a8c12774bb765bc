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

// The result of inferring a drawing, with which a later drawing is compared.
struct InferredDrawing {
    Skeleton skeleton {};
    // Systems of the skeleton before drawn parts were applied to their branches; empty if nothing
    // was drawn on branches.
    std::vector<BranchingSystem> as_inferred {};

    BranchingSystem const& bare(std::size_t system) const
    {
        return as_inferred.empty() ? skeleton.systems[system] : as_inferred[system];
    }
};

// Keeps the names of branches when a tree's lines change: matched branches (match.h) get their
// earlier names, and new ones get names that begin with `fresh`. Lines drawn on branches follow the
// names. An outline whose branch is gone moves to the branch of the same parent that it surrounds,
// if that one has no outline yet. A drawn branch whose parent is gone moves to the new branch on
// which it begins. Lines, touches and styles on a moved branch or below it move, too.
class KeptNames final : public BranchNamer {
public:
    // The arguments must outlive the object.
    KeptNames(InferredDrawing const& earlier, std::string fresh)
        : earlier_(earlier)
        , fresh_(std::move(fresh))
    {
    }

    void name(NewSystem const& made, Drawing& drawing) override;

    // Names of all branches named so far.
    BranchNames const& names() const { return names_; }

    // The systems before drawn parts were applied to their branches; empty if nothing was drawn on
    // branches.
    std::vector<BranchingSystem> take_systems() { return std::move(systems_); }

    // True if inference replaced the children of some branch by other children, so that the paths
    // of these children are not unique.
    bool has_replaced_children() const { return has_replaced_children_; }

private:
    using Partners = std::vector<std::optional<std::size_t>>;

    std::optional<std::size_t> earlier_system(NewSystem const& made) const;

    InferredDrawing const& earlier_;
    std::string fresh_;
    BranchNames names_;
    std::vector<BranchingSystem> systems_;
    std::set<std::string> parents_; // Paths whose children have been named.
    bool has_replaced_children_ = false;
    // Index of the matching earlier system, for each later system.
    std::vector<std::optional<std::size_t>> earlier_of_;
    // For each branch of each later system, the index of the matching earlier branch.
    std::vector<Partners> partners_;
};

// Infers a drawing. Fails like infer_skeleton().
Result<InferredDrawing> infer_drawing(Drawing const& drawing, SkeletonOptions const& options);

// Names of a drawing's branches after its lines have changed.
struct Renamed {
    BranchNames names {};
    // The inference of the drawing with these names, a by-product of finding them. No value if
    // lines have moved to other branches; the drawing must be inferred again then.
    std::optional<InferredDrawing> inferred {};
};

// Names for the branches of `after`, based on those of the earlier drawing. Updates in `after`
// which branches its lines belong to. While a crown is declared a leaf, its branches keep the names
// that they would have without that declaration; `earlier` must be inferred without it, too. Fails
// like infer_skeleton().
Result<Renamed> kept_names(InferredDrawing const& earlier, Drawing& after, SkeletonOptions options,
                           std::string const& fresh);

// A drawing with the options for inferring it.
struct DrawingToInfer {
    Drawing const& drawing;
    SkeletonOptions const& options;
};

// Names the branches of a changed drawing like the other kept_names(), but first infers the earlier
// drawing.
Result<Renamed> kept_names(DrawingToInfer const& before, Drawing& after,
                           SkeletonOptions const& options, std::string const& fresh);

// Reassigns lines to branches when a tree gets a crown again that it had lost: the names of the
// trunk's former branches then no longer mean anything.
class ReassigningNamer final : public BranchNamer {
public:
    void name(NewSystem const& made, Drawing& drawing) override;
};

} // namespace tractus::silhouette
