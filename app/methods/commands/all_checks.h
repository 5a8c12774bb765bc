#pragma once

#include "engine/scene/plant_source.h"

#include <filesystem>
#include <string>

namespace tractus::methods {

// Describes which methods can use a model that was checked. Returns lines of text; an empty line
// precedes the part of each method. Some methods grow the model for this, with `options`.
std::string describe_uses(std::filesystem::path const& model, scene::LoadOptions const& options);

} // namespace tractus::methods
