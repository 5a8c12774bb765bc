#pragma once

#include "engine/base/result.h"
#include "engine/methods/sketch_lsystem/model_rule.h"
#include "engine/scene/plant_source.h"

#include <filesystem>
#include <string>
#include <vector>

namespace tractus::sketch {

// True if `rule` refers to a model: an L-system file, or a built-in model by its bare name. False
// if it refers to a file with the numbers of a rule.
bool names_model(std::filesystem::path const& rule);

// Reads a model and its includes, to be grown along a stroke. Fails with a user error if `name`
// does not refer to a model or the model cannot be loaded.
Result<sketch::ModelRule> load_model_rule(std::filesystem::path const& name);

// Text for `tractus lsystem check` that says whether a model can grow along strokes: an empty line
// and a sentence. Empty if the model cannot be loaded.
std::string describe_contract(std::filesystem::path const& model,
                              scene::LoadOptions const& options);

} // namespace tractus::sketch
