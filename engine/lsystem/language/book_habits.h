#pragma once

#include "engine/lsystem/language/names.h"

#include <optional>
#include <string>
#include <string_view>

namespace tractus::lsystem {

// Recognises notation of "The Algorithmic Beauty of Plants" that means something else in cpfg's
// language.

// Returns the label, such as "p1", if the line is a production with a label before it. A rule for
// two modules p and 1, with a condition, begins in the same way. After a label, however, a module
// follows the colon, not a variable: "p1: A --> AB" or "p2: A(t) : t > 0 --> A(t-1)".
std::optional<std::string> label_of_production(std::string_view line, Names const& names);
std::string describe_label(std::string_view label);

// Returns what to write in place of "->" or a typeset arrow, if the line has one of these and no
// -->; otherwise empty.
std::string describe_wrong_arrow(std::string_view line);

// True for "ω: F" and "w : F", which begin the axiom in books.
bool is_axiom_of_book(std::string_view line);

// True for "n=7, δ=22.5°", a derivation length with an angle increment.
bool is_figure_of_book(std::string_view line);

} // namespace tractus::lsystem
