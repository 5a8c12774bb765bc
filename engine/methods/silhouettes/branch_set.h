#pragma once

#include "engine/methods/silhouettes/arrangement.h"
#include "engine/methods/silhouettes/crown_surface.h"
#include "engine/methods/silhouettes/line.h"
#include "engine/methods/silhouettes/skeleton.h"
#include "engine/methods/silhouettes/tree.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace tractus::silhouette {

// A branch of a system, placed around its parent.
struct PositionedBranch {
    // Index of the branch in its system, or of the branch that it copies.
    std::size_t branch = 0;
    std::string name;
    double u = 0;
    double theta_deg = 0;
    Similarity way; // Transform within the system's plane, before the rotation about the parent.
};

// The branches of a system, placed in space.
struct BranchSet {
    Line parent { { Vec2::Zero(), Vec2::UnitY() } };
    std::vector<PositionedBranch> branches; // Branches sorted by u.
};

// Distributes the branches of systems around their parents and adds further branches that end at
// the crown's surface. Both constructor arguments must outlive the object.
class BranchSetMaker {
public:
    BranchSetMaker(Skeleton const& skeleton, TreeOptions const& options)
        : skeleton_(skeleton)
        , options_(options)
    {
    }

    // The surface of a system's crown; for the whole tree the drawn surface, if there is one.
    CrownSurface surface_of(std::size_t index) const;

    // Distributes a system's branches; every parent with this system gets the same arrangement.
    BranchSet make(std::size_t index, LevelOptions const& level) const;

    // A system, its crown's surface, and the positions of its visible branches without the apex
    // branch.
    struct Model {
        BranchingSystem const& system;
        CrownSurface const& surface;
        std::vector<DrawnPlace> const& drawn;
    };
    static std::vector<DrawnPlace> drawn_places(Line const& parent, CrownSurface const& surface,
                                                BranchingSystem const& system);
    // The visible branch that an added branch at this position copies; no value if no branch is
    // visible.
    static std::optional<std::size_t> nearest_drawn(Model const& model, Place const& place);

    // Adds the visible branch `i`. `place` has the position where it was inferred; `moves_to` is
    // the position along the parent at which its base is placed.
    static void stand(BranchSet& branch_set, Model const& model, std::size_t i, Place const& place,
                      double moves_to);

    // Direction in which an added branch leaves its parent, its smallest allowed scale relative to
    // the branch that it copies, and what happens to smaller branches.
    struct Lean {
        // Vector in the copied branch that is rotated to the angle `angle_deg` with the parent.
        Vec2 from = Vec2::UnitX();
        double angle_deg = 0;
        double least = 0.15;
        enum class Smaller { LeftOut, Least } smaller = Smaller::LeftOut;
    };
    static void place_added_branch(BranchSet& branch_set, Model const& model, Place const& place,
                                   std::size_t nearest, Lean const& lean);

    // Adds the apex branch, if there is one, and sorts the branches by u.
    static void finish(BranchSet& branch_set, BranchingSystem const& system);

    // The similarity that moves a branch's base to `from` and leaves its end where it is.
    static Similarity similarity_to_end(Branch const& branch, Vec2 const& from);

    // Axis of a branch. `below` is the index of the system of its children, kNoSystem if it has no
    // children.
    std::vector<Vec2> line_of(Branch const& model, std::size_t below) const;

private:
    void place_in_plane(BranchSet& branch_set, Model const& model, std::size_t i,
                        Place const& place) const;
    Lean lean_of(Branch const& branch, Place const& place, Lean::Smaller smaller) const;
    static std::string name_of_added_branch(BranchSet const& branch_set, Place const& place);

    Skeleton const& skeleton_;
    TreeOptions const& options_;
};

} // namespace tractus::silhouette
