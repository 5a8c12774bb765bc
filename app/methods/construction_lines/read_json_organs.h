#pragma once

#include "engine/base/result.h"
#include "engine/methods/construction_lines/organ_surface.h"
#include "engine/methods/construction_lines/pattern.h"

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace tractus::lines {

// What a sketch's file, an object, says of its organs by the keys of line_sketch_file.h: how they
// stand and what they are. Each fails, as the user's fault, with the key and what to write.

// From "pattern", "divergence" and "sizes", of which the first has to be there.
Result<Pattern> read_pattern(nlohmann::json const& file);

// From "organs": names of files, or empty ones; none if it says nothing.
Result<std::vector<std::string>> read_organs(nlohmann::json const& file);

// From "organ": no value if it says nothing. Fails for views that give no surface, too.
Result<std::optional<OrganViews>> read_organ(nlohmann::json const& file);

} // namespace tractus::lines
