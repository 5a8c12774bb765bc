#pragma once

#include "engine/base/result.h"

#include <string>
#include <string_view>

namespace tractus::lsystem {

// Conversion of the colour files of cpfg that accompany a model to `color:` statements of a view
// (view.h), which can be stored with the model as text.

// Converts a colour map (.map): up to 256 colours of three bytes, for red, green and blue. Fails
// with a user error if the file contains no colour.
Result<std::string> color_map_statements(std::string const& name, std::string_view bytes);

// Converts a material file (.mat): records of 15 bytes with a material's number, transparency,
// ambient, diffuse, emitted and reflected colour, and shininess. A surface's colour is the sum of
// the diffuse and the emitted colour; shinier materials become less rough. Fails with a user error
// if the file contains no record.
Result<std::string> material_file_statements(std::string const& name, std::string_view bytes);

} // namespace tractus::lsystem
