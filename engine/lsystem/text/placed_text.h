#pragma once

#include "engine/base/result.h"
#include "engine/lsystem/text/source_text.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::lsystem {

// Text each of whose characters knows where it stood.
struct PlacedText {
    std::string characters;
    std::vector<SourcePlace> places; // One per character.

    void push(char character, SourcePlace place)
    {
        characters.push_back(character);
        places.push_back(place);
    }
    // Appends characters `begin` to `end` of another text.
    void append(PlacedText const& other, std::size_t begin, std::size_t end);
    std::size_t size() const { return characters.size(); }
};

// A part of a text, which a view into its characters names.
PlacedText part_of(PlacedText const& text, std::string_view view);

// "FILE:LINE:COLUMN: what", as the user's fault, for a character of the text.
tl::unexpected<Error> error_in(PlacedText const& text, std::size_t index,
                               std::vector<std::string> const& files, std::string const& what);

// The text of a file, its number `file`, without comments: each becomes one blank, so a rule may go
// on behind one that spans lines. In strings that end in their line there are none. `open_comment`
// becomes the beginning of one that does not end.
PlacedText without_comments(std::string_view source, std::uint32_t file,
                            std::optional<SourcePlace>& open_comment);

// Where a // makes a comment of what looks like the rest of a production: it stands behind --> or
// Axiom: on its line, and text without blanks follows it at once, as in books, where // is two
// rolls. Comments begin with a blank there, or hold words.
std::vector<SourcePlace> productions_cut_by_comments(std::string_view source, std::uint32_t file);

// Characters that the preprocessor's tokens are made of.
bool is_name_start(char c);
bool is_digit(char c);
bool is_blank(char c);

// The end of the preprocessing token (C11 6.4) at `begin`: a name, a number with its suffixes, a
// string, or one character. Macro names inside numbers and strings are not replaced.
std::size_t token_end(std::string_view text, std::size_t begin);

// Removes the blanks, and line ends, on both sides.
std::string_view trimmed_line(std::string_view text);

// The name that the text begins with; empty for none.
std::string_view first_name(std::string_view text);

} // namespace tractus::lsystem
