#pragma once

#include "app/methods/silhouettes/nodes_option.h"
#include "app/tools/tool.h"
#include "engine/methods/silhouettes/tree_edits.h"

namespace tractus::silhouette {

// Draws a tree by its trunk and the outline of its crown (Wither, Boudon, Cani, Godin 2009).
struct OutlineTool {
    static tools::ToolKind const kKind;

    // Of trees that are begun, or of the active one when they are given to it. A ready form
    // (ready_form.h) says how branches stand and what leaves are like; a person who chooses one
    // chooses its numbers, too. The usual one leaves that of a tree as it is.
    enum class Form { Usual, Oak, Pine, Willow, Eucalyptus, Fir, Poplar, Fern } form = Form::Usual;
    double levels = 2;
    double density = 1;
    double leaves = 24;

    enum class What {
        GoOn,   // What is drawn is the active tree's where it lies on that, else a new tree's.
        New,    // It is a new tree's.
        Carry,  // A line carries the style of a branch of the active tree to others.
        Split,  // A touch on a bump of the active tree's outlines splits it,
        Join,   // or one between two joins them.
        Leaf,   // An outline is a leaf, and a touch on a bump of one or else inside of one
                // declares that a leaf, or none.
        Form,   // At once: the active tree gets the numbers.
        Reseed, // At once: what the active tree's drawing leaves open is decided anew.
    } what
        = What::GoOn;

    // What a line is that begins on a branch, of the trunk's branches or of any, and whom the style
    // of a branch goes to that is drawn on from now on. A person begins with these; without their
    // words, as logs from before there were any, lines are the trunk's, and no style goes anywhere.
    enum class Branches { OfTrunk, OfNearest, OfAny } branches = Branches::OfAny;
    silhouette::StyleTo style = silhouette::StyleTo::Siblings;

    // How what is drawn is read. A person begins with what is known now; logs from before are read
    // as they were then.
    enum class Reads {
        AsAtFirst, // A trunk is a crown's that has a point inside it.
        Closely,   // A trunk that a hand has stopped just below a crown is the crown's, too
                   // (trunk_reach.h), as is one that is drawn into a crown without any; a touch
                   // that declares a leaf is on a bump where there is one (bump_leaf.h).
    } reads
        = Reads::Closely;

    NodesOption nodes = NodesOption::Whole;

    // How long what was seen in the outline is shown (kSeenLayer, outline_layer.h).
    enum class SeenFor { AWhile, Always, WithTriangles } seen = SeenFor::AWhile;
};

// The form with the tool's numbers, and with the rest of its ready form if it has one.
TreeForm form_of(OutlineTool const& tool, TreeForm form);

} // namespace tractus::silhouette
