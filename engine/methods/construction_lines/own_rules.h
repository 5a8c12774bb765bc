#pragma once

#include "engine/base/result.h"
#include "engine/methods/construction_lines/line_model.h"
#include "engine/scene/plant_source.h"

namespace tractus::lines {

// A sketch's model with rules and a view that somebody has written in place of its own. What the
// sketch says stays its own: the functions, how many steps there are, the numbers that are defined
// by #define, and the arrays, each in the place where the written rules have it.
//
// Fails, as the user's fault, where the written rules lack an array of the sketch's, as after a
// change for which its own rules read more.
Result<LineModel> with_own_rules(LineModel model, scene::SourceRules const& rules);

} // namespace tractus::lines
