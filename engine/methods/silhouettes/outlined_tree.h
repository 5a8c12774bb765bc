#pragma once

#include "engine/base/result.h"
#include "engine/methods/silhouettes/bump_leaf.h"
#include "engine/methods/silhouettes/bump_touch.h"
#include "engine/methods/silhouettes/crown_line.h"
#include "engine/methods/silhouettes/outline.h"
#include "engine/methods/silhouettes/own_branch.h"
#include "engine/methods/silhouettes/skeleton.h"
#include "engine/methods/silhouettes/tree_form.h"
#include "engine/scene/anchored.h"
#include "engine/scene/plant_source.h"
#include "engine/stroke/stroke.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tractus::silhouette {

class InferredTrees; // Defined in inferred_trees.h.

// A drawn branch of the trunk; `id` is that of the edit that added it.
struct DrawnBranch {
    scene::ItemId id = 0;
    Stroke stroke {};
};

// A line drawn on a branch: the outline of the branch's crown, or one of its children; `id` is that
// of the edit that added it. The branch's path is determined when the line is drawn (own_outline.h,
// own_branch.h). While the tree has no such branch, the line is kept but has no effect.
struct DrawnOnBranch {
    scene::ItemId id = 0;
    Stroke stroke {};
    std::string branch {};
    StyleScope style_to = StyleScope::None;
    // True for an outline that is declared a leaf, which ends the recursion (leaf_blade.h).
    bool is_leaf = false;
    // True for an outline that was made by a touch at a bump instead of drawn (bump_leaf.h).
    bool of_bump = false;
};

// A touch at a bump; `id` is that of the edit that added it. The path of the branch whose outline
// has the bump is determined when the touch is made. While there is no such bump, the touch is kept
// but has no effect.
struct DrawnTouch {
    scene::ItemId id = 0;
    Stroke stroke {}; // Stroke of the touch; only its midpoint counts.
    BumpTouch::Kind kind = BumpTouch::Kind::Split;
    // Path of the branch whose outline has the bump; "": the crown's outline has it.
    std::string branch {};
};

// A line in space on the crown's surface (drawn_surface.h); `id` is that of the edit that added it.
struct DrawnCrownLine {
    scene::ItemId id = 0;
    // Stroke with x and y on the sheet, like all strokes, and z as the distance behind the sheet,
    // in millimetres.
    Stroke stroke {};
};

// A tree as drawn on paper: strokes in tablet-centred millimetres (x and y only; the height of the
// surface is ignored). It is the source of a plant (plant_source.h).
struct OutlinedTree {
    static scene::SourceKind const kKind;

    Stroke trunk {};   // Stroke of the trunk from the foot upwards; empty if none was drawn.
    Stroke outline {}; // Stroke around the crown; empty if none was drawn.
    std::vector<DrawnBranch> branches {};
    // Names of branches, kept across changes of the lines; empty: see name_of().
    BranchNames names {};
    TreeForm form {};
    double scale = 0.1;                         // World millimetres per plant millimetre.
    std::vector<DrawnOnBranch> own_outlines {}; // Outlines of branches, at most one per branch.
    std::vector<DrawnOnBranch> own_branches {}; // Branches drawn on branches, any number.
    // Chosen styles; entries whose branches do not exist at present are kept.
    ChosenStyles styles {};
    std::vector<DrawnTouch> touches {}; // Touches at bumps, in the order in which they were made.
    bool is_leaf = false;               // True if the crown's outline is declared a leaf.
    std::vector<DrawnCrownLine> crown_lines {}; // Lines that define the crown's surface in space.
    // Position of the trunk's foot on the paper while no trunk is drawn, for a tree begun with a
    // line in space.
    std::optional<Vec2> ground_mm {};
    // Length of the straight extension of a trunk whose tip is just below the crown
    // (trunk_reach.h), in millimetres on the paper; 0: none.
    double trunk_goes_on_mm = 0;
    // True: while the tree has no style of its own, its form takes the style of the nearest tree
    // that has one (nearest_style.h).
    bool takes_style = false;
    scene::ItemId turned_line = 0; // Id of the newest line if it was reversed, otherwise 0.
    // Cache of inference results, shared by all versions of the tree; null: nothing is cached. Not
    // part of the tree's value.
    std::shared_ptr<InferredTrees> inferred {};

    // True if branches can be inferred: there is an outline or a crown surface.
    bool has_crown() const { return !outline.tips.empty() || !crown_lines.empty(); }
    bool is_refined() const { return !own_outlines.empty() || !own_branches.empty(); }
};

