#pragma once

#include "engine/methods/leaves/grammar_text.h"
#include "engine/methods/leaves/leaf_grammar.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tractus::leaf {

constexpr int kMostSides = 9'999; // The text's C1 to C9999.

// A capital letter alone.
bool is_face(std::string_view word);

// "O", "E" or "C" and a number from 1 on, at a word's beginning; the rest is left in `word`.
std::optional<EdgeLabel> take_edge(std::string_view& word);

// The edge that is all of a word.
std::optional<EdgeLabel> edge_of(std::string_view word);

// What reading a directive and reading a rule have in common: the text, the grammar as far as it
// has been read, and what the text has named, which can be checked only at its end.
struct GrammarReader {
    // An edge that a face must have, and be split along if the rule says so.
    struct EdgeUse {
        char face;
        EdgeLabel edge;
        std::string word;
        bool splits;
        TextPlace place;
    };

    GrammarReader(std::string_view from, std::string const& name)
        : text(from, name)
    {
        grammar.name = name;
    }

    Result<char> face();
    // One that must be defined somewhere.
    Result<char> known_face();
    // Value of what a definition says: by then earlier definitions have values, and nothing else.
    Result<double> constant(Expression const& expression, TextPlace const& place);
    // Reads that many numbers in parentheses, all of which have values by now.
    Result<std::vector<double>> numbers(std::size_t least, std::size_t most, std::string_view what);
    // Nothing where there are no parentheses.
    Result<Fields> fields();

    GrammarText text;
    Grammar grammar {};
    std::vector<std::pair<char, TextPlace>> named_faces {};
    std::vector<EdgeUse> named_edges {};
    TextPlace left_place {}; // Of "#left", whose tip must be that of "#outline".
    bool has_axiom = false;
};

// Reads what stands behind a "#" into the grammar. Fails, as the user's fault, with the place.
Result<void> read_directive(GrammarReader& reader);

// Reads a rule, from its name on, into the grammar. Fails, as the user's fault, with the place.
Result<void> read_rule(GrammarReader& reader);

} // namespace tractus::leaf
