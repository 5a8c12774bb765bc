#pragma once

#include "engine/base/result.h"
#include "engine/methods/self_organising/habit.h"

#include <span>
#include <string>
#include <string_view>

namespace tractus::self_organising {

// Reads a habit from TOML. The keys `latin`, `leaves` and `bark` are strings; all other keys are
// the numbers of Habit (habit_numbers()). With `bark`, the bark's colours default to those of its
// kind. A missing number has its default in Habit, with two exceptions: a number for old trees
// defaults to that for young trees, and a number for higher branching orders to that for lower
// ones. Fails with a user error that names the file, line and key.
Result<Habit> parse_habit(std::string_view text, std::string const& name);

// Name and text of a built-in habit. The texts are compiled in, so that tools need no files.
struct HabitText {
    char const* name;
    char const* text;
    // True: numbers that the species had earlier, which old logs need. They follow the present
    // ones.
    bool is_earlier;
};
std::span<HabitText const> habit_texts();

} // namespace tractus::self_organising
