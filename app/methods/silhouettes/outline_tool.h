#pragma once

#include "app/methods/silhouettes/nodes_option.h"
#include "app/tools/tool.h"
#include "engine/methods/silhouettes/tree_edits.h"

namespace tractus::silhouette {

// Draws a tree by its trunk and the outline of its crown (Wither, Boudon, Cani, Godin 2009).
struct OutlineTool {
    static tools::ToolKind const kKind;

    // Form preset of new trees, or of the active tree if What::Form applies it. A preset
    // (ready_form.h) defines the arrangement of branches and the kind of leaves; choosing one also
    // sets the numbers below. Usual keeps a tree's arrangement and leaves as they are.
    enum class Form { Usual, Oak, Pine, Willow, Eucalyptus, Fir, Poplar, Fern } form = Form::Usual;
    double levels = 2;
    double density = 1;
    double leaves = 24;

    enum class What {
        GoOn,  // Adds to the active tree if the stroke lies on it, otherwise begins a new tree.
        New,   // Always begins a new tree.
        Carry, // Copies the style of one branch of the active tree to others that the line crosses.
        Split, // Splits the touched bump of the active tree's outlines.
        Join,  // Joins the two bumps between which the pen touches.
        // A closed line draws a leaf's outline; a touch on a bump, or else inside an outline,
        // toggles whether that is a leaf.
        Leaf,
        Form,   // Needs no stroke: applies the tool's form and numbers to the active tree.
        Reseed, // Needs no stroke: redoes the active tree's random decisions with another seed.
    } what
        = What::GoOn;

    // The parent of a drawn branch: always the trunk, the trunk's branch on which the line begins,
    // or any branch on which it begins. `style` defines which other branches copy the style of a
    // branch on which something is drawn. Logs from before these options lack them: their branches
    // grow on the trunk, and no style is copied.
    enum class Branches { OfTrunk, OfNearest, OfAny } branches = Branches::OfAny;
    silhouette::StyleScope style = silhouette::StyleScope::Siblings;

    // Version of the rules that interpret strokes. New strokes use the latest; logs keep the
    // version they were recorded with.
    enum class Reads {
        AsAtFirst, // A trunk belongs to a crown only if it has a point inside.
        // A trunk that stops just below a crown also belongs to it (trunk_reach.h), as does one
        // that is drawn into a crown without a trunk; a touch that declares a leaf applies to a
        // bump if there is one (bump_leaf.h).
        Closely,
    } reads
        = Reads::Closely;

    NodesOption nodes = NodesOption::Whole;
    FillsOption fills = FillsOption::BySpacing;

    // How long the features recognised in the outline are shown (kSeenLayer, outline_layer.h).
    enum class SeenFor { AWhile, Always, WithTriangles } seen = SeenFor::AWhile;
};

// The given form with the tool's numbers and, if a preset is chosen, with the rest of that preset.
TreeForm form_of(OutlineTool const& tool, TreeForm form);

} // namespace tractus::silhouette
