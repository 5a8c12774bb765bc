#pragma once

#include "engine/lsystem/language/names.h"

#include <optional>
#include <string>
#include <string_view>

namespace tractus::lsystem {

// Functions that recognise notation of "The Algorithmic Beauty of Plants" that means something
// else, or nothing, in cpfg's language.

// Returns the label, such as "p1", if the line is a production that begins with a label. In cpfg's
// language such a line may also be a rule for two modules, p and 1, with a condition. The two are
// told apart by what follows the colon, which after a label is a module, not a variable: "p1: A -->
// AB" or "p2: A(t) : t > 0 --> A(t-1)".
std::optional<std::string> label_of_production(std::string_view line, Names const& names);
std::string describe_label(std::string_view label);

// Returns a message that asks for --> if the line has "->", "=>" or a typeset arrow instead.
// Returns an empty string if it has -->, or no arrow.
std::string describe_wrong_arrow(std::string_view line);

// True for a line such as "ω: F" or "w : F", by which books give the axiom.
bool is_axiom_of_book(std::string_view line);

// True for a line such as "n=7, δ=22.5°", by which books give the derivation length and the angle
// increment.
bool is_figure_of_book(std::string_view line);

} // namespace tractus::lsystem
