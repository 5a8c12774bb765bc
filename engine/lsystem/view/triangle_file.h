#pragma once

#include "engine/lsystem/view/surface_file.h"

#include <string>
#include <string_view>

namespace tractus::lsystem {

// Reads a surface of triangles (cpfg's `tsurface:`): the word `triangle`, then three vertices, each
// on a line of its own: three coordinates, to the turtle's left, along its heading and to cpfg's
// up, and perhaps a normal and texture coordinates, which are passed over: triangles are flat. The
// coordinates are multiplied by `size`. Other lines are left out. Each triangle becomes a patch
// that narrows to a point. Fails, as the user's fault, with "FILE:LINE: …".
Result<BezierSurface> parse_triangle_surface(std::string const& name, std::string_view text,
                                             double size);

} // namespace tractus::lsystem
