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

// State that the statements of a view file share while it is read: the view so far, the place for
// messages, and the words that statements are made of.
struct ViewReader {
    SourceText const& source;
    IncludeReader const& include;
    View view {};
    std::size_t at = 0;                    // The statement's first character.
    std::set<std::string_view> missing {}; // Keys of statements that we lack, as far as said.

    void warn(std::string const& what);
    tl::unexpected<Error> error(std::string const& what) const;

    // Fail with what was found where the text is no number, or not three of them.
    Result<double> number(std::string_view text) const;
    Result<Vec3> vector(std::string_view text) const;

    // A file of the model's folder; no value, and a warning, where it cannot be read. `what` it is
    // and what happens `instead` complete that sentence.
    std::optional<std::string> file(std::string_view what, std::string const& name,
                                    std::string_view instead);
};

// Reads one statement's value into the reader's view. Fails, as the user's fault, with its place.
using ReadStatement = Result<void> (*)(ViewReader&, std::string_view value);

std::string_view trimmed(std::string_view text);

// The words of a text; any of the separators, and any number of them, stand between two.
std::vector<std::string_view> words(std::string_view text, std::string_view separators = " \t");

// The whole text as a finite number.
std::optional<double> number(std::string_view text);

} // namespace tractus::lsystem
