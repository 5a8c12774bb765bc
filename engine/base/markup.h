#pragma once

#include <string>
#include <string_view>

namespace tractus {

// Returns text as it is written in SVG and HTML, both in elements and in quoted attributes: &, <, >
// and " are replaced by their entities.
std::string escape_markup(std::string_view text);

} // namespace tractus
