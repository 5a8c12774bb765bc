#pragma once

#include "engine/base/result.h"

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::lsystem {

// Gives the text of an included file by the name that stands in the including file.
using IncludeReader = std::function<Result<std::string>(std::string const& name)>;

// Where a character stood before macros and includes were expanded, or where a #line says that it
// did. Lines and columns count from 1.
struct SourcePlace {
    std::uint32_t file = 0; // Into SourceText::files.
    std::uint32_t line = 1;
    std::uint32_t column = 1;
};

// A model's text after the preprocessor: no comments, no directives, macros replaced.
struct SourceText {
    std::vector<std::string> files; // Names, for messages; the model's own first, #line's too.
    std::string text;
    std::vector<SourcePlace> places; // One per character, and one for the end.
    std::vector<std::string> warnings;

    // "FILE:LINE:COLUMN" of a character.
    std::string place(std::size_t index) const;
};

// C's preprocessor: comments of both kinds, #define with and without parameters and with # and ##,
// #undef, #include, #if, #ifdef, #ifndef, #elif, #elifdef, #elifndef, #else, #endif, #error,
// #warning, #line, also as `# 12 "FILE"`, #pragma once; __LINE__ and __FILE__. Other pragmas are
// passed over. A line that starts with `#` and none of these words is left alone, since # is a
// turtle symbol.
Result<SourceText> preprocess(std::string const& name, std::string_view text,
                              IncludeReader const& include);

} // namespace tractus::lsystem
