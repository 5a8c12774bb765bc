#pragma once

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
    double years_per_s = 4;     // Years of growth per second of pen movement.
    double min_radius_mm = 6;   // Radius of the brush on the desk at no pressure.
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
        FromYear,    // Needs no stroke: like From, for a year without a brush.
        AllYear,     // Needs no stroke: all trees of the drawing grow for a year beside each other.
        AllTenYears, // Needs no stroke: like AllYear, for ten years.
    } what
        = What::GoOn;
};

// Passes a choice of species to a visitor of options.
void visit_species(tools::OptionVisitor& visitor, GrowthBrushTool::Species& species);

// True if strokes have not bent the plant and it has no grafted or hidden parts.
bool is_unmodified(scene::PlantState const& plant);

// The edit that lets the active plant of a scene continue to grow. An unmodified self-organising
// tree (is_unmodified()) simply continues; any other plant first becomes wood (GrowFrom). `habit`
// applies to plants that are not self-organising trees yet. Fails with a user error if there is no
// plant.
Result<scene::Edit> grow_from_active(scene::Scene const& scene, Habit const& habit,
                                     LifePeriod part);

// The habit of a species.
Habit habit_of(GrowthBrushTool::Species species);

// Meaning of a stroke of the tool: a new tree, or further growth of the active one.
struct BrushStrokeLife {
    scene::ItemId plant = 0; // Tree to continue; 0: a new tree.
    LifePeriod part {};
};

// Interprets a stroke of the tool. Fails with a user error if the stroke has no tips.
Result<BrushStrokeLife> life_of_brush_stroke(GrowthBrushTool const& tool, Stroke const& stroke,
                                             scene::Scene const& scene);

// Previews the tree, without leaves, as it grows under the pen.
std::unique_ptr<tools::StrokePreviewer> growth_brush_previewer();

} // namespace tractus::self_organising
