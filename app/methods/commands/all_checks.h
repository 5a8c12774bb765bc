#pragma once

#include "engine/scene/plant_source.h"

#include <filesystem>
#include <string>

namespace tractus {

// What methods say of a model that is checked: whether they can make something of it. Lines, each
// part with an empty one before it; the options are for what has to be grown to find out.
std::string describe_uses(std::filesystem::path const& model, LoadOptions const& options);

} // namespace tractus
