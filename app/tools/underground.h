#pragma once

#include "app/tools/layer.h"
#include "engine/scene/scene.h"

#include <string>

namespace tractus::tools {

class Tool;

// Layer of the segments, except roots, that strokes have bent below the ground.
extern Layer const kUndergroundLayer;

// ToolKind::said for tools that bend branches: the tool's own message and, if strokes have bent
// segments below the ground, their number. Empty if there are none.
std::string say_underground(Tool const& tool, scene::Scene const& after);

} // namespace tractus::tools
