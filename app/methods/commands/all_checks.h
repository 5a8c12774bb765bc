#pragma once

#include "engine/scene/plant_source.h"

#include <filesystem>
#include <string>

namespace tractus::methods {

// Describes which methods can use a checked model. Returns lines of text; an empty line precedes
// each part. Some checks grow the model, with `options`.
std::string describe_uses(std::filesystem::path const& model, scene::LoadOptions const& options);

} // namespace tractus::methods
