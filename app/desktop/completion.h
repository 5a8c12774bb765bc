#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace tractus::desktop {

// Words that may stand next on a command line that is being typed: a shell offers them when Tab is
// pressed.
struct Completion {
    struct Word {
        std::string text;  // Text in place of what has been typed of the last word.
        std::string about; // A sentence about it, or nothing.
    };
    std::vector<Word> words;

    // Names of files or folders that may stand there as well; the shell knows which there are.
    enum class Names { None, Folders, Files } names = Names::None;
};

// `typed` holds the words after the program's name, the last of which is being typed and may be
// empty. "--option=value" may be one word, or three, as bash takes it apart. Only what begins as
// the last word does is offered, hidden commands are not. `models` are the plants to offer for a
// model.
Completion complete(CLI::App& root, std::vector<std::string> typed,
                    std::vector<std::string> const& models);

// Prints a completion for the shells' scripts: a line for each word, with a tab before what it is
// about, and at last ":files" or ":folders" if names of such may follow.
std::string print_completion(Completion const& completion);

} // namespace tractus::desktop
