#pragma once

#include "app/tools/branch_place.h"
#include "app/tools/tool.h"
#include "engine/methods/sketch_lsystem/grow_edit.h"

#include <optional>

namespace tractus::sketch {

// Grows a plant by a rule along the stroke (Ijiri, Owada, Igarashi 2006).
struct SketchTool {
    static tools::ToolKind const kKind;

    // Preset of the tool. Presets before Birch are rules: choosing one also sets the numbers below,
    // which logs record; its twist and shortest internode apply unless other options override them.
    // From Birch on, presets are built-in models, on which numbers and leaves have no effect. The
    // last, Plant, copies the active plant: the rule or model by which it has grown along a stroke,
    // or its own model.
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
    // How laterals continue: they fork as in the paper, or grow by a preset's rule or by the axis's
    // own rule.
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
        Ground,  // The plant stands alone where the stroke begins.
        Branch,  // The plant stands on the branch on which the stroke begins.
        InPlace, // The plant replaces the branch on which the stroke begins; that branch is hidden.
        Again,   // The sketch grown last is regrown along this stroke.
        Change,  // Needs no stroke: the sketch grown last takes these numbers.
        // Needs no stroke: the stroke of the sketch grown last is reversed, so that its tip becomes
        // its foot.
        TurnRound,
    } place
        = Place::Ground;
    // Whether plants grown by the rule are regrown when the user changes its numbers.
    enum class Drawn { Follows, Stays } drawn = Drawn::Follows;
    // Numbers set by the gizmo; the twists are added to those of the preset.
    double width_ratio = 0.85;
    double lateral_width = 0.55;
    double axis_twist_deg = 0;
    double lateral_twist_deg = 0;
    double shortest_mm = 0; // Length of the shortest internode; 0: the preset's value.
    double room_mm
        // Occupancy radius of laterals (Rule::occupancy_radius_mm); 0: they do not avoid each
        // other.
        = 0;
    // The end of a stroke at which the plant stands. AsDrawn: the beginning. AtFoot: the foot, so a
    // stroke that was drawn down to the ground is reversed (foot_first.h). Logs from before this
    // option existed lack it and get AsDrawn.
    enum class Stands { AsDrawn, AtFoot } stands = Stands::AtFoot;
};

// Interprets an unfinished or finished stroke of the tool, except for where the plant stands. Fails
// with a user error if the active plant is to be copied but has neither a rule nor a model.
Result<sketch::GrowAlongStroke> grown_along(SketchTool const& tool, Stroke const& stroke,
                                            scene::Scene const& scene);

// The sketch grown last, regrown along this stroke by its own rule. Fails with a user error if
// there is none.
Result<sketch::GrowAlongStroke> regrown_along(SketchTool const& tool, Stroke const& stroke,
                                              scene::Scene const& scene);

// Makes a plant thin enough to stand on a branch, as far as its rule permits.
void fit_to_branch(sketch::GrowAlongStroke& grown, tools::BranchPlace const& place);

// The place on a branch where the tool puts the plant, or no value if it stands alone. Fails with a
// user error if the stroke does not begin on a branch.
Result<std::optional<tools::BranchPlace>>
place_of(SketchTool const& tool, sketch::GrowAlongStroke const& grown, scene::Scene const& scene);

} // namespace tractus::sketch
