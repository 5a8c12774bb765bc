#pragma once

#include "app/methods/silhouettes/nodes_option.h"
#include "app/tools/tool.h"
#include "engine/methods/silhouettes/tree_edits.h"

namespace tractus::silhouette {

// Draws a tree by its trunk and the outline of its crown (Wither, Boudon, Cani, Godin 2009).
struct OutlineTool {
    static tools::ToolKind const kKind;

    // Form preset of a new tree, or of the active tree if What::Form applies it. A preset
    // (ready_form.h) gives the arrangement of branches and the kind of leaves; choosing one also
    // sets the numbers of the tool. Usual keeps a tree's arrangement and leaves.
    // Usual, then the presets (tree_presets()), in their order.
    enum class Form {
        Usual,
        Oak,
        Pine,
        Willow,
        Eucalyptus,
        Fir,
        Poplar,
        Fern,
        UmbrellaPine,
        Baobab,
        Acacia,
        Birch
    };
    Form form = Form::Usual;
    double levels = 2;
    double density = 1;
    double leaves = 24;

    enum class What {
        GoOn, // Adds to the active tree if the stroke belongs to it, otherwise begins a new tree.
        New,  // Always begins a new tree.
        // Copies the style of a branch of the active tree to the other branches that the line
        // crosses.
        Carry,
        Split, // Splits the bump that the pen touches on an outline of the active tree.
        Join,  // Joins two bumps of an outline if the pen touches between them.
        // A closed line is the outline of a leaf. A touch turns a bump into a leaf, or a leaf back
        // into a bump; a touch that is not on a bump does so with the outline around it.
        Leaf,
        TurnRound, // Reverses the trunk or drawn branch that the pen touches.
        Form,      // Needs no stroke: applies the tool's form and numbers to the active tree.
        Reseed,    // Needs no stroke: redoes the active tree's random decisions with another seed.
    } what
        = What::GoOn;

    // Which branch can be the parent of a drawn branch: only the trunk, also the trunk's branch on
    // which the line begins, or any branch on which it begins. `style` says which other branches
    // copy the style of a branch on which something is drawn. Logs that are older than these two
    // options lack them and mean: the trunk is the parent, and no style is copied.
    enum class Branches { OfTrunk, OfNearest, OfAny } branches = Branches::OfAny;
    silhouette::StyleScope style = silhouette::StyleScope::Siblings;

    // Version of the rules that interpret strokes. New strokes use the latest version; logs give
    // the version with which they were recorded.
    enum class Reads {
        AsAtFirst, // A trunk belongs to a crown only if a point of the trunk is inside.
        // A trunk belongs to a crown also if it stops just below it (trunk_reach.h), or if it is
        // drawn into a crown without a trunk. A touch that declares a leaf applies to a bump if it
        // is on one (bump_leaf.h).
        Closely,
        // As Closely; a trunk or branch that was drawn from its tip to its foot is reversed.
        FootFirst,
    } reads
        = Reads::FootFirst;

    NodesOption nodes = NodesOption::Whole;
    FillsOption fills = FillsOption::BySpecies;

    // How long the features recognised in an outline are shown (kSeenLayer in outline_layer.h).
    enum class SeenFor { AWhile, Always, WithTriangles } seen = SeenFor::AWhile;
};

// The form `form` with the tool's numbers. If a preset is chosen, the rest is that of the preset.
TreeForm form_of(OutlineTool const& tool, TreeForm form);

} // namespace tractus::silhouette
