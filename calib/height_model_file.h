#pragma once

#include "calib/height_model.h"
#include "calib/toml_table.h"
#include "engine/base/result.h"

#include <string>

namespace tractus::calib {

// A height model in a rig file: the key `model` and, in the same table, the model's own numbers.

// Fails as the user's fault, naming file, line and key.
Result<HeightModel> parse_height_model(TomlTable& table);

// The lines for a model, with comments that say what its numbers mean.
std::string print_height_model(HeightModel const& model);

} // namespace tractus::calib
