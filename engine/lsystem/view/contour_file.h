#pragma once

#include "engine/base/result.h"
#include "engine/plant/contour.h"

#include <string>
#include <string_view>

namespace tractus::lsystem {

// Reads a contour in the format of cpfg's contour editor. The file contains `cver`, `name:`,
// `points:`, `type:` and lines `x y z [multiplicity]`; or, in the older format, `COUNT DIMENSION
// open|closed` and the points. The points are control points of a uniform cubic B-spline. A closed
// contour is rotated about the origin so that it begins on the positive x axis, and reversed if
// necessary so that it runs from the x to the y axis. Fails with a user error of the form
// "FILE:LINE: ...".
Result<Contour> parse_contour(std::string const& name, std::string_view text);

} // namespace tractus::lsystem
