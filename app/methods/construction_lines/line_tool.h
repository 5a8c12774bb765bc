#pragma once

#include "app/tools/tool.h"
#include "engine/methods/construction_lines/line_edits.h"

namespace tractus::lines {

// A stroke is a line of a sketch: the stem first, then what lies to it as boundaries and
// inclination lines do (Anastacio, Prusinkiewicz, Sousa 2008). The plant follows each of them.
struct LineTool {
    static tools::ToolKind const kKind;

    enum class Plant {
        GoOn,        // With the active plant if that is a sketch, else with another one.
        AnotherStem, // Likewise; it is another stem of that plant.
        NewStem,     // Always with another one.
    };
    Plant plant = Plant::GoOn;
    lines::DepthBy depth_by = lines::DepthBy::Height;
    lines::Reading reading = lines::Reading::Together;
    double nodes = 8; // In the layer above the line.
    // Of a plant that begins.
    lines::Pattern::Kind pattern = lines::Pattern::Kind::Distichous;
    double divergence_deg = 137.5; // Of a spiral.
    double organs = 3;             // Of a whorl.
};

// What a stroke with the tool means: the tips drawn so far, in a document as it is built.
lines::AddLine line_drawn(LineTool const& tool, Stroke const& stroke, scene::Scene const& scene);

// For the person who has drawn with the tool; empty where the active plant is no sketch.
std::string said_of_sketch(tools::Tool const& tool, scene::Scene const& after);

} // namespace tractus::lines
