#pragma once

#include "engine/base/result.h"
#include "engine/lsystem/view/view.h"

#include <string>
#include <string_view>
#include <vector>

namespace tractus::lsystem {

// Reads functions in the format of cpfg's function editor: a single one (`fver`) or a set
// (`funcgalleryver`). A function is a uniform cubic B-spline of control points `x y [multiplicity]`
// with x ascending over [0, 1]. It begins and ends at its end points and is tabulated at `samples`
// places. Fails with a user error that gives file and line for a function with fewer than four
// control points, a point without x and y, or a number of samples out of range.
Result<std::vector<FunctionTable>> parse_functions(std::string const& name, std::string_view text);

} // namespace tractus::lsystem
