#pragma once

#include "engine/base/result.h"
#include "engine/methods/self_organising/habit.h"

#include <string>
#include <vector>

namespace tractus::self_organising {

// Loads the habit that the user named: a file, or a built-in habit by its English or Latin name
// ("oak", "Quercus robur"). Fails with a user error that lists the built-in habits, and like
// parse_habit() (habit_text.h).
Result<Habit> load_habit(std::string const& name);

// English names of the built-in habits, in alphabetical order; empty if they are not installed.
std::vector<std::string> habit_names();

} // namespace tractus::self_organising
