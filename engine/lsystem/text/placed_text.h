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

// Text with the source position of each character.
struct PlacedText {
    std::string characters;
    std::vector<SourcePlace> places; // Source position of each character.

    void push(char character, SourcePlace place)
    {
        characters.push_back(character);
        places.push_back(place);
    }
    // Appends the characters [begin, end) of another text, with their positions.
    void append(PlacedText const& other, std::size_t begin, std::size_t end);
    std::size_t size() const { return characters.size(); }
};

// Returns a part of a text with its positions. `view` must be a view into the text's characters.
PlacedText part_of(PlacedText const& text, std::string_view view);

// Returns the user error "FILE:LINE:COLUMN: what" for the character at `index` of the text.
tl::unexpected<Error> error_in(PlacedText const& text, std::size_t index,
                               std::vector<std::string> const& files, std::string const& what);

// Returns the text of file number `file` without comments. Each /* */ comment becomes one blank, so
// that a rule may continue after a comment of several lines. A string literal is left unchanged if
// it ends in its line. If a comment does not end, `open_comment` is set to its beginning.
PlacedText without_comments(std::string_view source, std::uint32_t file,
                            std::optional<SourcePlace>& open_comment);

// Finds the places where // probably does not begin a comment but means two rolls, as in printed
// models. There it follows --> or Axiom: on its line, and is directly followed by text without
// blanks. Real comments in such places begin with a blank or contain words.
std::vector<SourcePlace> productions_cut_by_comments(std::string_view source, std::uint32_t file);

// Classes of characters in the preprocessor's tokens.
bool is_name_start(char c);
bool is_digit(char c);
bool is_blank(char c);

// Returns the end of the preprocessing token (C11 6.4) that begins at index `begin`: a name, a
// number with its suffixes, a string, or one character. Macro names inside numbers and strings are
// not replaced.
std::size_t token_end(std::string_view text, std::size_t begin);

// Returns the text without the blanks and line ends on both sides.
std::string_view trimmed_line(std::string_view text);

// Returns the name at the beginning of the text; empty if there is none.
std::string_view first_name(std::string_view text);

} // namespace tractus::lsystem
