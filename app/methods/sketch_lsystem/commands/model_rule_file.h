#pragma once

#include "engine/base/result.h"
#include "engine/methods/sketch_lsystem/model_rule.h"
#include "engine/scene/plant_source.h"

#include <filesystem>
#include <string>
#include <vector>

namespace tractus::sketch {

// True if the name refers to a model, that is an L-system file or a built-in model by its bare
// name, rather than to a file with a rule's numbers.
bool names_model(std::filesystem::path const& rule);

// Reads a model and its includes, to be grown along a stroke. Fails like load_model_edit(), and
// with a user error if the name does not refer to a model.
Result<sketch::ModelRule> load_model_rule(std::filesystem::path const& name);

// A line for `tractus lsystem check`, after an empty one, that says whether a model can grow along
// strokes.
std::string describe_contract(std::filesystem::path const& model,
                              scene::LoadOptions const& options);

} // namespace tractus::sketch
