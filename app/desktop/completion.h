#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace tractus::desktop {

// Words that may come next on a command line; a shell offers them when Tab is pressed.
struct Completion {
    struct Word {
        std::string text;  // Word that replaces the last one, which is being typed.
        std::string about; // Sentence that explains the word; may be empty.
    };
    std::vector<Word> words;

    // Whether names of files or folders may come next as well; the shell lists these itself.
    enum class Names { None, Folders, Files } names = Names::None;
};

// `typed` contains the words after the program's name; the last one is being typed and may be
// empty. "--option=value" may be one word, or three as split by bash. Only words that begin with
// the last one are offered; hidden commands are not. `models` are the plants offered for a model.
Completion complete(CLI::App& root, std::vector<std::string> typed,
                    std::vector<std::string> const& models);

// Formats a completion for the shell scripts: a line for each word, with a tab before its
// explanation, and finally ":files" or ":folders" if such names may follow.
std::string print_completion(Completion const& completion);

} // namespace tractus::desktop
