#pragma once

#include "engine/base/result.h"
#include "engine/methods/silhouettes/meridian.h"
#include "engine/methods/silhouettes/plane.h"

#include <map>
#include <span>
#include <string>
#include <vector>

namespace tractus::silhouette {

// Which branches take the style of a branch that was drawn on (sibling_style.h).
enum class StyleScope {
    None,
    Siblings, // Siblings that were not drawn on.
    // Siblings, and the descendants of the siblings and of the branch itself, down to the last
    // level.
    Deeper,
};

// The drawn outline of one branch's crown.
struct OwnOutline {
    std::string branch; // Path of the branch (Skeleton::at(), skeleton.h).
    std::vector<Vec2> outline;
    StyleScope style_to = StyleScope::None; // Branches that take this branch's style.
    // True if the branch is declared a leaf, which ends the recursion (leaf_blade.h).
    bool is_leaf = false;
};

// A branch that was drawn on another branch (own_branch.h).
struct OwnBranch {
    std::string branch; // Path of the parent branch.
    std::vector<Vec2> line;
    StyleScope style_to = StyleScope::None; // Branches that take the parent's style.
};

// A touch at the bumps of a drawn outline (bump_touch.h).
struct BumpTouch {
    enum class Kind {
        Split, // Splits a bump, which makes two branches of one.
        Join,  // Joins two bumps, which makes one branch of two.
    } kind
        = Kind::Split;
    Vec2 place = Vec2::Zero();
    std::string branch {}; // Path of the branch that the outline belongs to; "": the crown.
};

// Chosen styles (chosen_style.h): maps the path of a branch to the path of the branch whose style
// it takes.
using ChosenStyles = std::map<std::string, std::string>;

// The lines drawn for one branching system (Wither, Boudon, Cani, Godin, "Structure from
// silhouettes", 2009), in millimetres of the drawing plane (plane.h).
struct Drawing {
    // The crown's outline: one stroke or more, in any order.
    std::vector<std::vector<Vec2>> outline;
    std::vector<Vec2> trunk;                    // Trunk, base first; empty if none was drawn.
    std::vector<std::vector<Vec2>> branches {}; // Branches of the trunk; each begins near it.
    // Drawn crowns of branches, at most one each (own_outline.h).
    std::vector<OwnOutline> own_outlines {};
    std::vector<OwnBranch> own_branches {}; // Branches drawn on branches (own_branch.h).
    ChosenStyles styles {};
    std::vector<BumpTouch> touches {}; // Touches at bumps, in the order in which they were made.
    // True if the crown's outline is declared a leaf, which ends the recursion.
    bool is_leaf = false;
    // The crown's surface if it was drawn in space (drawn_surface.h); empty: derived from the
    // outline.
    std::vector<Meridian> surface {};

    bool is_refined() const { return !own_outlines.empty() || !own_branches.empty(); }
};

// True if a stroke is closed: the gap between its ends is at most a quarter of its length. A closed
// stroke is an outline, an open one a branch.
bool is_closed_stroke(std::span<Vec2 const> stroke);

// Maximum number of points in all strokes of a drawing together.
constexpr std::size_t kMaxDrawnPoints = 20'000;

// Options for preparing an outline.
struct OutlineOptions {
    std::size_t samples = 256;    // Number of samples around the outline, 16 to 512.
    double smoothing_samples = 1; // Standard deviation of the Gaussian filter, in samples; 0: none.
    double min_area_mm2 = 25;
};

// A drawing prepared for inference: a simple outline, counter-clockwise and equally spaced, and the
// trunk. It is in a normalised frame: the trunk's end is above its base, and the diagonal of the
// outline's bounding box is 1. Coordinates are rounded, so that a drawing that was moved, turned or
// scaled gives an identical inference.
struct CleanDrawing {
    std::vector<Vec2> outline;
    std::vector<Vec2> trunk;                    // Trunk as 64 equally spaced points, base first.
    std::vector<std::vector<Vec2>> branches {}; // Strokes of branches; none degenerates to a point.
    std::vector<BumpTouch> touches {};          // Touches at bumps of this outline.
    Similarity to_sheet; // Transform from the normalised frame to millimetres of the drawing.
    std::vector<std::string> notes; // Assumptions made and parts ignored, one sentence each.
};

constexpr std::size_t kTrunkSamples = 64;

// Prepares a drawing: joins outline strokes whose ends are near each other, closes the outline,
// cuts off overshooting ends, keeps the largest loop of an outline that crosses itself, resamples
// the outline at equal distances and filters out the tremor of the hand. Samples begin where the
// outline is farthest from the trunk's base. If no trunk was drawn, a trunk is added: it rises from
// the outline's lowest point under the centroid to 85 % of the outline's height.
//
// Fails with a user error if the outline is missing, too small (25 mm², eight points) or open by
// more than a quarter of its length, if the trunk is a dot, or if there are too many points or
// non-finite numbers.
Result<CleanDrawing> clean_drawing(Drawing const& drawing, OutlineOptions const& options = {});

} // namespace tractus::silhouette
