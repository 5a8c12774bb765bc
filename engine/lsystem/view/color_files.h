#pragma once

#include "engine/base/result.h"

#include <string>
#include <string_view>

namespace tractus::lsystem {

// The files of colours that cpfg is given beside a model, as statements of a view (`color:`, see
// view.h): text, which can be kept with the model's others.

// A colour map (.map): 256 colours of three bytes, red, green and blue; fewer where the file is
// shorter. Fails, as the user's fault, where it has none.
Result<std::string> color_map_statements(std::string const& name, std::string_view bytes);

// Materials (.mat): records of 15 bytes, the colour's number, transparency, ambient, diffuse,
// emitted and reflected colour and shininess. A surface's colour is what it scatters and emits;
// shiny ones are less rough. Fails as above.
Result<std::string> material_file_statements(std::string const& name, std::string_view bytes);

} // namespace tractus::lsystem
