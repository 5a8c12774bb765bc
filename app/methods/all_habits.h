#pragma once

#include "engine/base/result.h"
#include "engine/scene/edit_kind.h"

#include <cstdint>
#include <string>
#include <vector>

namespace tractus::methods {

// English names of the built-in tree habits (growth presets of species), in alphabetical order.
std::vector<std::string> habit_names();

// Returns the edit that adds a tree grown without strokes for `years` years. `habit` is the English
// or Latin name of a built-in habit, or the path of a .habit file. Fails with a user error if there
// is no such habit.
Result<scene::Edit> tree_of_habit(std::string const& habit, int years, std::uint64_t seed);

} // namespace tractus::methods
