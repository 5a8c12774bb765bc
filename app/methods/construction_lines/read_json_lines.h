#pragma once

#include "engine/base/result.h"
#include "engine/base/vectors.h"

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace tractus::lines {

// Helper functions for reading a sketch's file (line_sketch_file.h).

// True if the object has this key with a value other than null.
bool has_value(nlohmann::json const& object, char const* key);

// Reads a line [[u, v], …] or [[u, v, w], …] in millimetres; a missing w is 0. Fails with a user
// error that contains the line's name `name`, the number of the wrong point from 1, and what to
// write.
Result<std::vector<Vec3>> read_line(nlohmann::json const& value, std::string const& name);

// Reads a line on the sheet, [[u, v], …]; if a point has a w, it is ignored.
Result<std::vector<Vec2>> read_flat_line(nlohmann::json const& value, std::string const& name);

} // namespace tractus::lines
