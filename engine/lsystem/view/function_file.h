#pragma once

#include "engine/base/result.h"
#include "engine/lsystem/view/view.h"

#include <string>
#include <string_view>
#include <vector>

namespace tractus::lsystem {

// Reads a file of functions as cpfg's function editor writes them: one (`fver`) or a set of them
// (`funcgalleryver`). A function is a uniform cubic B-spline of control points `x y
// [multiplicity]`, x rising over [0, 1], that begins and ends in its end points, tabulated at
// `samples` places. Fails, as the user's fault, with file and line, for a function of fewer than
// four control points, a point without x and y, and a number of samples out of range.
Result<std::vector<FunctionTable>> parse_functions(std::string const& name, std::string_view text);

} // namespace tractus::lsystem
