#pragma once

#include "engine/base/result.h"
#include "engine/methods/self_organising/habit.h"

#include <string>
#include <vector>

namespace tractus::self_organising {

// Loads the habit that the user named: the path of a file, or the English or Latin name of a
// built-in habit ("oak", "Quercus robur"). Fails with a user error that lists the built-in habits
// if there is no such habit, or that says what is wrong in the file.
Result<Habit> load_habit(std::string const& name);

// English names of the built-in habits, in alphabetical order. Empty if the habits are not
// installed.
std::vector<std::string> habit_names();

} // namespace tractus::self_organising
