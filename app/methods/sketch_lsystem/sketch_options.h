#pragma once

#include "app/methods/sketch_lsystem/sketch_tool.h"
#include "app/tools/tool_options.h"
#include "engine/methods/sketch_lsystem/rule.h"

namespace tractus {

void visit_sketch_options(OptionVisitor& visitor, SketchTool& tool);

// The rule that the tool's card and numbers say.
sketch::Rule rule_of(SketchTool const& tool);

// The rule with what the tool says of another one. What no option says, how many internodes there
// may be, stays; so does a stem that is thinner than the tool's, by the length of its internodes.
sketch::Rule with_options(sketch::Rule const& rule, SketchTool const& tool);

// Whether all that the tool says of a rule is so in this one, but for how thick it is.
bool says_rule(SketchTool const& tool, sketch::Rule const& rule);

// The tool with the options that say this rule.
SketchTool saying_rule(SketchTool tool, sketch::Rule const& rule);

// An angle of any size as one from -180 to 180 degrees.
double as_twist_deg(double angle_deg);

} // namespace tractus
