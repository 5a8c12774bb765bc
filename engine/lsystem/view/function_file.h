#pragma once

#include "engine/base/result.h"
#include "engine/lsystem/view/view.h"

#include <string>
#include <string_view>
#include <vector>

namespace tractus::lsystem {

// Reads functions in the format of cpfg's function editor: a single one (`fver`) or a set
// (`funcgalleryver`). A function is a uniform cubic B-spline with control points `x y
// [multiplicity]`, whose x ascends from 0 to 1. It begins and ends at its end points and is
// tabulated at `samples` places. Fails with a user error that gives file and line if a function has
// fewer than four control points, a point has no x and y, or the number of samples is out of range.
Result<std::vector<FunctionTable>> parse_functions(std::string const& name, std::string_view text);

} // namespace tractus::lsystem
