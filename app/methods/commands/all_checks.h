#pragma once

#include "engine/scene/plant_source.h"

#include <filesystem>
#include <string>

namespace tractus::methods {

// What methods say of a model that is checked: whether they can make something of it. Lines, each
// part with an empty one before it; the options are for what has to be grown to find out.
std::string describe_uses(std::filesystem::path const& model, scene::LoadOptions const& options);

} // namespace tractus::methods
