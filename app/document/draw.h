#pragma once

#include "app/tools/tool.h"
#include "engine/base/result.h"
#include "engine/scene/edit.h"
#include "engine/scene/scene.h"

#include <string>
#include <vector>

namespace tractus::document {

// A finished stroke and what it meant.
struct DrawnStroke {
    Stroke stroke;
    tools::Tool tool;
    std::string refusal {};            // Why it changed nothing; empty if it did.
    std::vector<scene::Edit> edits {}; // Edits that it made; none if it was refused.
    std::string said {};               // What a person is told of it in place of its tool's `done`.
};

// See ToolKind::said.
std::string said_of(tools::Tool const& tool, scene::Scene const& after);

// Applies a stroke in the hand of a tool to a scene: all of its edits, or none if one is refused.
DrawnStroke draw(Stroke stroke, tools::Tool const& tool, scene::Scene& scene);

// The scene after edits that belong together; models cost what load_options() says. Fails where one
// of them does.
Result<scene::Scene> scene_after(scene::Scene scene, std::vector<scene::Edit> const& edits);

} // namespace tractus::document
