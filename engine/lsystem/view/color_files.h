#pragma once

#include "engine/base/result.h"

#include <string>
#include <string_view>

namespace tractus::lsystem {

// Conversion of cpfg's colour files, which accompany a model, to `color:` statements of a view
// (view.h): text that can be stored with the model.

// Converts a colour map (.map): up to 256 colours of three bytes, red, green and blue. Fails with a
// user error if the file has none.
Result<std::string> color_map_statements(std::string const& name, std::string_view bytes);

// Converts a material file (.mat): records of 15 bytes with the colour's number, transparency,
// ambient, diffuse, emitted and reflected colour, and shininess. A surface's colour is the sum of
// diffuse and emitted; shinier materials get less roughness. Fails with a user error if the file
// has no record.
Result<std::string> material_file_statements(std::string const& name, std::string_view bytes);

} // namespace tractus::lsystem
