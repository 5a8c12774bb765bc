#pragma once

#include "engine/base/result.h"
#include "engine/methods/self_organising/habit.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::self_organising {

// Reads a habit from TOML: `latin` and `leaves` are texts, all else are the numbers of Habit by
// their names (habit_numbers()); what is missing is as in Habit, but that a number for old trees is
// as for young ones, and one for laterals as for the trunk. Fails, as the user's fault, naming
// file, line and key.
Result<Habit> parse_habit(std::string_view text, std::string const& name);

// A habit that the user named: a file, or one of ours by its English or Latin name ("oak", "Quercus
// robur"). Fails, as the user's fault, listing ours, and like parse_habit().
Result<Habit> load_habit(std::string const& name);

// The English names of ours, in alphabetical order; none where they are not installed.
std::vector<std::string> habit_names();

} // namespace tractus::self_organising
