#pragma once

#include "app/methods/sketch_lsystem/sketch_tool.h"
#include "app/tools/tool_options.h"
#include "engine/methods/sketch_lsystem/grow_edit.h"
#include "engine/methods/sketch_lsystem/model_rule.h"
#include "engine/methods/sketch_lsystem/rule.h"

#include <optional>

namespace tractus::sketch {

void visit_sketch_options(tools::OptionVisitor& visitor, SketchTool& tool);

// The model that the tool's preset stands for, with seed 1; not set if the preset is a rule.
sketch::ModelRule model_of(SketchTool const& tool);

// The rule given by the tool's preset and numbers; the default rule if the preset is a model.
sketch::Rule rule_of(SketchTool const& tool);

// The rule with the tool's settings applied. Numbers without an option, such as the most
// internodes, are kept, and so is a stem more slender than the tool's.
sketch::Rule with_options(sketch::Rule const& rule, SketchTool const& tool);

// True if the rule agrees with all of the tool's settings except thickness.
bool matches_rule(SketchTool const& tool, sketch::Rule const& rule);

// True if the sketch was grown by the tool's rule or model, whatever its random seed.
bool matches_sketch(SketchTool const& tool, sketch::GrowAlongStroke const& grown);

// The tool with its options set to this rule.
SketchTool with_options_of_rule(SketchTool tool, sketch::Rule const& rule);

// The tool with its options set to the rule or model of the sketch `grown`.
SketchTool with_options_of_sketch(SketchTool const& tool, sketch::GrowAlongStroke const& grown);

// Wraps an angle to the range -180 to 180 degrees.
double wrap_angle_deg(double angle_deg);

} // namespace tractus::sketch
