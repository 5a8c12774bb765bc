#include "app/commands/desktop.h"

#include "app/desktop/completion.h"
#include "app/desktop/man_page.h"
#include "app/files/resources.h"
#include "app/terminal/console.h"
#include "engine/base/file.h"

#include <filesystem>
#include <memory>

namespace tractus::commands {

namespace {

Result<void> write_man_pages(CLI::App const& root, std::filesystem::path const& folder)
{
    TRY(make_folder(folder));
    TRY(write_file(folder / (desktop::man_page_name(root) + ".1"),
                   desktop::program_man_page(root)));
    for (auto const* command : root.get_subcommands({}))
        if (!command->get_group().empty())
            TRY(write_file(folder / (desktop::man_page_name(*command) + ".1"),
                           desktop::command_man_page(*command)));
    return {};
}

void add_complete_command(CLI::App& root, options::Action& action)
{
    auto* const command = root.add_subcommand(
        "complete", "Print what may come next on a command line that is being typed");
    command->group("");
    auto const typed = std::make_shared<std::vector<std::string>>();
    command->add_option("WORD", *typed, "The words so far, after --; the last may be empty");
    command->callback([&root, &action, typed] {
        action = [&root, typed] {
            return terminal::print_out(
                desktop::print_completion(desktop::complete(root, *typed, files::model_names())));
        };
    });
}

void add_man_pages_command(CLI::App& root, options::Action& action)
{
    auto* const command = root.add_subcommand("man-pages", "Write the manual pages into a folder");
    command->group("");
    auto const folder = std::make_shared<std::string>();
    command->add_option("FOLDER", *folder, "Made if it is not there")->required();
    command->callback([&root, &action, folder] {
        action = [&root, folder] { return write_man_pages(root, *folder); };
    });
}

} // namespace

void add_desktop_commands(CLI::App& root, options::Action& action)
{
    add_complete_command(root, action);
    add_man_pages_command(root, action);
}

} // namespace tractus::commands
