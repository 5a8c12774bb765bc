#pragma once

#include "engine/lsystem/view/view_reader.h"

namespace tractus::lsystem {

// Readers of those statements of cpfg that name a file. The values of the statements are: FILE
// [SAMPLES] for a function or a curve, FILE for a set of functions, ID FILE for a contour, LETTER
// FILE SIZE [S T [TEXTURE]] for a surface of patches, and LETTER FILE SIZE for a surface of
// triangles.
Result<void> read_function(ViewReader& reader, std::string_view value);
Result<void> read_function_set(ViewReader& reader, std::string_view value);
Result<void> read_curve(ViewReader& reader, std::string_view value);
Result<void> read_contour(ViewReader& reader, std::string_view value);
Result<void> read_surface(ViewReader& reader, std::string_view value);
Result<void> read_triangle_surface(ViewReader& reader, std::string_view value);

} // namespace tractus::lsystem
