#pragma once

#include "engine/base/result.h"
#include "engine/base/vectors.h"

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace tractus::lines {

// What all parts of a sketch's file have in common (line_sketch_file.h).

// Whether an object has such a key, with a value: null counts as nothing.
bool has_value(nlohmann::json const& object, char const* key);

// A line [[u, v], …] or [[u, v, w], …], millimetres; where there is no w it is 0. Fails, as the
// user's fault, with the name, the number of the point from 1, and what to write.
Result<std::vector<Vec3>> read_line(nlohmann::json const& value, std::string const& name);

// A line of a sheet: [[u, v]…], of which a w is left out.
Result<std::vector<Vec2>> read_flat_line(nlohmann::json const& value, std::string const& name);

} // namespace tractus::lines
