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

class InferredTrees; // inferred_trees.h

// A branch that was drawn, by the edit that brought it.
struct DrawnBranch {
    scene::ItemId id = 0;
    Stroke stroke {};
};

// What was drawn on a branch, the outline of its own crown or a branch that it bears, by the edit
// that brought it. The path of the branch is found when it is drawn (own_outline.h, own_branch.h);
// where the tree has no such branch any more, it waits.
struct DrawnOnBranch {
    scene::ItemId id = 0;
    Stroke stroke {};
    std::string branch {};
    StyleTo style_to = StyleTo::None;
    bool is_leaf = false; // An outline: it ends the recursion (leaf_blade.h).
    bool of_bump = false; // An outline that nobody drew: a touch on a bump made it (bump_leaf.h).
};

// A touch on a bump, by the edit that brought it. The path of the branch whose outline has the bump
// is found when it is drawn; where there is no such bump any more, it waits.
struct DrawnTouch {
    scene::ItemId id = 0;
    Stroke stroke {}; // Its middle counts.
    BumpTouch::Kind kind = BumpTouch::Kind::Split;
    std::string branch {}; // "": it is on the crown's outline.
};

// A line in space on the crown's surface (drawn_surface.h), by the edit that brought it.
struct DrawnCrownLine {
    scene::ItemId id = 0;
    Stroke stroke {}; // Its x and y are on the sheet as of all strokes; z is how far behind it is.
};

// A tree as it is drawn on paper: strokes whose x and y are tablet-centred millimetres; how high
// the surface was counts for nothing. The source of a plant (plant_source.h).
struct OutlinedTree {
    static scene::SourceKind const kKind;

    Stroke trunk {};   // From the foot upwards; without tips: not drawn.
    Stroke outline {}; // Once around the crown; likewise.
    std::vector<DrawnBranch> branches {};
    BranchNames names {}; // So that they outlast other lines; none: see name_of().
    TreeForm form {};
    double scale = 0.1;                         // World millimetres per plant millimetre.
    std::vector<DrawnOnBranch> own_outlines {}; // Of branches, one for each.
    std::vector<DrawnOnBranch> own_branches {}; // On them, as many as were drawn.
    ChosenStyles styles {};                     // Where branches are gone, styles wait.
    std::vector<DrawnTouch> touches {};         // On bumps, one after the other.
    bool is_leaf = false;                       // The crown's outline is one.
    std::vector<DrawnCrownLine> crown_lines {}; // They say its surface in space.
    // Where the trunk's foot is on the paper as long as none is drawn, of a tree that begins with
    // such a line.
    std::optional<Vec2> ground_mm {};
    // How far the trunk goes on straight from its tip, which is just below the crown
    // (trunk_reach.h), on the paper; 0: it ends there.
    double trunk_goes_on_mm = 0;
    // Its form's style is that of the nearest tree that has one, as long as it has none of its own
    // (nearest_style.h).
    bool takes_style = false;
    // Shared by all versions of the tree; null: nothing is kept of what is inferred of it. It says
    // nothing about the tree.
    std::shared_ptr<InferredTrees> inferred {};

    // Whether branches can be inferred: by its outline or by its surface.
    bool has_crown() const { return !outline.tips.empty() || !crown_lines.empty(); }
    bool is_refined() const { return !own_outlines.empty() || !own_branches.empty(); }
};

// How its branches are inferred, and what they are called.
SkeletonOptions options_of(OutlinedTree const& tree);

Result<Drawing> drawing_of(OutlinedTree const& tree);

// Where the trunk's foot is on the paper. Fails as build_tree() does.
Result<Vec2> foot_of(OutlinedTree const& tree);

// What follows from the lines, in millimetres of the paper. Fails, as the user's fault, without an
// outline, and like infer_skeleton().
Result<Skeleton> skeleton_of(OutlinedTree const& tree);

// The path of the branch that a stroke is the own outline of (own_outline.h); no value: it is of
// none, or the tree has no outline. Fails like skeleton_of().
Result<std::optional<std::string>>
branch_outlined_by(OutlinedTree const& tree, Stroke const& stroke, Search search = Search::OnTrunk);

// A line on a branch that is looked for.
struct LineOnBranch {
    scene::ItemId id = 0;
    StyleTo style_to = StyleTo::None;
    Search search = Search::OnTrunk;
    bool is_leaf = false; // An outline, which is declared one.
    bool of_bump = false; // It is the one that was inferred.
};

// The branch that ends in the bump under a stroke's middle (leaf_on_bump(), bump_leaf.h). Fails
// like skeleton_of().
Result<std::optional<BumpLeaf>> leaf_on_bump(OutlinedTree const& tree, Stroke const& stroke,
                                             Search search);

// The tree with the outline as a branch's own, in place of the one that it had. Fails, as the
// user's fault, where it lies around no branch, and like clean_drawing().
Result<OutlinedTree> with_own_outline(OutlinedTree tree, Stroke const& stroke,
                                      LineOnBranch const& line);

// Like these two, for a stroke that is a branch of a branch (own_branch.h).
Result<std::optional<std::string>> branch_borne_by(OutlinedTree const& tree, Stroke const& stroke,
                                                   Search search = Search::OnTrunk);
Result<OutlinedTree> with_own_branch(OutlinedTree tree, Stroke const& stroke,
                                     LineOnBranch const& line);

// The styles that a stroke chooses (carried_by(), chosen_style.h), and a tree with these. Fail like
// carried_by(), choose_styles() and skeleton_of().
Result<ChosenStyles> styles_carried_by(OutlinedTree const& tree, Stroke const& stroke);
Result<OutlinedTree> with_styles(OutlinedTree tree, ChosenStyles const& chosen);

// The tree with a touch on a bump, or without the one that this takes back. Fails like touched()
// (bump_touch.h).
Result<OutlinedTree> with_touch(OutlinedTree tree, DrawnTouch touch, Search search);

// Where a touch is on the paper: the middle of its stroke.
Result<Vec2> place_of(DrawnTouch const& touch);

// The id of the smallest outline that somebody drew around a stroke's middle; 0: it is the crown's,
// no value: there is none.
Result<std::optional<scene::ItemId>> outline_around(OutlinedTree const& tree, Stroke const& stroke);

// The tree with a line on its crown's surface, in place of those whose place that takes
// (takes_place_of(), crown_line.h). An outline that lies in the sheet, within eight degrees, is the
// crown's outline. Fails like kind_of().
Result<OutlinedTree> with_crown_line(OutlinedTree tree, DrawnCrownLine line);

Result<CrownLine> crown_line_of(Stroke const& stroke);

// How many lines that were drawn on branches, touches on bumps and chosen styles wait for theirs.
// Fails like infer_system().
Result<std::size_t> count_waiting(OutlinedTree const& tree);

// Keeps the names of a tree's branches where its lines have changed, and of which branches lines
// are (kept_names.h). Nothing of this without an outline.
Result<void> keep_names(OutlinedTree const& before, OutlinedTree& after, std::string const& fresh);

// The plant: as large as drawn when it is shown at its scale, its foot at the origin. Without an
// outline a bare stem along the trunk. Fails, as the user's fault, for neither, like
// infer_skeleton() and check_form(), and for a trunk that is a dot.
//
// Keeps what it has inferred for the versions that follow.
Result<scene::BuiltSource> build_tree(OutlinedTree const& tree,
                                      scene::LoadOptions const& options = {});

} // namespace tractus::silhouette
