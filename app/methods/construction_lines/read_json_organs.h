#pragma once

#include "app/methods/construction_lines/organ_source.h"
#include "engine/base/result.h"
#include "engine/methods/construction_lines/layer_organs.h"
#include "engine/methods/construction_lines/pattern.h"

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace tractus::lines {

// What a sketch's file, an object, says of its organs by the keys of line_sketch_file.h: how they
// stand and what they are. Each fails, as the user's fault, with the key and what to write.

// From "pattern", "divergence", "face" and "sizes", of which the first has to be there.
Result<Pattern> read_pattern(nlohmann::json const& file);

// What layers bear.
struct LayersRead {
    std::vector<LayerOrgans> layers {}; // As LineSketch::organs_per_layer has them.
    std::vector<OrganSource> organs {}; // In the order of their numbers.
};

// Gives the file of a picture by the name that the sketch says, "texture" of views.
using PictureReader = std::function<Result<std::string>(std::string const& name)>;

// From "organs", of a sketch with this pattern; nothing if it says nothing.
Result<LayersRead> read_organs(nlohmann::json const& file, Pattern const& pattern,
                               PictureReader const& pictures);

// From "organ"; neither file nor patches if it says nothing. Fails for views that give no surface,
// too, and for what is no picture.
Result<OrganSource> read_organ(nlohmann::json const& file, PictureReader const& pictures);

} // namespace tractus::lines
