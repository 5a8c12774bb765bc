#pragma once

#include "engine/base/result.h"
#include "engine/methods/self_organising/habit.h"

#include <span>
#include <string>
#include <string_view>

namespace tractus::self_organising {

// Reads a habit from TOML: `latin` and `leaves` are strings, all other keys are the numbers of
// Habit by name (habit_numbers()). Missing numbers default to those of Habit, except that a number
// for old trees defaults to the one for young trees, and one for laterals to the one for the trunk.
// Fails with a user error that names the file, line and key.
Result<Habit> parse_habit(std::string_view text, std::string const& name);

// Name and text of a built-in habit. They are compiled in, so that tools need no files.
struct HabitText {
    char const* name;
    char const* text;
};
std::span<HabitText const> habit_texts();

} // namespace tractus::self_organising
