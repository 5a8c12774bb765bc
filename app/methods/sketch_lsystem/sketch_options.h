#pragma once

#include "app/methods/sketch_lsystem/sketch_tool.h"
#include "app/tools/tool_options.h"
#include "engine/methods/sketch_lsystem/grow_edit.h"
#include "engine/methods/sketch_lsystem/model_rule.h"
#include "engine/methods/sketch_lsystem/rule.h"

#include <optional>

namespace tractus::sketch {

void visit_sketch_options(tools::OptionVisitor& visitor, SketchTool& tool);

// The model for which the tool's preset stands, with the seed 1. Not set if the preset is a rule or
// a copy of the active plant.
sketch::ModelRule model_of(SketchTool const& tool);

// The rule that the tool's preset and numbers give; if the preset is not a rule, the default rule.
sketch::Rule rule_of(SketchTool const& tool);

// The rule with the tool's settings applied. Numbers of the rule for which the tool has no option,
// such as the maximum number of internodes, are kept. So is a stem more slender than that of the
// tool.
sketch::Rule with_options(sketch::Rule const& rule, SketchTool const& tool);

// True if the rule agrees with all settings of the tool except the thickness.
bool matches_rule(SketchTool const& tool, sketch::Rule const& rule);

// True if the sketch `grown` was grown by the tool's rule or model, regardless of the random seed.
bool matches_sketch(SketchTool const& tool, sketch::GrowAlongStroke const& grown);

// The tool with its options set to the numbers of this rule.
SketchTool with_options_of_rule(SketchTool tool, sketch::Rule const& rule);

// The tool with its options set to the rule or model of the sketch `grown`.
SketchTool with_options_of_sketch(SketchTool const& tool, sketch::GrowAlongStroke const& grown);

// Wraps an angle to the range -180 to 180 degrees.
double wrap_angle_deg(double angle_deg);

} // namespace tractus::sketch
