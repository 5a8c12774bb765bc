#pragma once

#include "engine/lsystem/language/names.h"

#include <optional>
#include <string>
#include <string_view>

namespace tractus::lsystem {

// Habits of "The Algorithmic Beauty of Plants" that mean something else in cpfg's language.

// Returns the label, such as "p1", if the line is a production with a label before it. A rule for
// two modules p and 1, with a condition, begins in the same way; it is told from a label by what
// follows the colon: a module's name that is no variable, as in "p1: A --> AB" and
// "p2: A(t) : t > 0 --> A(t-1)".
std::optional<std::string> label_of_production(std::string_view line, Names const& names);
std::string describe_label(std::string_view label);

// Says what to write in place of "->" or a typeset arrow, if the line has one of these and no -->.
// Empty otherwise.
std::string describe_wrong_arrow(std::string_view line);

// True for "ω: F" and "w : F", which begin the axiom in books.
bool is_axiom_of_book(std::string_view line);

// True for "n=7, δ=22.5°", a derivation length with an angle increment.
bool is_figure_of_book(std::string_view line);

} // namespace tractus::lsystem
