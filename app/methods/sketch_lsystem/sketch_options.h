#pragma once

#include "app/methods/sketch_lsystem/sketch_tool.h"
#include "app/tools/tool_options.h"
#include "engine/methods/sketch_lsystem/grow_edit.h"
#include "engine/methods/sketch_lsystem/model_rule.h"
#include "engine/methods/sketch_lsystem/rule.h"

#include <optional>

namespace tractus::sketch {

void visit_sketch_options(tools::OptionVisitor& visitor, SketchTool& tool);

// The model that the tool's card stands for, by its seed 1; not set where it stands for a rule.
sketch::ModelRule model_of(SketchTool const& tool);

// The rule that the tool's card and numbers say; the usual one where the card stands for a model.
sketch::Rule rule_of(SketchTool const& tool);

// The rule with what the tool says of another one. What no option says, how many internodes there
// may be, stays; so does a stem that is thinner than the tool's, by the length of its internodes.
sketch::Rule with_options(sketch::Rule const& rule, SketchTool const& tool);

// Whether all that the tool says of a rule is so in this one, but for how thick it is.
bool says_rule(SketchTool const& tool, sketch::Rule const& rule);

// Whether all that the tool says is so in what has grown by a rule, or a model; chance does not
// count.
bool says_grown(SketchTool const& tool, sketch::GrowAlongStroke const& grown);

// The tool with the options that say this rule.
SketchTool saying_rule(SketchTool tool, sketch::Rule const& rule);

// The tool that says what the active plant has grown by.
SketchTool saying_grown(SketchTool const& tool, sketch::GrowAlongStroke const& grown);

// An angle of any size as one from -180 to 180 degrees.
double as_twist_deg(double angle_deg);

} // namespace tractus::sketch
