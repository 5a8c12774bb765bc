#pragma once

#include "engine/methods/silhouettes/branch.h"
#include "engine/methods/silhouettes/coverage_grid.h"
#include "engine/methods/silhouettes/leaf_blade.h"
#include "engine/methods/silhouettes/outline.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tractus::silhouette {

// A branch of a branching system, with the crown that its own branches fill.
struct Branch {
    enum class Origin {
        Bump, // It ends in a bump of the outline.
        Copy, // Of a sibling, where the crown was empty.
        Gap,  // It fills what no copy could.
        Drawn,
        Apex, // The trunk's own end: it fills the bump that is ahead. The last of its system.
    };
    Origin origin = Origin::Bump;
    // Of a bump its number, of a copy its place (twice the step, and 1 on the right), of a gap its
    // number. With the origin it names the branch; outlines that change a little keep most names.
    std::size_t number = 0;
    BranchCurve path {};
    std::string name {};        // Which it has from an earlier drawing; empty: none (name_of()).
    std::vector<Vec2> crown {}; // Counter-clockwise, or mirrored clockwise.
    double cone_deg = 0;        // Of a bump's.
    bool is_beyond = false;     // It stands on the trunk's continuation.
    // Of a copy: of which of the system's branches, and the way from there; no value: of none.
    std::optional<std::size_t> model {};
    Similarity from_model {};
    // The outline of its crown as somebody drew it (own_outline.h); none: nobody did.
    std::vector<Vec2> own_outline {};
    // The branches that somebody drew on it (own_branch.h), and whom what it bears is a style for.
    std::vector<std::vector<Vec2>> own_branches {};
    StyleTo style_to = StyleTo::None;
    std::string style_from {}; // Of a chosen style the source's path (chosen_style.h).
    // Touches on the bumps of its own outline (bump_touch.h).
    std::vector<BumpTouch> touches {};
    // It ends in a leaf, and bears nothing; no value: it does not.
    std::optional<LeafBlade> leaf {};
    // The stroke that it is on another branch; none: it runs along its curve.
    std::vector<Vec2> stroke {};

    bool is_outlined() const { return !own_outline.empty(); }
    bool is_drawn_leaf() const { return is_outlined() && leaf; }
    bool is_refined() const { return is_outlined() || !own_branches.empty(); }
    // Whether somebody drew it, or on it: it stays where it is.
    bool is_of_hand() const { return origin == Origin::Drawn || is_refined(); }
    // Whether it runs as somebody drew it on another branch.
    bool is_stroke() const { return origin == Origin::Drawn && !stroke.empty(); }

    // The way that it runs, base first: its stroke, or so many points of its curve.
    std::vector<Vec2> line(std::size_t count) const;
};

struct FillOptions {
    int steps = 24;                 // Places along the trunk's run inside, on both sides.
    double first_step = 0.08;       // A share of the run, below which nothing is added.
    std::size_t most_branches = 60; // Of the system, those that are there among them.
    double least_copy = 0.012;      // Of a copy's area, as a share of the outline's.
    double enough = 0.95;           // Of the outline covered: gaps are left then.
    double least_gap = 0.012; // Radius of a gap, as a share of the root of the outline's area.
};

// The crown before it is filled.
struct CrownToFill {
    std::span<Vec2 const> outline;
    std::span<Vec2 const> trunk; // Its samples.
    Run run;                     // Those inside.
    std::optional<Vec2> goes_on; // The end of the trunk's continuation (set_roles()).
    BranchingAngles const& angles;
    std::span<Branch const> branches; // Those that are there: copies are made of them.
    // What the trunk itself covers around its apex; none: nothing.
    std::span<Vec2 const> apex {};
};

struct FilledCrown {
    std::vector<Branch> added;
    double coverage_before = 0; // Shares of the outline's inside that crowns cover.
    double coverage_after = 0;
};

// Adds branches where the crown is empty. From the base to the top on both sides a copy of the
// nearest sibling, turned to the branching angle there and as large as stays inside the outline; if
// more than a fifth of it is covered already, smaller ones are tried (Wither 2009, and sizes). Then
// a branch into the widest gap, again and again, with as much of the gap around its end as is free.
FilledCrown fill_crown(CrownToFill const& crown, FillOptions const& options = {});

} // namespace tractus::silhouette
