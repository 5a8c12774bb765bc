#pragma once

#include "engine/base/result.h"
#include "engine/plant/bezier_patch.h"

#include <string>
#include <string_view>
#include <vector>

namespace tractus::lsystem {

// A surface of Bézier patches in the turtle's frame at scale 1: x to the turtle's right, y along
// its heading, z to its upper side. The contact point is at the origin. Lengths are in turtle
// units.
struct BezierSurface {
    std::vector<BezierPatch> patches;
    Vec3 end_point = Vec3::Zero(); // Position of the turtle after it has drawn the surface.
};

// Reads a surface in the format of cpfg's Bézier editor (.s): a header with `CONTACT POINT`, `END
// POINT`, `HEADING`, `UP` and `SIZE`, then patches. Each patch has a name, colours, the names of
// its neighbours and 16 points. The surface is scaled so that `SIZE` becomes `size` turtle units.
// The file's colours are ignored, since surfaces have the turtle's colour. Fails with a user error
// of the form "FILE:LINE: ...".
Result<BezierSurface> parse_surface(std::string const& name, std::string_view text, double size);

} // namespace tractus::lsystem
