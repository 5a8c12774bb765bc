#pragma once

#include "engine/lsystem/view/view_reader.h"

namespace tractus::lsystem {

// Readers of cpfg's statements that name a file: FILE [SAMPLES] for a function or a curve, FILE for
// a set of functions, ID FILE for a contour, LETTER FILE SIZE [S T [TEXTURE]] for a surface of
// patches, LETTER FILE SIZE for a surface of triangles.
Result<void> read_function(ViewReader& reader, std::string_view value);
Result<void> read_function_set(ViewReader& reader, std::string_view value);
Result<void> read_curve(ViewReader& reader, std::string_view value);
Result<void> read_contour(ViewReader& reader, std::string_view value);
Result<void> read_surface(ViewReader& reader, std::string_view value);
Result<void> read_triangle_surface(ViewReader& reader, std::string_view value);

} // namespace tractus::lsystem
