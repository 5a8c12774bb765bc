#pragma once

#include "app/tools/stroke_base.h"
#include "app/tools/tool.h"
#include "engine/methods/self_organising/grown_tree.h"

#include <optional>

namespace tractus::self_organising {

// Grows a tree into the volume that the pen sweeps with a spherical brush (after TreeSketch, Longay
// et al. 2012).
struct GrowthBrushTool {
    static tools::ToolKind const kKind;

    // Species with a built-in habit, in the order of kHabitWords.
    enum class Species {
        Oak,
        Beech,
        Lime,
        Maple,
        Ash,
        Cherry,
        Birch,
        Alder,
        Plane,
        Poplar,
        Willow,
        Apple,
        Pine,
        Spruce,
        Fir,
        Larch,
    } species
        = Species::Oak;
    // Which numbers new trees of a species have, and those that get this tool's habit.
    enum class Edition {
        Pipe,  // The earlier numbers, and the girth by the pipe model alone.
        Rings, // The earlier numbers (app/habits/earlier), with annual rings (Habit::ring_mm).
        Full,  // The numbers of app/habits.
    } edition
        = Edition::Full;
    double years_per_s = 4;     // Years of growth per second of pen movement.
    double min_radius_mm = 6;   // Radius of the brush on the desk at zero pressure.
    double most_radius_mm = 30; // Radius of the brush on the desk at full pressure.
    enum class What {
        GoOn, // Continues the active tree if the stroke begins on it, otherwise begins a new tree.
        New,  // Always begins a new tree.
        Year, // Needs no stroke: the active tree, or a new seedling, grows by itself for a year.
        // Needs no stroke: the active tree, or a new seedling, grows by itself for ten years.
        TenYears,
        Habit,  // Needs no stroke: regrows the active tree with the tool's habit.
        Reseed, // Needs no stroke: regrows the active tree with another random seed.
        // Continues the active plant, whichever method made it, in its present shape: its branches
        // become wood.
        From,
        // Needs no stroke: like From, but the tree grows for a year by itself, without the brush.
        FromYear,
        AllYear, // Needs no stroke: all trees of the drawing grow for a year, shading each other.
        AllTenYears, // Needs no stroke: like AllYear, for ten years.
        TurnRound,   // Needs no stroke: regrows the active tree along its newest stroke, reversed.
    } what
        = What::GoOn;
    // With StrokeBase::AtFoot, a stroke that begins a tree and runs down to the ground is reversed.
    tools::StrokeBase base = tools::StrokeBase::AtFoot;
};

// Passes the choice of a species to a visitor of options.
void visit_species(tools::OptionVisitor& visitor, GrowthBrushTool::Species& species);

// Passes the edition of the habits' numbers, which has no button, to a visitor of options. Logs
// without its word are of the first edition.
void visit_edition(tools::OptionVisitor& visitor, GrowthBrushTool::Edition& girth);

// True if the plant is not bent by strokes or indicators, and has no grafted or hidden parts.
bool is_unmodified(scene::PlantState const& plant);

// The edit that lets the active plant of a scene continue growing. An unmodified self-organising
// tree (is_unmodified()) simply continues. The branches of any other plant first become wood
// (GrowFrom); if it is not a self-organising tree yet, it then grows with the habit `habit`. Fails
// with a user error if the scene has no plant.
Result<scene::Edit> grow_from_active(scene::Scene const& scene, Habit const& habit,
                                     LifePeriod part);

// The built-in habit of a species, in one of its editions.
Habit habit_of(GrowthBrushTool::Species species,
               GrowthBrushTool::Edition edition = GrowthBrushTool::Edition::Full);

// Meaning of a growth brush's stroke: a period in the life of a new tree or of the active tree.
struct BrushStrokeLife {
    scene::ItemId plant = 0; // Id of the tree that continues growing; 0: a new tree.
    LifePeriod part {};
};

// Interprets a stroke of the tool. Fails with a user error if the stroke has no tips.
Result<BrushStrokeLife> life_of_brush_stroke(GrowthBrushTool const& tool, Stroke const& stroke,
                                             scene::Scene const& scene);

// Creates a preview of the tree, without leaves, as it grows under the pen.
std::unique_ptr<tools::StrokePreviewer> growth_brush_previewer();

} // namespace tractus::self_organising
