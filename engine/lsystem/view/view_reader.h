#pragma once

#include "engine/base/result.h"
#include "engine/lsystem/text/source_text.h"
#include "engine/lsystem/view/view.h"

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::lsystem {

// State shared by the functions that read the statements of a view file: the view so far, the
// position for messages, and the parsing of words.
struct ViewReader {
    SourceText const& source;
    IncludeReader const& include;
    View view {};
    std::size_t at = 0; // Index of the statement's first character.
    // Keys of those unsupported statements of which a warning has been given.
    std::set<std::string_view> missing {};

    void warn(std::string const& what);
    tl::unexpected<Error> error(std::string const& what) const;

    // Parse one number, and three; fail with a user error that quotes the text.
    Result<double> number(std::string_view text) const;
    Result<Vec3> vector(std::string_view text) const;

    // Reads a file of the model's folder. If it cannot be read, returns no value and adds a
    // warning, in which `what` names the kind of file and `instead` says what happens instead.
    std::optional<std::string> file(std::string_view what, std::string const& name,
                                    std::string_view instead);
};

// Reads the value of one statement into the reader's view. Fails with a user error that gives the
// position.
using ReadStatement = Result<void> (*)(ViewReader&, std::string_view value);

std::string_view trimmed(std::string_view text);

// Splits a text into words at runs of the characters in `separators`.
std::vector<std::string_view> words(std::string_view text, std::string_view separators = " \t");

// Parses the whole text as a finite number; no value if it is not one.
std::optional<double> number(std::string_view text);

} // namespace tractus::lsystem
