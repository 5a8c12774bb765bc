#pragma once

#include "engine/base/result.h"
#include "engine/lsystem/text/source_text.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace tractus::lsystem {

// A parser's reading position in a preprocessed text.
//
// As in cpfg, the end of a line ends a statement, except inside the braces of a block of
// statements, if the next line begins with a tab, or if it begins with blanks and cannot be a
// statement of its own.
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

    // Returns true if `text` comes next after skip().
    bool sees(std::string_view text);
    // Returns true if --> comes next, or -o>, which cpfg uses for instances in its rayshade output.
    bool sees_arrow() { return sees("-->") || sees("-o>"); }
    // Consumes `text` if it comes next.
    bool take(std::string_view text);
    // Consumes one character. Must not be called at the end of the text.
    char take_character();
    // Consumes the rest of the line.
    std::string_view take_line();

    // Line ends have no meaning in a block of statements.
    void enter_block() { ++block_depth_; }
    void leave_block() { --block_depth_; }
    // If `seen` is true, an arrow on a line of its own begins another rule from here on.
    void set_arrow_seen(bool seen) { arrow_seen_ = seen; }

    std::size_t position() const { return at_; }
    void set_position(std::size_t position) { at_ = position; }
    std::string_view rest() const { return std::string_view(source_->text).substr(at_); }
    SourceText const& source() const { return *source_; }

    // Makes the error "FILE:LINE:COLUMN: found ..., expected ..." for the current position.
    tl::unexpected<Error> unexpected(std::string_view expected);
    // Makes the error "FILE:LINE:COLUMN: ...".
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
