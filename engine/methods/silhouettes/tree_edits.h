#pragma once

#include "engine/methods/silhouettes/outlined_tree.h"
#include "engine/scene/document_state.h"
#include "engine/scene/edit.h"

namespace tractus::silhouette {

// Edit: draws a part of a tree on paper (Wither et al. 2009).
struct DrawTree {
    static scene::EditKind const kKind;

    enum class Part {
        Trunk,      // The tree's trunk; replaces an earlier one.
        Outline,    // The crown's outline; replaces an earlier one.
        Branch,     // An additional branch of the trunk.
        OwnOutline, // The outline of a branch, which the stroke surrounds (own_outline.h).
        OwnBranch,  // A branch of a branch, on which the stroke begins (own_branch.h).
        Split,      // A touch that splits a bump or undoes a join (bump_touch.h).
        Join,       // A touch that joins two bumps or undoes a split.
        Surface,    // A line in space on the crown's surface (drawn_surface.h); z is the distance
                    // behind the sheet.
    } part
        = Part::Outline;
    Stroke stroke {};
    bool is_leaf = false; // True: the outline is declared a leaf (leaf_blade.h).
    bool of_bump = false; // True: the outline comes from a touch at a bump (bump_leaf.h).
    // Which branches take the style of the branch that is drawn on (sibling_style.h).
    StyleScope style_to = StyleScope::None;
    // Branches considered in the search for the branch that is drawn on.
    Search search = Search::OnTrunk;
    // Id of an existing tree; 0: a new plant, which becomes the active one. The following fields,
    // up to `scale`, apply only to a new plant.
    scene::ItemId plant = 0;
    Vec3 stands_at_mm = Vec3::Zero(); // Position of the trunk's foot, world frame.
    // Position of the trunk's foot on the paper, for a new tree begun with its crown surface.
    // Default: below the crown by a quarter of the crown's height.
    std::optional<Vec2> ground_mm {};
    TreeForm form {};
    // World millimetres per plant millimetre: the plant is 1 / scale times as large as the drawing.
    // Becomes the document's scale if none was set.
    double scale = 0.1;
    // Length by which the trunk is extended from its tip into the crown, for a trunk or an outline
    // (OutlinedTree::trunk_goes_on_mm).
    double trunk_goes_on_mm = 0;
    // True: a new tree takes the style of the nearest tree that has one (nearest_style.h); `form`
    // already has that style.
    bool takes_style = false;
    // World millimetres per millimetre of the paper, for a new tree that was drawn smaller because
    // it is farther away (picture_ground.h). 0: shown as large as drawn.
    double enlarged = 0;
    // True if the line was drawn from tip to foot, so that `stroke` is its reverse (foot_first.h).
    bool is_drawn_reversed = false;
    // Id of the plant or part, used in the names of new branches; 0: none assigned yet.
    scene::ItemId id = 0;
};

// Edit: removes a part of a tree. Refused if neither trunk nor outline would be left; RemovePlant
// removes a whole tree.
struct EraseTreePart {
    static scene::EditKind const kKind;

    scene::ItemId plant = 0;
    DrawTree::Part part = DrawTree::Part::Branch;
    // Id of the branch, line on a branch, touch, or line in space; unused for other parts.
    scene::ItemId branch = 0;
};

// Edit: declares an outline of a tree a leaf, or revokes that (leaf_blade.h).
struct DeclareLeaf {
    static scene::EditKind const kKind;

    scene::ItemId plant = 0;
    scene::ItemId outline = 0; // Id of a branch's outline; 0: the crown's.
    bool is_leaf = true;
};

// Edit: gives branches of a tree the styles of other branches (chosen_style.h).
struct ChooseStyles {
    static scene::EditKind const kKind;

    scene::ItemId plant = 0;
    // Target path to source path; source "" restores the branch's own style.
    ChosenStyles styles {};
};

// Edit: sets another form for a tree. Lines drawn on branches stay with the branches whose names
// are kept.
struct FormTree {
    static scene::EditKind const kKind;

    scene::ItemId plant = 0;
    TreeForm form {};
    // True: the tree keeps taking the style of the nearest tree; `form` already has that style.
    bool takes_style = false;
};

// The tree with the edit's part added; `id` becomes the id of that part. Fails like
// with_own_outline(), with_own_branch() and with_crown_line().
Result<OutlinedTree> with_part(OutlinedTree tree, DrawTree const& edit, scene::ItemId id = 0);

// The tree from which a plant is built; null if the plant was not drawn by its outline.
OutlinedTree const* outlined_tree(scene::PlantState const& plant);

} // namespace tractus::silhouette
