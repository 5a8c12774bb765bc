#pragma once

#include "engine/base/result.h"
#include "engine/methods/sketch_lsystem/model_rule.h"
#include "engine/scene/plant_source.h"

#include <filesystem>
#include <string>
#include <vector>

namespace tractus::sketch {

// True for what is no file of a rule's numbers but a model: an L-system file, or one of ours by its
// name alone.
bool names_model(std::filesystem::path const& rule);

// Reads a model with what it includes, to be grown along a stroke. Fails like load_model_edit(),
// and as the user's fault for what names no model.
Result<sketch::ModelRule> load_model_rule(std::filesystem::path const& name);

// What "tractus lsystem check" says of a model's growing along strokes, as lines.
std::string describe_contract(std::filesystem::path const& model,
                              scene::LoadOptions const& options);

} // namespace tractus::sketch
