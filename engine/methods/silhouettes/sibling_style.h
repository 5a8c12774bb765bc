#pragma once

#include "engine/methods/silhouettes/skeleton.h"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace tractus::silhouette {

// How a branch bears its own branches (Wither 2009, section 4.2): those in the plane, without what
// goes on from its tip.
struct ParentStyle {
    // One that it bears: what a sibling's is a copy of.
    struct Child {
        double u = 0; // Its place, a share of the parent's length.
        double angle_deg = 0;
        Branch branch; // With its side of the parent.
    };

    double t = 0; // The parent's place on the trunk,
    Side side = Side::Left;
    double length = 0;              // and its own length, in the unit of its system.
    std::vector<Child> children {}; // From the parent's base on; at least one.
    double spacing = 0;             // From one to the next on average, in that unit; 0 for one.
    double deviation = 0;           // Of that.
    bool is_of_own_outline = false;
    bool goes_deeper = false; // StyleTo::Deeper.

    // Shares of the parent's length below which, and above which it bears none.
    double unbranched() const { return children.front().u; }
    double last() const { return children.back().u; }
    double mean_angle_deg() const;
};

// What a branch bears; without children: nothing.
ParentStyle parent_style(Branch const& parent, BranchingSystem const& system);

// Replaces what a branch's system bears by branches in the style of siblings that somebody drew on:
// of the two next to it on the trunk, or of the one that there is. Where they begin and end are the
// sources' shares of its length. Distances have the sources' mean and deviation as lengths, angles
// follow theirs from place to place, sides change as theirs do, seen from the trunk. Each is a copy
// of the child whose place is nearest on its side, as large as stays in the crown: from a third of
// to one and a half times of what the parents' lengths make it.
//
// `sources` are at least one, in order of t.
void take_style(BranchingSystem& system, Branch const& parent, std::span<ParentStyle const> sources,
                std::uint64_t seed);

// Ends a branch in the leaf of another one, in the same place on it: as large, on a shorter branch
// as much smaller as that is, and smaller where more than a tenth of it would leave the outline,
// down to a third.
void take_leaf(Branch& branch, Branch const& source, std::span<Vec2 const> outline);

// Ends branches of a system in leaves: those that nobody drew on and for which `may` says so, where
// the nearest along the parent of the branches whose style is for their siblings is a leaf. The
// system's own end is among them.
void spread_leaves(BranchingSystem& system, std::function<bool(Branch const&)> const& may);

// Whether all of a system's branches are leaves, of which it has some.
bool bears_leaves_alone(BranchingSystem const& system);

} // namespace tractus::silhouette
