#pragma once

#include "app/tools/tool.h"
#include "engine/methods/construction_lines/line_edits.h"

namespace tractus::lines {

// Draws a plant by construction lines (Anastacio, Prusinkiewicz, Sousa 2008): first the stem, then
// boundaries and inclination lines, which are recognised by their position relative to the stem.
// The plant is updated after each line.
struct LineTool {
    static tools::ToolKind const kKind;

    enum class Plant {
        // Continues the active plant if it was drawn by construction lines, otherwise begins a new
        // plant.
        GoOn,
        // Adds another stem to the active plant if it was drawn by construction lines, otherwise
        // begins a new plant.
        AnotherStem,
        NewStem, // Always begins a new plant.
    };
    Plant plant = Plant::GoOn;
    lines::DepthBy depth_by = lines::DepthBy::Height;
    lines::Reading reading = lines::Reading::Together;
    double nodes = 8; // Number of nodes in the layer above a new inclination line.
    // Arrangement of organs (phyllotaxis) of a new plant.
    lines::Pattern::Kind pattern = lines::Pattern::Kind::Distichous;
    double divergence_deg = 137.5; // Divergence angle of a new plant's spiral.
    double organs = 3; // Number of organs in each whorl of a new plant's whorled pattern.
};

// Interprets a stroke of the tool, finished or not, as an edit.
lines::AddLine line_drawn(LineTool const& tool, Stroke const& stroke, scene::Scene const& scene);

// Message for the user after a stroke of the tool; empty if the active plant has no construction
// lines.
std::string describe_sketch(tools::Tool const& tool, scene::Scene const& after);

} // namespace tractus::lines
