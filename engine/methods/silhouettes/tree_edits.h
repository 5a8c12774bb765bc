#pragma once

#include "engine/methods/silhouettes/outlined_tree.h"
#include "engine/scene/document_state.h"
#include "engine/scene/edit.h"

namespace tractus::silhouette {

// Draws a part of a tree on paper (Wither et al. 2009).
struct DrawTree {
    static scene::EditKind const kKind;

    enum class Part {
        Trunk,      // In place of the tree's trunk, if it has one.
        Outline,    // Of the crown, likewise.
        Branch,     // One more.
        OwnOutline, // A branch's: of the one that it lies around (own_outline.h).
        OwnBranch,  // On a branch, on which it begins (own_branch.h).
        Split,      // A touch that splits a bump of an outline, or joins two (bump_touch.h); or
        Join,       // takes such a touch back.
        Surface,    // A line in space on the crown's surface (drawn_surface.h): its z is how far
                    // behind the sheet it is.
    } part
        = Part::Outline;
    Stroke stroke {};
    bool is_leaf = false;             // An outline: it is declared one (leaf_blade.h),
    bool of_bump = false;             // by a touch on a bump, whose own it is (bump_leaf.h).
    StyleTo style_to = StyleTo::None; // Of the branch that is drawn on (sibling_style.h),
    Search search = Search::OnTrunk;  // and among which ones that is looked for.
    // A tree that there is; 0: a new plant, which becomes the active one. What follows is a new
    // one's.
    scene::ItemId plant = 0;
    Vec3 stands_at_mm = Vec3::Zero(); // World frame.
    // Where the foot of a new tree is on the paper that begins with its surface. No value: below
    // that, by a quarter of its height.
    std::optional<Vec2> ground_mm {};
    TreeForm form {};
    // World millimetres per plant millimetre: what was drawn is a plant of so many times its size.
    // A document whose scale nobody has set keeps this one.
    double scale = 0.1;
    // A trunk, or an outline: how far the tree's trunk goes on from its tip into its crown
    // (OutlinedTree::trunk_goes_on_mm).
    double trunk_goes_on_mm = 0;
    // A new tree takes the style of the nearest one that has one (nearest_style.h): the form has
    // it.
    bool takes_style = false;
    // World millimetres per millimetre of the paper of a new tree that was drawn smaller since it
    // is farther away (picture_ground.h); 0: it is shown as large as drawn.
    double enlarged = 0;
    // The id of the plant, or of the part, after which branches that it brings are called; 0: it
    // has none yet.
    scene::ItemId id = 0;
};

// Takes a part of a tree away. A tree of which neither trunk nor outline would be left is refused:
// RemovePlant takes the whole.
struct EraseTreePart {
    static scene::EditKind const kKind;

    scene::ItemId plant = 0;
    DrawTree::Part part = DrawTree::Part::Branch;
    // Which one it is, of a branch, of what was drawn on one, of a touch, or of a line in space.
    scene::ItemId branch = 0;
};

// Declares an outline of a tree a leaf (leaf_blade.h), or that it is none.
struct DeclareLeaf {
    static scene::EditKind const kKind;

    scene::ItemId plant = 0;
    scene::ItemId outline = 0; // A branch's; 0: the crown's.
    bool is_leaf = true;
};

// Gives branches of a tree the styles of others (chosen_style.h).
struct ChooseStyles {
    static scene::EditKind const kKind;

    scene::ItemId plant = 0;
    ChosenStyles styles {}; // To paths, from paths; from "": the branch has its own again.
};

// Sets another form for a tree. What was drawn on branches stays where their names stay.
struct FormTree {
    static scene::EditKind const kKind;

    scene::ItemId plant = 0;
    TreeForm form {};
    bool takes_style = false; // It goes on to take that of the nearest tree, which the form has.
};

// The tree with the edit's part; `id` becomes a branch's or its outline's. Fails like
// with_own_outline(), with_own_branch() and with_crown_line().
Result<OutlinedTree> with_part(OutlinedTree tree, DrawTree const& edit, scene::ItemId id = 0);

// Null for a plant that was not outlined.
OutlinedTree const* outlined_tree(scene::PlantState const& plant);

} // namespace tractus::silhouette
