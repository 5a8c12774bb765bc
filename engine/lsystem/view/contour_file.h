#pragma once

#include "engine/base/result.h"
#include "engine/plant/contour.h"

#include <string>
#include <string_view>

namespace tractus::lsystem {

// Reads a contour as cpfg's contour editor writes it: `cver`, `name:`, `points:`, `type:` and lines
// `x y z [multiplicity]`, or, without a version, `COUNT DIMENSION open|closed` and the points. The
// points control a uniform cubic B-spline. A closed contour is turned about the origin until it
// begins on the positive x axis, and runs from x to y whichever way it was drawn. Fails, as the
// user's fault, with "FILE:LINE: …".
Result<Contour> parse_contour(std::string const& name, std::string_view text);

} // namespace tractus::lsystem
