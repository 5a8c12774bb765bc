#pragma once

#include "app/tools/layer.h"
#include "engine/scene/scene.h"

#include <string>
#include <vector>

namespace tractus::tools {

class Tool;

// Layer of the segments, except roots, that strokes have bent below the ground.
extern Layer const kUndergroundLayer;

// Layer of the segments that are bent below the ground only by growth, not by strokes. The view
// that grows the plant supplies the layer's lines.
extern Layer const kGrownUndergroundLayer;

// The segments of the base plant, except roots, that strokes have bent below the ground, in
// ascending order.
std::vector<SegmentId> segments_bent_underground(scene::BuiltPlant const& plant);

// ToolKind::describe for tools that bend branches. If strokes have bent segments below the ground,
// returns the tool's message ToolKind::done and the number of these segments; otherwise empty.
std::string underground_message(Tool const& tool, scene::Scene const& after);

} // namespace tractus::tools
