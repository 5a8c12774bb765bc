// The commands `tractus record` and `tractus sim` without the rest of the program, for scenarios
// that must rebuild them.

#include "app/commands/record.h"
#include "app/commands/sim.h"
#include "app/methods/all_inputs.h"
#include "app/options/action.h"
#include "app/terminal/console.h"
#include "app/terminal/error_text.h"
#include "engine/base/file.h"

// Stub: the scenarios need no input that methods make.
tractus::Result<std::optional<std::string>>
tractus::methods::make_input(std::filesystem::path const&, std::string const&)
{
    return std::nullopt;
}

int main(int argc, char** argv)
{
    tractus::terminal::prepare_console();
    tractus::remove_unfinished_file_on_signals();
    CLI::App root;
    root.require_subcommand(1);
    tractus::options::Action action;
    tractus::commands::add_record_command(root, action, {});
    tractus::commands::add_sim_command(root, action);
    CLI11_PARSE(root, argc, argv);

    auto const result = action();
    if (result)
        return 0;
    tractus::terminal::print_error(
        tractus::terminal::error_text(result.error(), tractus::terminal::error_style()));
    return 1;
}
