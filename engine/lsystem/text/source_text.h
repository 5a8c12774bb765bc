#pragma once

#include "engine/base/result.h"

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::lsystem {

// Returns the text of an included file, given its name in the including file.
using IncludeReader = std::function<Result<std::string>(std::string const& name)>;

// Position of a character before preprocessing, or the position that a #line directive gives it.
// Lines and columns count from 1.
struct SourcePlace {
    std::uint32_t file = 0; // Index of the file in SourceText::files.
    std::uint32_t line = 1;
    std::uint32_t column = 1;
};

// A model's text after preprocessing: without comments and directives, with macros replaced.
struct SourceText {
    // File names for messages: first the model's own name; also the names that #line directives
    // give.
    std::vector<std::string> files;
    std::string text;
    // Source position of each character of the text, and of its end.
    std::vector<SourcePlace> places;
    std::vector<std::string> warnings;

    // Returns the position of a character as "FILE:LINE:COLUMN".
    std::string place(std::size_t index) const;
};

// Runs a C preprocessor on a model. It supports comments of both kinds, #define with and without
// parameters and with # and ##, #undef, #include, #if, #ifdef, #ifndef, #elif, #elifdef, #elifndef,
// #else, #endif, #error, #warning, #line, also in the form `# 12 "FILE"`, #pragma once, __LINE__
// and __FILE__. Other pragmas are ignored. A line that begins with `#` and is not such a directive
// is kept, since # is a turtle symbol.
Result<SourceText> preprocess(std::string const& name, std::string_view text,
                              IncludeReader const& include);

} // namespace tractus::lsystem