// Returns the options for inferring a tree's branches, with their kept names.
SkeletonOptions options_of(OutlinedTree const& tree);

Result<Drawing> drawing_of(OutlinedTree const& tree);

// Position of the trunk's foot on the paper. Fails like build_tree().
Result<Vec2> foot_of(OutlinedTree const& tree);

// The skeleton inferred from the lines, in millimetres on the paper. Fails with a user error if
// there is no outline, and like infer_skeleton().
Result<Skeleton> skeleton_of(OutlinedTree const& tree);

// Path of the branch whose crown a stroke outlines (own_outline.h); no value if the stroke outlines
// no branch, or if the tree has no outline. Fails like skeleton_of().
Result<std::optional<std::string>>
branch_outlined_by(OutlinedTree const& tree, Stroke const& stroke, Search search = Search::OnTrunk);

// Description of a line that is to be added to a branch.
struct LineOnBranch {
    scene::ItemId id = 0;
    StyleScope style_to = StyleScope::None;
    Search search = Search::OnTrunk;
    bool is_leaf = false; // True: declare the outline a leaf.
    bool of_bump = false; // True: the outline was inferred from a touched bump instead of drawn.
};

// The branch that ends in the bump at a stroke's midpoint (leaf_on_bump(), bump_leaf.h). Fails like
// skeleton_of().
Result<std::optional<BumpLeaf>> leaf_on_bump(OutlinedTree const& tree, Stroke const& stroke,
                                             Search search);

// Adds a stroke as the outline of the branch that it surrounds, replacing an earlier outline. Fails
// with a user error if the stroke surrounds no branch, and like clean_drawing().
Result<OutlinedTree> with_own_outline(OutlinedTree tree, Stroke const& stroke,
                                      LineOnBranch const& line);

// For a stroke that draws a branch on another branch (own_branch.h): the path of that other branch,
// and the tree with the stroke added. The functions correspond to branch_outlined_by() and
// with_own_outline().
Result<std::optional<std::string>> parent_of_drawn_branch(OutlinedTree const& tree,
                                                          Stroke const& stroke,
                                                          Search search = Search::OnTrunk);
Result<OutlinedTree> with_own_branch(OutlinedTree tree, Stroke const& stroke,
                                     LineOnBranch const& line);

// The style choices that a stroke stands for (copied_by(), chosen_style.h), and the tree with such
// choices. Fail like copied_by(), choose_styles() and skeleton_of().
Result<ChosenStyles> styles_copied_by(OutlinedTree const& tree, Stroke const& stroke);
Result<OutlinedTree> with_styles(OutlinedTree tree, ChosenStyles const& chosen);

// Adds a touch at a bump, or removes the earlier touch that it undoes. Fails like touched()
// (bump_touch.h).
Result<OutlinedTree> with_touch(OutlinedTree tree, DrawnTouch touch, Search search);

// Position of a touch on the paper: the midpoint of its stroke.
Result<Vec2> place_of(DrawnTouch const& touch);

// Id of the smallest drawn outline around a stroke's midpoint; 0 for the crown's outline, no value
// if no outline surrounds the midpoint.
Result<std::optional<scene::ItemId>> outline_around(OutlinedTree const& tree, Stroke const& stroke);

// Adds a line on the crown's surface and removes the lines that it replaces (takes_place_of(),
// crown_line.h). An outline whose plane is within eight degrees of the sheet becomes the crown's
// outline. Fails like kind_of().
Result<OutlinedTree> with_crown_line(OutlinedTree tree, DrawnCrownLine line);

Result<CrownLine> crown_line_of(Stroke const& stroke);

// Number of lines on branches, touches at bumps and chosen styles that have no effect because their
// branch or bump does not exist. Fails like infer_system().
Result<std::size_t> count_without_effect(OutlinedTree const& tree);

// After the lines of a tree have changed from `before` to `after`, keeps the names of its branches
// and the assignment of lines to branches (kept_names.h). Does nothing if there is no outline.
Result<void> keep_names(OutlinedTree const& before, OutlinedTree& after, std::string const& fresh);

// Builds the plant, with its foot at the origin: shown at the tree's scale, it is as large as
// drawn. Without an outline it is a bare stem along the trunk. Fails with a user error if there is
// neither outline nor trunk, or if the trunk is a dot, and like infer_skeleton() and check_form().
//
// Caches the inferred skeleton for later versions of the tree.
Result<scene::BuiltSource> build_tree(OutlinedTree const& tree,
                                      scene::LoadOptions const& options = {});

} // namespace tractus::silhouette
