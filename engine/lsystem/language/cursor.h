#pragma once

#include "engine/base/result.h"
#include "engine/lsystem/text/source_text.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace tractus::lsystem {

// The reading position of a parser in a preprocessed text.
//
// As in cpfg, the end of a line ends a statement, with three exceptions: inside the braces of a
// block of statements, if the next line begins with a tab, and if the next line begins with blanks
// and is not a rule of its own.
class Cursor {
public:
    explicit Cursor(SourceText const& source)
        : source_(&source)
    {
    }

    // Skips whitespace between tokens: blanks, and line ends that do not end the statement.
    void skip();

    // Returns the next character after skip(): '\n' at the end of a statement, '\0' at the end of
    // the text.
    char peek();
    bool at_end() { return peek() == '\0'; }
    bool at_line_end() { return at_end() || peek() == '\n'; }

    // Skips blanks, then returns true if `text` comes next.
    bool sees(std::string_view text);
    // Returns true if an arrow comes next: --> or -o>, which cpfg uses for instances in its
    // rayshade output.
    bool sees_arrow() { return sees("-->") || sees("-o>"); }
    // Consumes `text` and returns true if it comes next; otherwise returns false.
    bool take(std::string_view text);
    // Consumes one character. Must not be called at the end of the text.
    char take_character();
    // Consumes the rest of the line, and returns it.
    std::string_view take_line();

    // Between these two calls, line ends have no meaning: the parser is in a block of statements.
    void enter_block() { ++block_depth_; }
    void leave_block() { --block_depth_; }
    // Sets whether the current rule already has its arrow. If so, a following line with an arrow
    // begins another rule.
    void set_arrow_seen(bool seen) { arrow_seen_ = seen; }

    std::size_t position() const { return at_; }
    void set_position(std::size_t position) { at_ = position; }
    std::string_view rest() const { return std::string_view(source_->text).substr(at_); }
    SourceText const& source() const { return *source_; }

    // Returns the error "FILE:LINE:COLUMN: found ..., expected ..." for the current position.
    tl::unexpected<Error> unexpected(std::string_view expected);
    // Returns the error "FILE:LINE:COLUMN: ..." for the current position.
    tl::unexpected<Error> error(std::string_view what) const { return error_at(at_, what); }
    tl::unexpected<Error> error_at(std::size_t position, std::string_view what) const;

private:
    bool continues_after(std::size_t line_end) const;

    SourceText const* source_;
    std::size_t at_ = 0;
    int block_depth_ = 0;
    bool arrow_seen_ = false;
};

} // namespace tractus::lsystem
