#pragma once

#include "engine/methods/leaves/drawn_leaf.h"
#include "engine/methods/leaves/leaf_grammar.h"

#include <optional>
#include <string>

namespace tractus::leaf {

// Writes a drawn leaf as a grammar's text (parse_grammar()). Each parameter is a named variable on
// its own line, so that a slider or a keyboard can change it. If the grammar is derived with
// Leaf::Options::variation 0, it gives the drawn leaf. `title` is one line of text for the comment
// at the beginning.
std::string print_grammar(DrawnLeaf const& leaf, std::string const& title);

// Reads a drawn leaf's parameters from a grammar that print_grammar() has written; no value if one
// is missing.
std::optional<DrawnLeaf> read_drawn_leaf(Grammar const& grammar);

} // namespace tractus::leaf
