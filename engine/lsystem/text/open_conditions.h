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

// The preprocessor's conditions that are open: which lines are read.
class OpenConditions {
public:
    static constexpr std::array<std::string_view, 8> kWords {
        "if", "ifdef", "ifndef", "elif", "else", "elifdef", "elifndef", "endif"
    };

    // Both must outlive it; `files` are the names of the files that places are in.
    OpenConditions(MacroTable& macros, std::vector<std::string> const& files)
        : macros_(macros)
        , files_(files)
    {
    }

    // Whether lines are read.
    bool are_on() const
    {
        return open_.empty() || (open_.back().is_possible && open_.back().is_on);
    }

    // Obeys a directive `word` with what stands behind it in the line; false if the word is none of
    // a condition. What is not read is not computed, either. Errors are the user's.
    Result<bool> obey(PlacedText const& line, std::string_view word, std::string_view rest);

    // Begins a file, whose directives cannot end the conditions around it; returns what end_file()
    // is to be told.
    std::size_t begin_file() { return std::exchange(first_in_file_, open_.size()); }
    void end_file(std::size_t around) { first_in_file_ = around; }
    // Where the innermost condition began that the file has opened and not closed.
    std::optional<SourcePlace> open_in_file() const;

private:
    // One #if that is open.
    struct Condition {
        bool is_on = false;  // Its part that is being read is to be read.
        bool was_on = false; // One of its parts was.
        bool has_else = false;
        bool is_possible = true; // The text around it is read.
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
