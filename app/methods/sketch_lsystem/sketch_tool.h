#pragma once

#include "app/tools/branch_place.h"
#include "app/tools/tool.h"
#include "engine/methods/sketch_lsystem/grow_edit.h"

#include <optional>

namespace tractus::sketch {

// Grows a plant along the stroke by a rule (Ijiri, Owada, Igarashi 2006) or by a model.
struct SketchTool {
    static tools::ToolKind const kKind;

    // Preset of the tool. Presets before Birch are rules. Choosing a rule also sets the tool's
    // numbers, which logs record; the rule's twist and shortest internode apply unless other
    // options replace them. From Birch on, presets are built-in models, on which numbers and leaves
    // have no effect. The last preset, Plant, copies the active plant: the rule or model by which
    // it has grown along a stroke, or its own model.
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
    // These four make a leafy twig of a stroke from 50 to 250 mm. Logs without them mean the rule
    // of older versions, with internodes twice as long (NumberOption::in_logs).
    double angle_deg = 50;
    double first_length_mm = 15;
    double length_ratio = 0.95;
    double lateral_length = 0.7;
    // How laterals branch: they fork as in the paper, or grow by the rule of a preset or by the
    // rule of the axis.
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
        Ground,  // The plant stands alone on the ground where the stroke begins.
        Branch,  // The plant is grafted onto the branch on which the stroke begins.
        InPlace, // The plant replaces the branch on which the stroke begins; that branch is hidden.
        // The active plant, or its newest part that grew along a stroke, is regrown along this
        // stroke.
        Again,
        // Needs no stroke: like Again, but with the tool's numbers instead of another stroke.
        Change,
        // Needs no stroke: like Again, but with the present stroke reversed, so that the plant's
        // tip becomes its foot.
        TurnRound,
    } place
        = Place::Ground;
    // Whether plants that were grown by the tool's rule are regrown when the user changes its
    // numbers.
    enum class Drawn { Follows, Stays } drawn = Drawn::Follows;
    // Numbers that the gizmo sets. The twists are added to those of the preset.
    double width_ratio = 0.85;
    double lateral_width = 0.55;
    double axis_twist_deg = 0;
    double lateral_twist_deg = 0;
    double shortest_mm = 0; // Length of the shortest internode; 0: that of the preset.
    // Occupancy radius (Rule::occupancy_radius_mm): laterals stay short, or do not grow, to leave
    // room for other parts of the axis. 0: they ignore other parts.
    double room_mm = 0;
    // The end of a stroke at which the plant stands. AsDrawn: the stroke's beginning. AtFoot: the
    // stroke's foot; a stroke that was drawn down to the ground is therefore reversed
    // (foot_first.h). Logs that are older than this option lack it and mean AsDrawn.
    enum class Stands { AsDrawn, AtFoot } stands = Stands::AtFoot;
};

// Interprets a stroke of the tool, finished or not, without placing the plant on a branch. Fails
// with a user error if the active plant is to be copied but has neither a rule nor a model.
Result<sketch::GrowAlongStroke> grown_along(SketchTool const& tool, Stroke const& stroke,
                                            scene::Scene const& scene);

// The active plant's newest part that grew along a stroke, regrown by its own rule along this
// stroke. Fails with a user error if there is no such part.
Result<sketch::GrowAlongStroke> regrown_along(SketchTool const& tool, Stroke const& stroke,
                                              scene::Scene const& scene);

// Makes the stem of a plant thinner than the branch on which it is to stand, within the limits of
// its rule.
void fit_to_branch(sketch::GrowAlongStroke& grown, tools::BranchPlace const& place);

// The place on a branch where the tool puts the plant; no value if the plant stands alone. Fails
// with a user error if the stroke does not begin on a branch.
Result<std::optional<tools::BranchPlace>>
place_of(SketchTool const& tool, sketch::GrowAlongStroke const& grown, scene::Scene const& scene);

} // namespace tractus::sketch
