#pragma once

#include "app/tools/tool.h"
#include "engine/methods/construction_lines/line_edits.h"

namespace tractus::lines {

// Draws a plant by construction lines (Anastacio, Prusinkiewicz, Sousa 2008): first the stem, then
// boundaries and inclination lines, recognised by their position relative to the stem. Each line
// updates the plant.
struct LineTool {
    static tools::ToolKind const kKind;

    enum class Plant {
        GoOn, // Continues the active plant if that is a sketch, otherwise begins a new plant.
        // Adds another stem to the active plant if that is a sketch, otherwise begins a new plant.
        AnotherStem,
        NewStem, // Always begins a new plant.
    };
    Plant plant = Plant::GoOn;
    lines::DepthBy depth_by = lines::DepthBy::Height;
    lines::Reading reading = lines::Reading::Together;
    double nodes = 8; // Nodes in the layer above a new inclination line.
    // Phyllotaxis of a new plant.
    lines::Pattern::Kind pattern = lines::Pattern::Kind::Distichous;
    double divergence_deg = 137.5; // Divergence angle of a spiral.
    double organs = 3;             // Organs in each whorl of a whorled pattern.
};

// Interprets an unfinished or finished stroke of the tool as an edit.
lines::AddLine line_drawn(LineTool const& tool, Stroke const& stroke, scene::Scene const& scene);

// Message for the user after a stroke of the tool; empty if the active plant is not a sketch.
std::string describe_sketch(tools::Tool const& tool, scene::Scene const& after);

} // namespace tractus::lines
