#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace tractus::desktop {

// Words that may come next on a command line. The shell offers them when Tab is pressed.
struct Completion {
    struct Word {
        std::string text;  // Replaces the last word of the command line, which is being typed.
        std::string about; // Sentence that explains `text`; may be empty.
    };
    std::vector<Word> words;

    // Whether the next word may also be the name of a file or folder. The shell lists such names
    // itself.
    enum class Names { None, Folders, Files } names = Names::None;
};

// Returns the words that can complete a command line. `typed` contains the words after the
// program's name; the last one is being typed and may be empty. "--option=value" may be one word,
// or three words as split by bash. Only words that begin with the last typed word are offered;
// hidden commands are not. `models` are the plants offered where a model is expected.
Completion complete(CLI::App& root, std::vector<std::string> typed,
                    std::vector<std::string> const& models);

// Formats a completion for the shell scripts: a line for each word, in which a tab separates the
// word from its explanation, and finally a line ":files" or ":folders" if names of files or folders
// may follow.
std::string print_completion(Completion const& completion);

} // namespace tractus::desktop
