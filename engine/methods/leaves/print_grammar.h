#pragma once

#include "engine/methods/leaves/drawn_leaf.h"
#include "engine/methods/leaves/leaf_grammar.h"

#include <optional>
#include <string>

namespace tractus::leaf {

// A drawn leaf as a grammar's text (parse_grammar). Each number has a line of its own, by name, so
// that a slider or a keyboard can change it; derived with Options::variation 0, the grammar gives
// the drawn leaf. `title` is one line of text, for the remark at its begin.
std::string print_grammar(DrawnLeaf const& leaf, std::string const& title);

// The numbers that such a text names. No value for a grammar that does not name them all.
std::optional<DrawnLeaf> read_drawn_leaf(Grammar const& grammar);

} // namespace tractus::leaf
