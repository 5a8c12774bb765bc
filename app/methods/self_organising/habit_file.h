#pragma once

#include "engine/base/result.h"
#include "engine/methods/self_organising/habit.h"

#include <string>
#include <vector>

namespace tractus::self_organising {

// A habit that the user named: a file, or one of ours by its English or Latin name ("oak", "Quercus
// robur"). Fails, as the user's fault, listing ours, and like parse_habit() (habit_text.h).
Result<Habit> load_habit(std::string const& name);

// The English names of ours, in alphabetical order; none where they are not installed.
std::vector<std::string> habit_names();

} // namespace tractus::self_organising
