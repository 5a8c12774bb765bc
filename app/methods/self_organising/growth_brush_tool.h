#pragma once

#include "app/tools/tool.h"
#include "engine/methods/self_organising/grown_tree.h"

#include <optional>

namespace tractus::self_organising {

// A tree grows into the volume that the pen sweeps as a ball (after TreeSketch, Longay et al.
// 2012).
struct GrowthBrushTool {
    static tools::ToolKind const kKind;

    // A species: one of the habits that come with the program, in the order of kHabitWords.
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
    double years_per_s = 4;     // Years that the tree grows in a second of the pen.
    double least_radius_mm = 6; // Of the ball, on the desk, at no pressure,
    double most_radius_mm = 30; // and at full pressure.
    enum class What {
        GoOn,     // The active tree grows where the stroke begins on it, else a new one.
        New,      // It is a new tree.
        Year,     // At once: the active tree grows by itself, a year
        TenYears, // or ten; without one a seedling does.
        Habit,    // At once: the active tree lives its life with the tool's habit,
        Reseed,   // or by another chance.
    } what
        = What::GoOn;
};

// The habit of a species.
Habit habit_of(GrowthBrushTool::Species species);

// What a stroke of the tool amounts to: a tree, or how one grows on. Fails, as the user's fault,
// for a stroke without tips.
struct BrushedLife {
    scene::ItemId plant = 0; // The tree that grows on; 0: a new one.
    LifePart part {};
};
Result<BrushedLife> brushed_life(GrowthBrushTool const& tool, Stroke const& stroke,
                                 scene::Scene const& scene);

// Shows the tree, without leaves, as it grows under the pen.
std::unique_ptr<tools::StrokePreviewer> growth_brush_previewer();

} // namespace tractus::self_organising
