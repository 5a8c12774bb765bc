#pragma once

#include "app/tools/branch_place.h"
#include "app/tools/tool.h"
#include "engine/methods/sketch_lsystem/grow_edit.h"

#include <optional>

namespace tractus::sketch {

// A rule grows along the stroke: a new plant (Ijiri, Owada, Igarashi 2006).
struct SketchTool {
    static tools::ToolKind const kKind;

    // A ready rule. A person who chooses one chooses its numbers, too, which logs name; its twist
    // and its shortest internode are the card's as long as no option says others. Or, from Birch
    // on, one of our models in a rule's place: numbers and leaves say nothing of it. Or, the last,
    // what the active plant is: the rule or the model by which it has grown along a stroke, or its
    // own model.
    enum class Card {
        Opposite,
        Whorls,
        Crown,
        Vase,
        Spire,
        Fern,
        Herb,
        Tufts,
        Compound,
        Birch,
        Broadleaf,
        Conifer,
        Frond,
        Palm,
        Poplar,
        Vine,
        Plant,
    } card
        = Card::Opposite;
    double laterals = 2;
    double angle_deg = 45;
    double first_length_mm = 30;
    double length_ratio = 0.9;
    double lateral_length = 0.62;
    // Laterals fork as the rule's do, or each goes on by a ready rule of its own, or by the rule
    // itself.
    enum class Laterals {
        Fork,
        Opposite,
        Whorls,
        Crown,
        Vase,
        Spire,
        Fern,
        AsAxis
    } go_on_by
        = Laterals::Fork;
    sketch::Leaves leaves = sketch::Leaves::Leafy;
    StrokeSurface surface = StrokeSurface::Decided;
    enum class Place {
        Ground,  // The plant stands alone where the stroke begins,
        Branch,  // or on the branch on which it begins,
        InPlace, // or in the place of that branch, which is hidden.
        Again,   // or what has grown along a stroke last grows along this one,
        Change,  // or, at once, grows by these numbers.
    } place
        = Place::Ground;
    // Whether what has grown by the rule follows when a person gives it other numbers.
    enum class Drawn { Follows, Stays } drawn = Drawn::Follows;
    // What the glyph sets beside the numbers above; twists are added to those of the card.
    double width_ratio = 0.85;
    double lateral_width = 0.55;
    double axis_twist_deg = 0;
    double lateral_twist_deg = 0;
    double shortest_mm = 0; // 0: the card's.
};

// Returns what a stroke with the tool means, but for where the plant stands: the tips drawn so far,
// in a document as it is built. Fails, as the user's fault, where the active plant is to be grown
// again and is neither from a rule nor from a model.
Result<sketch::GrowAlongStroke> grown_along(SketchTool const& tool, Stroke const& stroke,
                                            scene::Scene const& scene);

// Returns what has grown along a stroke last along this one, by its own rule. Fails, as the user's
// fault, where nothing has.
Result<sketch::GrowAlongStroke> drawn_again(SketchTool const& tool, Stroke const& stroke,
                                            scene::Scene const& scene);

// Makes a plant that shall stand on a branch no thicker than that, as far as a rule can be thin.
void fit_to_branch(sketch::GrowAlongStroke& grown, tools::BranchPlace const& place);

// Returns the place on a branch that the tool gives to such a plant; no value: it stands alone.
// Fails, as the user's fault, where the stroke begins on no branch.
Result<std::optional<tools::BranchPlace>>
place_of(SketchTool const& tool, sketch::GrowAlongStroke const& grown, scene::Scene const& scene);

} // namespace tractus::sketch
