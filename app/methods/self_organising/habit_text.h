#pragma once

#include "engine/base/result.h"
#include "engine/methods/self_organising/habit.h"

#include <span>
#include <string>
#include <string_view>

namespace tractus::self_organising {

// Reads a habit from TOML: `latin` and `leaves` are texts, all else are the numbers of Habit by
// their names (habit_numbers()); what is missing is as in Habit, but that a number for old trees is
// as for young ones, and one for laterals as for the trunk. Fails, as the user's fault, naming
// file, line and key.
Result<Habit> parse_habit(std::string_view text, std::string const& name);

// The habits that come with the program, in the program itself, so that a tool needs no file.
struct HabitText {
    char const* name;
    char const* text;
};
std::span<HabitText const> habit_texts();

} // namespace tractus::self_organising
