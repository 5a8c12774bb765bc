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

// Readers of the organ-related keys of a sketch's JSON object (line_sketch_file.h): arrangement and
// shape. Each fails with a user error that contains the key and what to write.

// Reads "pattern" (required), "divergence", "face" and "sizes".
Result<Pattern> read_pattern(nlohmann::json const& file);

// Organs of all layers.
struct LayersRead {
    std::vector<LayerOrgans> layers {}; // One entry per layer; see LineSketch::organs_per_layer.
    std::vector<OrganSource> organs {}; // Kinds of organs; `layers` refers to them by index.
};

// Loads an image file by the name that "texture" gives.
using PictureReader = std::function<Result<std::string>(std::string const& name)>;

// Reads "organs" of a sketch with this pattern; empty if the key is missing.
Result<LayersRead> read_organs(nlohmann::json const& file, Pattern const& pattern,
                               PictureReader const& pictures);

// Reads "organ"; the result has neither file nor patches if the key is missing. Also fails if the
// views do not define a surface or the texture is not an image.
Result<OrganSource> read_organ(nlohmann::json const& file, PictureReader const& pictures);

} // namespace tractus::lines
