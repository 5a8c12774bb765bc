#pragma once

#include "engine/base/result.h"
#include "engine/lsystem/text/source_text.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace tractus::lsystem {

// A place in a preprocessed text from which a parser reads.
//
// Lines end statements, as in cpfg, but for three cases: inside the braces of a block of
// statements, when the next line starts with a tab, and when it starts with blanks and cannot be a
// statement of its own.
class Cursor {
public:
    explicit Cursor(SourceText const& source)
        : source_(&source)
    {
    }

    // Skips what separates tokens: blanks, and line ends that do not end the statement.
    void skip();

    // The character here, after skip(); '\n' at the statement's end, '\0' at the text's end.
    char peek();
    bool at_end() { return peek() == '\0'; }
    bool at_line_end() { return at_end() || peek() == '\n'; }

    // Whether `text` stands here, after skip().
    bool sees(std::string_view text);
    // Whether --> (or -o>, which cpfg has for instances in its rayshade output) stands here.
    bool sees_arrow() { return sees("-->") || sees("-o>"); }
    // Reads `text` if it stands here.
    bool take(std::string_view text);
    // Reads one character. Not at the text's end.
    char take_character();
    // Reads to the end of the line.
    std::string_view take_line();

    // Inside a block of statements lines end nothing.
    void enter_block() { ++block_depth_; }
    void leave_block() { --block_depth_; }
    // Says that from here on an arrow on a line of its own begins another rule.
    void set_arrow_seen(bool seen) { arrow_seen_ = seen; }

    std::size_t position() const { return at_; }
    void set_position(std::size_t position) { at_ = position; }
    std::string_view rest() const { return std::string_view(source_->text).substr(at_); }
    SourceText const& source() const { return *source_; }

    // "FILE:LINE:COLUMN: found …, expected …", for the place here.
    tl::unexpected<Error> unexpected(std::string_view expected);
    // "FILE:LINE:COLUMN: …"
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
