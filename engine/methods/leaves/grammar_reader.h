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

// Maximum number of edges of a face; the highest side label is C9999.
constexpr int kMaxSides = 9'999;

// True for a single capital letter.
bool is_face(std::string_view word);

// Removes an edge label, "O", "E" or "C" with a number from 1 on, from the beginning of `word`. No
// value, and no change, if `word` does not begin with one.
std::optional<EdgeLabel> take_edge(std::string_view& word);

// Parses a whole word as an edge label.
std::optional<EdgeLabel> edge_of(std::string_view word);

// State shared by the parsers of directives and rules: the text, the grammar read so far, and uses
// of faces and edges that can be checked only at the end of the text.
struct GrammarReader {
    // A use of an edge, for which the face must have this edge. If `splits`, the face must also be
    // splittable parallel to it.
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
    // Reads the letter of a face that must be defined somewhere in the text.
    Result<char> known_face();
    // Evaluates an expression in a definition. Only names defined earlier in the text have values
    // there.
    Result<double> constant(Expression const& expression, TextPlace const& place);
    // Reads a parenthesised list of at least `least` and at most `most` numbers. Names in it must
    // have been defined earlier in the text.
    Result<std::vector<double>> numbers(std::size_t least, std::size_t most, std::string_view what);
    // Reads a parenthesised list of fields; empty if there are no parentheses.
    Result<Fields> fields();

    GrammarText text;
    Grammar grammar {};
    std::vector<std::pair<char, TextPlace>> named_faces {};
    std::vector<EdgeUse> named_edges {};
    // Position of the directive "#left", whose tip must be that of "#outline".
    TextPlace left_place {};
    bool has_axiom = false;
};

// Reads a directive, whose "#" has already been read, into the grammar. Fails with a user error
// that gives the position.
Result<void> read_directive(GrammarReader& reader);

// Reads a rule, beginning with its name, into the grammar. Fails with a user error that gives the
// position.
Result<void> read_rule(GrammarReader& reader);

} // namespace tractus::leaf
