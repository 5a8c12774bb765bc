#pragma once

#include "app/tools/tool.h"
#include "engine/base/result.h"
#include "engine/scene/edit.h"
#include "engine/scene/scene.h"

#include <string>
#include <vector>

namespace tractus::document {

// A finished stroke and its effect.
struct DrawnStroke {
    Stroke stroke;
    tools::Tool tool;
    std::string refusal {}; // Why the stroke changed nothing; empty if it changed the scene.
    std::vector<scene::Edit> edits {}; // Edits that the stroke made; empty if it was refused.
    std::string message {};            // Replaces the tool's message ToolKind::done; may be empty.
};

// The tool's own message after a stroke (ToolKind::describe).
std::string describe_result(tools::Tool const& tool, scene::Scene const& after);

// Applies a stroke drawn with a tool to a scene: all of its edits, or none if one is refused.
DrawnStroke draw(Stroke stroke, tools::Tool const& tool, scene::Scene& scene);

// The scene after edits that belong together. Models run within the limits of load_options(). Fails
// if any edit fails.
Result<scene::Scene> scene_after(scene::Scene scene, std::vector<scene::Edit> const& edits);

} // namespace tractus::document
