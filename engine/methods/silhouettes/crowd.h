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

// A branch of a system where it stands around its parent.
struct Standing {
    std::size_t branch = 0; // Of the system: itself, or the one that it is a copy of.
    std::string name;
    double u = 0;
    double theta_deg = 0;
    Similarity way; // In the system's plane, before it is turned around the parent.
};

// A system's branches in space.
struct Crowd {
    Line parent { { Vec2::Zero(), Vec2::UnitY() } };
    std::vector<Standing> branches; // By u.
};

// Spreads the branches of systems around their parents, with others between them that end at the
// crown's surface. Both that it is given must outlive it.
class CrowdMaker {
public:
    CrowdMaker(Skeleton const& skeleton, TreeOptions const& options)
        : skeleton_(skeleton)
        , options_(options)
    {
    }

    // Of a system's crown: the one that was drawn for the whole tree's, where one was.
    CrownSurface surface_of(std::size_t index) const;

    // Spreads a system's branches alike for all parents that have it.
    Crowd make(std::size_t index, LevelOptions const& level) const;

    // A system, with its branches in the plane but the apex.
    struct Model {
        BranchingSystem const& system;
        CrownSurface const& surface;
        std::vector<DrawnPlace> const& drawn;
    };
    static std::vector<DrawnPlace> drawn_places(Line const& parent, CrownSurface const& surface,
                                                BranchingSystem const& system);
    // The branch in the plane that one at this place is a copy of; no value: there is none.
    static std::optional<std::size_t> nearest_drawn(Model const& model, Place const& place);

    // Adds one in the plane, where it was inferred or at the place to which it moves.
    static void stand(Crowd& crowd, Model const& model, std::size_t i, Place const& place,
                      double moves_to);

    // How an added branch leaves its parent, and how small it may be, of the one it is a copy of.
    struct Lean {
        Vec2 from = Vec2::UnitX(); // Which way of its model has the angle.
        double angle_deg = 0;
        double least = 0.15;
        enum class Smaller { LeftOut, Least } smaller = Smaller::LeftOut;
    };
    static void stand_added(Crowd& crowd, Model const& model, Place const& place,
                            std::size_t nearest, Lean const& lean);

    // Puts the branches in order, the trunk's end last.
    static void finish(Crowd& crowd, BranchingSystem const& system);

    // From a branch as it is to one from another place to the same end.
    static Similarity way_to_end(Branch const& branch, Vec2 const& from);

    // The axis of a branch whose own system is `below`, if it has one.
    std::vector<Vec2> line_of(Branch const& model, std::size_t below) const;

private:
    void stand_in_plane(Crowd& crowd, Model const& model, std::size_t i, Place const& place) const;
    Lean lean_of(Branch const& branch, Place const& place, Lean::Smaller smaller) const;
    static std::string name_of_added(Crowd const& crowd, Place const& place);

    Skeleton const& skeleton_;
    TreeOptions const& options_;
};

} // namespace tractus::silhouette
