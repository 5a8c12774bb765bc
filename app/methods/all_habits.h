#pragma once

#include "engine/base/result.h"
#include "engine/scene/edit_kind.h"

#include <cstdint>
#include <string>
#include <vector>

namespace tractus::methods {

// The habits of trees that come with the program, by their English names, in alphabetical order.
std::vector<std::string> habit_names();

// The edit that brings a tree which has grown by itself so many years. `habit` is one of ours by
// its English or Latin name, or a .habit file. Fails, as the user's fault, for a habit that there
// is not.
Result<scene::Edit> tree_of_habit(std::string const& habit, int years, std::uint64_t seed);

} // namespace tractus::methods
