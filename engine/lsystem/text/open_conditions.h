#pragma once

#include "engine/lsystem/text/macro_table.h"
#include "engine/lsystem/text/placed_text.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tractus::lsystem {

// The stack of the preprocessor's open #if conditions, which decides whether lines are used.
class OpenConditions {
public:
    static constexpr std::array<std::string_view, 8> kWords {
        "if", "ifdef", "ifndef", "elif", "else", "elifdef", "elifndef", "endif"
    };

    // The arguments must outlive this object. `files` contains the names of the files, for
    // positions in errors.
    OpenConditions(MacroTable& macros, std::vector<std::string> const& files)
        : macros_(macros)
        , files_(files)
    {
    }

    // Returns true if lines at this point are used, false if an open condition skips them.
    bool are_on() const
    {
        return open_.empty() || (open_.back().is_possible && open_.back().is_on);
    }

    // Executes the directive `word`; `rest` is the remainder of its line. Returns false if the word
    // is not a conditional directive. Conditions in skipped text are not evaluated. All errors are
    // user errors.
    Result<bool> execute_directive(PlacedText const& line, std::string_view word,
                                   std::string_view rest);

    // Begins a file. Its directives cannot end conditions that are already open. The result must be
    // passed to end_file().
    std::size_t begin_file() { return std::exchange(first_in_file_, open_.size()); }
    void end_file(std::size_t around) { first_in_file_ = around; }
    // Returns the position of the innermost condition that the present file has opened and not
    // closed.
    std::optional<SourcePlace> open_in_file() const;

private:
    // An open #if.
    struct Condition {
        bool is_on = false;  // True if the lines of the present part of the #if are used.
        bool was_on = false; // True if the lines of any part so far have been used.
        bool has_else = false;
        bool is_possible = true; // True if the text that contains the #if is used.
        SourcePlace place;
    };

    Result<void> next_part(PlacedText const& line, std::string_view word, std::string_view rest);
    Result<bool> value(PlacedText const& line, std::string_view rest);
    Result<PlacedText> without_defined(PlacedText const& text) const;
    Result<bool> is_defined(PlacedText const& line, std::string_view rest,
                            std::string_view word) const;
    tl::unexpected<Error> error(PlacedText const& text, std::size_t index,
                                std::string const& what) const
    {
        return error_in(text, index, files_, what);
    }

    MacroTable& macros_;
    std::vector<std::string> const& files_;
    std::vector<Condition> open_;
    std::size_t first_in_file_ = 0;
};

} // namespace tractus::lsystem
