#pragma once

#include "app/tools/tool.h"
#include "engine/methods/silhouettes/tree_edits.h"

#include <optional>

namespace tractus::silhouette {

// Draws a tree by its trunk and the outline of its crown (Wither, Boudon, Cani, Godin 2009).
struct OutlineTool {
    static tools::ToolKind const kKind;

    // Of trees that are begun, or of the active one when they are given to it. A ready form
    // (ready_form.h) says how branches stand and what leaves are like; a person who chooses one
    // chooses its numbers, too. The usual one leaves that of a tree as it is.
    enum class Form { Usual, Oak, Pine, Willow, Eucalyptus, Fir } form = Form::Usual;
    double levels = 2;
    double density = 1;
    double leaves = 24;

    enum class What {
        GoOn,   // What is drawn is the active tree's where it lies on that, else a new tree's.
        New,    // It is a new tree's.
        Carry,  // A line carries the style of a branch of the active tree to others.
        Split,  // A touch on a bump of the active tree's outlines splits it,
        Join,   // or one between two joins them.
        Leaf,   // An outline is a leaf, and a touch inside of one declares it that, or none.
        Form,   // At once: the active tree gets the numbers.
        Reseed, // At once: what the active tree's drawing leaves open is decided anew.
    } what
        = What::GoOn;

    // What a line is that begins on a branch, of the trunk's branches or of any, and whom the style
    // of a branch goes to that is drawn on from now on. A person begins with these; without their
    // words, as logs from before there were any, lines are the trunk's, and no style goes anywhere.
    enum class Branches { OfTrunk, OfNearest, OfAny } branches = Branches::OfAny;
    silhouette::StyleTo style = silhouette::StyleTo::Siblings;

    // How long what was seen in the outline is shown (kSeenLayer, outline_layer.h).
    enum class SeenFor { AWhile, Always, WithTriangles } seen = SeenFor::AWhile;
};

// What a stroke with the tool means: the tips drawn so far, in a document as it is built. Over a
// picture a touch means the outline of the crown that it lies in (touched_crown.h). One that
// comes back to its beginning is an outline, of the crown or of the branch that it lies around
// (own_outline.h), any other a trunk or a branch, of the trunk or of the branch that it begins on
// (own_branch.h).
Result<silhouette::DrawTree> drawn_tree(OutlineTool const& tool, Stroke const& stroke,
                                        scene::Scene const& scene);

// What a stroke with the tool does to a leaf where it does not come back: the smallest outline of
// the active tree around its middle becomes a leaf, or is none any more. No value: the stroke is an
// outline. Fails, as the user's fault, where it lies in no outline.
Result<std::optional<silhouette::DeclareLeaf>> declared_leaf(Stroke const& stroke,
                                                             scene::Scene const& scene);

// The styles that a stroke with the tool carries, in the active tree (carried_by(),
// chosen_style.h). Fails, as the user's fault, where there is no such tree, and like that.
Result<silhouette::ChooseStyles> carried_styles(Stroke const& stroke, scene::Scene const& scene);

// The tree that the edit would make, with all its lines.
Result<silhouette::OutlinedTree> tree_with(silhouette::DrawTree const& edit,
                                           scene::Scene const& scene);

} // namespace tractus::silhouette
