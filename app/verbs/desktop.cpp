#include "app/verbs/desktop.h"

#include "app/desktop/completion.h"
#include "app/desktop/man_page.h"
#include "app/resources.h"
#include "app/terminal/console.h"
#include "drivers/file.h"

#include <filesystem>
#include <memory>

namespace tractus {

namespace {

Result<void> write_man_pages(CLI::App const& root, std::filesystem::path const& folder)
{
    TRY(make_folder(folder));
    TRY(write_file(folder / (man_page_name(root) + ".1"), program_man_page(root)));
    for (auto const* verb : root.get_subcommands({}))
        if (!verb->get_group().empty())
            TRY(write_file(folder / (man_page_name(*verb) + ".1"), verb_man_page(*verb)));
    return {};
}

void add_complete_verb(CLI::App& root, Action& action)
{
    auto* const verb = root.add_subcommand(
        "complete", "Print what may come next on a command line that is being typed");
    verb->group("");
    auto const typed = std::make_shared<std::vector<std::string>>();
    verb->add_option("WORD", *typed, "The words so far, after --; the last may be empty");
    verb->callback([&root, &action, typed] {
        action = [&root, typed] {
            return print_out(print_completion(complete(root, *typed, model_names())));
        };
    });
}

void add_man_pages_verb(CLI::App& root, Action& action)
{
    auto* const verb = root.add_subcommand("man-pages", "Write the manual pages into a folder");
    verb->group("");
    auto const folder = std::make_shared<std::string>();
    verb->add_option("FOLDER", *folder, "Made if it is not there")->required();
    verb->callback([&root, &action, folder] {
        action = [&root, folder] { return write_man_pages(root, *folder); };
    });
}

} // namespace

void add_desktop_verbs(CLI::App& root, Action& action)
{
    add_complete_verb(root, action);
    add_man_pages_verb(root, action);
}

} // namespace tractus
