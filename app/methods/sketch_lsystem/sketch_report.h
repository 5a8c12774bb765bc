#pragma once

#include "engine/base/result.h"
#include "engine/lsystem/language/model.h"
#include "engine/methods/sketch_lsystem/drawn_axis.h"

#include <string>

namespace tractus::sketch {

// Returns what a stroke and a rule amount to, as one line of JSON for other programs:
//
//   segments   how many internodes the drawn axis has
//   nodes      [[x, y, z], …]: its base and the ends of its internodes as the model's turtle has
//   them,
//              millimetres on the desk, one more than segments
//   plane      [degrees, …]: before each segment, in which plane it bends,
//   bend       [degrees, …]: and by how much
//   depth      how often laterals may fork
//   counts     [{"F": 2, …}, …]: how often each letter stands in the string after step 1, 2, …
//
// Fails like derive().
Result<std::string> print_report(Rule const& rule, DrawnAxis const& axis, Model const& model);

} // namespace tractus::sketch
