#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace tractus::lsystem {

// Parts of models as books print them. read_book_model() describes the notation. The functions take
// a line without its line end.

// A production as written, without its label: left < strict > right : condition -> successor. The
// probability is written after the arrow or, as in cpfg, after a colon.
struct BookProduction {
    std::string_view predecessor;
    std::string_view condition;
    std::string_view successor;
    std::string_view probability;
};
std::optional<BookProduction> book_production(std::string_view line);

// Returns the modules of an axiom, which follow "ω:", "w:", "omega:" or "axiom:". No value for
// other lines.
std::optional<std::string_view> book_axiom(std::string_view line);

// Derivation length and angle increment in a line such as "n=5, δ=22.5°", as written. A value that
// the line does not give is empty.
struct BookFigure {
    std::string steps;
    std::string angle;
};
std::optional<BookFigure> book_figure(std::string_view line);

// True for preprocessor directives and for the statements of cpfg other than an axiom.
bool is_cpfg_statement(std::string_view line);
bool begins_with_word(std::string_view line, std::string_view lower_case_word);

// Returns the line without a comment that begins with //.
std::string_view book_without_comment(std::string_view line);
// Returns the text with each /* */ comment replaced by blanks. Line ends in comments are kept.
std::string without_block_comments(std::string_view text);

// Translate modules and conditions to cpfg's notation.
std::string book_modules(std::string_view text);
std::string book_condition(std::string_view text);

} // namespace tractus::lsystem
