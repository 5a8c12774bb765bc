#pragma once

#include "engine/base/result.h"
#include "engine/methods/leaves/leaf_grammar.h"

#include <string>
#include <string_view>

namespace tractus::leaf {

// A grammar's text as it is read: words and signs, with spaces and comments passed over.
class GrammarText {
public:
    GrammarText(std::string_view text, std::string name);

    TextPlace place() const; // Place of what comes next.
    bool is_over() { return peek() == '\0'; }

    // The next character that means something; '\0' at the end.
    char peek();
    bool next_is(std::string_view sign);
    // Whether that comes next; takes it if so.
    bool take(std::string_view sign);
    bool take_arrow();

    // Fails if it is not there.
    Result<void> expect(std::string_view sign);
    // Letters, digits and underscores, the first no digit. `what` it is to be, for messages.
    Result<std::string_view> word(std::string_view what);
    Result<double> number();

    // Up to the end of this, nothing comes after the line's end.
    void stay_in_line(bool stays) { stays_in_line_ = stays; }

    // Fails with what is wrong at that place, or at the next character.
    tl::unexpected<Error> fail_at(TextPlace const& place, std::string const& what) const;
    tl::unexpected<Error> fail_here(std::string const& what);
    tl::unexpected<Error> fail_expected(std::string_view what);

private:
    void skip();
    void count_line();

    std::string_view text_;
    std::string name_;
    std::size_t at_ = 0;
    int line_ = 1; // Line of at_.
    std::size_t line_begin_ = 0;
    bool stays_in_line_ = false;
};

// C-like, as cpfg has them: ?: || && == != < <= > >= + - * / % ^ ! and calls. With `in_angles` it
// stands between < and >, where a comparison needs parentheses.
Result<Expression> read_expression(GrammarText& text, NameTable& names, bool in_angles = false);

} // namespace tractus::leaf
