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

constexpr int kMaxSides = 9'999; // Number of side labels, C1 to C9999.

// True for a single capital letter.
bool is_face(std::string_view word);

// Takes an edge label, "O", "E" or "C" with a number from 1 on, off the beginning of `word`.
std::optional<EdgeLabel> take_edge(std::string_view& word);

// Parses a whole word as an edge label.
std::optional<EdgeLabel> edge_of(std::string_view word);

// State shared by the parsers of directives and rules: the text, the grammar so far, and the names
// used in the text, which can be checked only at its end.
struct GrammarReader {
    // An edge that a face must have. If `splits`, the face must also be splittable parallel to it.
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
    // Reads a face letter that must be defined somewhere in the text.
    Result<char> known_face();
    // Evaluates an expression in a definition. Only names defined earlier have values there.
    Result<double> constant(Expression const& expression, TextPlace const& place);
    // Reads a parenthesised list of `least` to `most` numbers. Names in it must have values
    // already.
    Result<std::vector<double>> numbers(std::size_t least, std::size_t most, std::string_view what);
    // Reads a parenthesised list of fields; empty if there are no parentheses.
    Result<Fields> fields();

    GrammarText text;
    Grammar grammar {};
    std::vector<std::pair<char, TextPlace>> named_faces {};
    std::vector<EdgeUse> named_edges {};
    TextPlace left_place {}; // Position of "#left", whose tip must be that of "#outline".
    bool has_axiom = false;
};

// Reads what follows a "#" into the grammar. Fails with a user error that gives the position.
Result<void> read_directive(GrammarReader& reader);

// Reads a rule, beginning with its name, into the grammar. Fails with a user error that gives the
// position.
Result<void> read_rule(GrammarReader& reader);

} // namespace tractus::leaf
