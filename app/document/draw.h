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
    std::string refusal {};            // Why the stroke was refused; empty if it changed the scene.
    std::vector<scene::Edit> edits {}; // Edits that the stroke made; empty if it was refused.
    std::string message {}; // Message for the user in place of ToolKind::done; may be empty.
};

// Message of the tool's ToolKind::describe for the scene after the stroke; empty if the kind has no
// such function.
std::string describe_result(tools::Tool const& tool, scene::Scene const& after);

// Changes a scene by a stroke drawn with a tool: applies all of the stroke's edits, or none if one
// of them is refused.
DrawnStroke draw(Stroke stroke, tools::Tool const& tool, scene::Scene& scene);

// The scene after applying edits in order. Models run within the default limits of load_options().
// Fails if any of the edits fails.
Result<scene::Scene> scene_after(scene::Scene scene, std::vector<scene::Edit> const& edits);

} // namespace tractus::document
