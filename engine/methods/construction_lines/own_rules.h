#pragma once

#include "engine/base/result.h"
#include "engine/methods/construction_lines/line_model.h"
#include "engine/scene/plant_source.h"

namespace tractus::lines {

// Replaces the rules and the view of a sketch's model by rules and a view that the user has
// written. Everything that depends on the sketch is still inserted: the functions, the number of
// steps, the values defined by #define, and the arrays, each where the written rules have it. Fails
// with a user error if the written rules lack an array of the sketch, for example after a change
// for which the generated rules use more arrays.
Result<LineModel> with_own_rules(LineModel model, scene::SourceRules const& rules);

} // namespace tractus::lines
