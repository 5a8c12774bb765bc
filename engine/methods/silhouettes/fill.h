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

// A branch of a branching system, with the crown that its own branches will fill.
struct Branch {
    enum class Origin {
        Bump,   // A branch that ends in a bump of the outline.
        Copy,   // A copy of a sibling, where the crown was empty.
        Gap,    // A branch that fills a gap too small for a copy.
        Spaced, // A branch to a part of the outline without bumps (spaced_ends.h).
        Drawn,
        // The trunk's own end, which fills the bump ahead. Always the last of a system's branches.
        Apex,
    };
    Origin origin = Origin::Bump;
    // Together with `origin`, identifies the branch; most identifiers survive small changes of the
    // outline. For Bump: the bump's number. For Copy: twice the step along the trunk, plus 1 on the
    // right. For Gap: the gap's number. For Spaced: its position on the outline.
    std::size_t number = 0;
    BranchCurve path {};
    std::string name {}; // Name kept from an earlier drawing; empty: derived from origin and number
                         // (name_of()).
    std::vector<Vec2> crown {}; // Crown of the branch: counter-clockwise, or clockwise if mirrored.
    double cone_deg = 0;    // Opening angle of the crown's cone, for a branch that ends in a bump.
    bool is_beyond = false; // True if the branch's base is on the trunk's extension.
    // For a copy: the index, in the system, of the branch that it copies, and the similarity from
    // that branch to the copy.
    std::optional<std::size_t> model {};
    Similarity from_model {};
    // The drawn outline of the branch's crown (own_outline.h); empty if none was drawn.
    std::vector<Vec2> own_outline {};
    // Strokes of the branches that were drawn on this branch (own_branch.h), and which other
    // branches take their style.
    std::vector<std::vector<Vec2>> own_branches {};
    StyleScope style_to = StyleScope::None;
    // Path of the branch whose style was chosen for this branch (chosen_style.h).
    std::string style_from {};
    // Touches at bumps of the branch's own outline (bump_touch.h).
    std::vector<BumpTouch> touches {};
    // Leaf in which the branch ends, if any; the branch has no children then.
    std::optional<LeafBlade> leaf {};
    // Stroke of a branch that was drawn on another branch; empty: the branch follows `path`.
    std::vector<Vec2> stroke {};

    bool is_outlined() const { return !own_outline.empty(); }
    bool is_drawn_leaf() const { return is_outlined() && leaf; }
    bool is_refined() const { return is_outlined() || !own_branches.empty(); }
    // True if the branch, or something on it, was drawn, so that it keeps its place.
    bool is_user_drawn() const { return origin == Origin::Drawn || is_refined(); }
    // True if the branch follows a stroke that was drawn on another branch.
    bool is_stroke() const { return origin == Origin::Drawn && !stroke.empty(); }

    // Axis of the branch, base first: the stroke, or `count` points of its curve.
    std::vector<Vec2> line(std::size_t count) const;
};

struct FillOptions {
    // Number of positions, along the trunk inside the outline, at which copies are tried on both
    // sides.
    int steps = 24;
    // Share of the trunk inside the outline, from its lower end, where no copies are added.
    double first_step = 0.08;
    // Maximum number of branches of the system, existing ones included.
    std::size_t most_branches = 60;
    double min_copy = 0.012; // Minimum area of a copy, as a share of the outline's area.
    // Filling stops when this share of the outline's area is covered; any remaining gaps stay.
    double enough = 0.95;
    // Minimum length of a branch into a gap, as a share of the diagonal of the outline's box.
    double min_length = 0;
    // Minimum radius of a gap to fill, as a share of the square root of the outline's area.
    double min_gap = 0.012;
};

// Input of fill_crown(): the crown with its branches so far.
struct CrownToFill {
    std::span<Vec2 const> outline;
    std::span<Vec2 const> trunk; // Trunk samples, equally spaced.
    Run run;                     // Range of the trunk samples inside the outline.
    std::optional<Vec2> goes_on; // End of the trunk's extension, if there is one (set_roles()).
    BranchingAngles const& angles;
    std::span<Branch const> branches; // Existing branches; copies are made of these.
    // Outline of the area that the trunk itself covers around its apex; empty if there is none.
    std::span<Vec2 const> apex {};
};

struct FilledCrown {
    std::vector<Branch> added;
    // Shares of the outline's area that crowns cover before and after filling.
    double coverage_before = 0;
    double coverage_after = 0;
};

// Adds branches where the crown is empty. First, copies of the nearest sibling are added from base
// to top on both sides, rotated to the local branching angle and as large as fits inside the
// outline. If more than a fifth of a copy's crown is covered already, smaller copies are tried
// (Wither 2009; the smaller copies are an extension). Then a branch is added into the widest gap,
// repeatedly; its crown is the free area around its end.
FilledCrown fill_crown(CrownToFill const& crown, FillOptions const& options = {});

} // namespace tractus::silhouette
