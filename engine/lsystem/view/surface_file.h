#pragma once

#include "engine/base/result.h"
#include "engine/plant/bezier_patch.h"

#include <string>
#include <string_view>
#include <vector>

namespace tractus::lsystem {

// A surface of Bézier patches as it stands in the turtle's frame at scale 1: x to the turtle's
// right, y along its heading, z to its upper side, the contact point at the origin. Turtle units.
struct BezierSurface {
    std::vector<BezierPatch> patches;
    Vec3 end_point = Vec3::Zero(); // Where the turtle is when it has drawn the surface.
};

// Reads a surface as cpfg's Bézier editor writes it (.s): a header with `CONTACT POINT`, `END
// POINT`, `HEADING`, `UP` and `SIZE`, then patches of a name, colours, the names of their
// neighbours and 16 points. The surface is scaled so that `SIZE` becomes `size` turtle units.
// Colours are left to the turtle. Fails, as the user's fault, with "FILE:LINE: …".
Result<BezierSurface> parse_surface(std::string const& name, std::string_view text, double size);

} // namespace tractus::lsystem
