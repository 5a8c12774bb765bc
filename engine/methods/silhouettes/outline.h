#pragma once

#include "engine/base/result.h"
#include "engine/methods/silhouettes/meridian.h"
#include "engine/methods/silhouettes/plane.h"

#include <map>
#include <span>
#include <string>
#include <vector>

namespace tractus::silhouette {

// Whom the style of a branch that somebody drew on goes to (sibling_style.h).
enum class StyleTo {
    None,
    Siblings, // The branches beside it that nobody drew on,
    Deeper,   // and those that stand on these and on it, as far down as branches branch.
};

// The outline of one branch's crown, as it was drawn.
struct OwnOutline {
    std::string branch; // The path of the branch that has it (Skeleton::at(), skeleton.h).
    std::vector<Vec2> outline;
    StyleTo style_to = StyleTo::None; // Of the branch.
    bool is_leaf = false;             // It ends the recursion (leaf_blade.h).
};

// A branch that was drawn on a branch (own_branch.h).
struct OwnBranch {
    std::string branch; // The path of its parent.
    std::vector<Vec2> line;
    StyleTo style_to = StyleTo::None; // Of its parent.
};

// A touch on the bumps of an outline that somebody drew (bump_touch.h).
struct BumpTouch {
    enum class Kind {
        Split, // Two branches in place of one.
        Join,  // One in place of two.
    } kind
        = Kind::Split;
    Vec2 place = Vec2::Zero();
    std::string branch {}; // The path of the branch whose own outline it is; "": the crown.
};

// Branches that somebody gave the style of another one (chosen_style.h): their paths, and its.
using ChosenStyles = std::map<std::string, std::string>;

// What is drawn for one branching system (Wither, Boudon, Cani, Godin, "Structure from
// silhouettes", 2009), millimetres in the plane that it was drawn in (plane.h).
struct Drawing {
    std::vector<std::vector<Vec2>> outline;     // Of the crown: one stroke or more, in any order.
    std::vector<Vec2> trunk;                    // Base first; empty: not drawn.
    std::vector<std::vector<Vec2>> branches {}; // On the trunk, which they begin near.
    // The crowns of branches, one for each (own_outline.h).
    std::vector<OwnOutline> own_outlines {};
    std::vector<OwnBranch> own_branches {}; // On branches.
    ChosenStyles styles {};
    std::vector<BumpTouch> touches {}; // One after the other.
    bool is_leaf = false;              // The crown's outline ends the recursion.
    // The crown's surface, where it was drawn in space (drawn_surface.h); empty: the one that the
    // outline stands for.
    std::vector<Meridian> surface {};

    bool is_refined() const { return !own_outlines.empty() || !own_branches.empty(); }
};

// Whether a stroke ends near its beginning, by a quarter of its length: it is an outline then, and
// else a branch.
bool comes_back(std::span<Vec2 const> stroke);

constexpr std::size_t kMostDrawnPoints = 20'000; // Of all strokes of a drawing.

// How an outline is read.
struct OutlineOptions {
    std::size_t samples = 256;    // 16 to 512.
    double smoothing_samples = 1; // Standard deviation of the Gaussian; 0: none.
    double least_area_mm2 = 25;
};

// A drawing made ready: a simple outline, counter-clockwise, in equal steps, and the trunk. In a
// frame of its own, in which the trunk's end is above its base and the diagonal of the outline's
// box has length 1, rounded: so a drawing that is moved, turned or scaled is the very same from
// here on.
struct CleanDrawing {
    std::vector<Vec2> outline;
    std::vector<Vec2> trunk;                    // 64 points at equal distances, base first.
    std::vector<std::vector<Vec2>> branches {}; // As drawn; none is a dot.
    std::vector<BumpTouch> touches {};          // Those of this outline.
    Similarity to_sheet;                        // Back to the drawing's millimetres.
    std::vector<std::string> notes; // What had to be guessed or was left out, a sentence each.
};

constexpr std::size_t kTrunkSamples = 64;

// Joins strokes of an outline whose ends are near each other, closes it, cuts off ends that
// overshoot, keeps the largest loop of one that crosses itself, takes steps of equal length and the
// hand's tremor out; samples begin where the outline is farthest from the trunk's base. Without a
// trunk one rises from the outline's lowest point under its centroid to 85 % of its height.
//
// Fails, as the user's fault: an outline that is missing, too small (25 square millimetres, eight
// points) or open by more than a quarter of its length, a trunk that is a dot, too many points,
// numbers that are not finite.
Result<CleanDrawing> clean_drawing(Drawing const& drawing, OutlineOptions const& options = {});

} // namespace tractus::silhouette
