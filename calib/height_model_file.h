#pragma once

#include "calib/height_model.h"
#include "calib/toml_table.h"
#include "engine/base/result.h"

#include <string>

namespace tractus::calib {

// A height model in a rig file: the key `model` and, in the same table, the model's parameters.

// Parses a model. Fails with a user error naming file, line and key.
Result<HeightModel> parse_height_model(TomlTable& table);

// Prints the lines of a model, with comments that explain its numbers.
std::string print_height_model(HeightModel const& model);

} // namespace tractus::calib
