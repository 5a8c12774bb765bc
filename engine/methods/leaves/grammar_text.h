#pragma once

#include "engine/base/result.h"
#include "engine/methods/leaves/leaf_grammar.h"

#include <string>
#include <string_view>

namespace tractus::leaf {

// Tokenizer of a grammar's text; skips white space and comments.
class GrammarText {
public:
    GrammarText(std::string_view text, std::string name);

    TextPlace place() const; // Position of the next token.
    bool is_over() { return peek() == '\0'; }

    // The next significant character; '\0' at the end.
    char peek();
    bool next_is(std::string_view sign);
    // Consumes `sign` and returns true if the text continues with it; otherwise returns false.
    bool take(std::string_view sign);
    bool take_arrow();

    // Consumes `sign`; fails if the text does not continue with it.
    Result<void> expect(std::string_view sign);
    // Reads an identifier: letters, digits and underscores, not beginning with a digit. `what`
    // describes the identifier in error messages.
    Result<std::string_view> word(std::string_view what);
    Result<double> number();

    // With true, the end of the current line counts as the end of the text.
    void stay_in_line(bool stays) { stays_in_line_ = stays; }

    // fail_at() makes an error about a given position; the other two make one about the next token.
    tl::unexpected<Error> fail_at(TextPlace const& place, std::string const& what) const;
    tl::unexpected<Error> fail_here(std::string const& what);
    tl::unexpected<Error> fail_expected(std::string_view what);

private:
    void skip();
    void count_line();

    std::string_view text_;
    std::string name_;
    std::size_t at_ = 0;
    int line_ = 1; // Number, from 1, of the line that contains the position at_.
    std::size_t line_begin_ = 0;
    bool stays_in_line_ = false;
};

// Reads an expression in the C-like syntax of cpfg, with the operators ?: || && == != < <= > >= + -
// * / % ^ ! and function calls. If `in_angles`, the expression is enclosed in < and >, so
// comparisons must be in parentheses.
Result<Expression> read_expression(GrammarText& text, NameTable& names, bool in_angles = false);

} // namespace tractus::leaf
