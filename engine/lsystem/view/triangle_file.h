#pragma once

#include "engine/lsystem/view/surface_file.h"

#include <string>
#include <string_view>

namespace tractus::lsystem {

// Reads a surface of triangles (cpfg's `tsurface:`): the word `triangle`, then three vertices, one
// per line. A vertex has three coordinates, along the turtle's left, its heading and cpfg's up. A
// normal and texture coordinates may follow and are ignored, because triangles are flat.
// Coordinates are multiplied by `size`. Other lines are skipped. Each triangle becomes a patch that
// narrows to a point. Fails with a user error of the form "FILE:LINE: ...".
Result<BezierSurface> parse_triangle_surface(std::string const& name, std::string_view text,
                                             double size);

} // namespace tractus::lsystem
