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

// The functions of this file read the keys about organs from the JSON object of a sketch
// (line_sketch_file.h). Each fails with a user error that contains the key and what to write.

// Reads "pattern" (required), "divergence", "face" and "sizes".
Result<Pattern> read_pattern(nlohmann::json const& file);

// Organs of each layer, and the kinds of organs to which they refer.
struct LayersRead {
    std::vector<LayerOrgans> layers {}; // Organs of each layer (LineSketch::organs_per_layer).
    std::vector<OrganSource> organs {}; // Kinds of organs, to which `layers` refers by index.
};

// Loads the image file whose name the key "texture" gives.
using PictureReader = std::function<Result<std::string>(std::string const& name)>;

// Reads the key "organs" of a sketch with this pattern; empty if the key is missing.
Result<LayersRead> read_organs(nlohmann::json const& file, Pattern const& pattern,
                               PictureReader const& pictures);

// Reads the key "organ". If the key is missing, the result has neither a file nor patches. Fails
// also if the views do not define a surface or the texture is not an image.
Result<OrganSource> read_organ(nlohmann::json const& file, PictureReader const& pictures);

} // namespace tractus::lines
