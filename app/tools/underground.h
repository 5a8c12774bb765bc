#pragma once

#include "app/tools/layer.h"
#include "engine/scene/scene.h"

#include <string>

namespace tractus::tools {

class Tool;

// What strokes have bent below the ground, roots aside: lines along these segments.
extern Layer const kUndergroundLayer;

// ToolKind::said of tools that bend branches: what the tool says when it is done and, where strokes
// have bent segments below the ground, how many. Empty where there are none.
std::string say_underground(Tool const& tool, scene::Scene const& after);

} // namespace tractus::tools
