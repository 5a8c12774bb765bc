#include "app/commands/tools.h"

#include "app/options/checks.h"
#include "app/terminal/console.h"
#include "app/tools/tool_table.h"

#include <memory>
#include <string>
#include <vector>

namespace tractus::commands {

static std::vector<std::string> words_of(tools::ToolKinds kinds)
{
    std::vector<std::string> words;
    for (auto const* const kind : kinds)
        words.emplace_back(kind->word);
    return words;
}

void add_tools_command(CLI::App& root, options::Action& action, tools::Methods const& methods)
{
    auto word = std::make_shared<std::string>();
    auto* const command = root.add_subcommand(
        "tools", "List what a pen can mean: the words of a recording's tool lines, and the keys");
    command->add_option("TOOL", *word, "Only this one, by its word")
        ->check(options::one_of(words_of(methods.tools)));
    command->footer(
        "Words in [brackets] may stand behind a tool's own, one of each pair of brackets.");
    command->callback([word, methods, &action] {
        action = [word, methods]() -> Result<void> {
            std::string text;
            for (auto const* const kind : methods.tools)
                if (word->empty() || *word == kind->word)
                    text += tools::describe_tool(*kind);
            return terminal::print_out(text);
        };
    });
}

} // namespace tractus::commands
