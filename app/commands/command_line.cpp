#include "app/commands/command_line.h"

#include "app/commands/calibrate.h"
#include "app/commands/convert.h"
#include "app/commands/decode.h"
#include "app/commands/demo.h"
#include "app/commands/derive.h"
#include "app/commands/desktop.h"
#include "app/commands/devices.h"
#include "app/commands/doctor.h"
#include "app/commands/grow.h"
#include "app/commands/lsystem.h"
#include "app/commands/record.h"
#include "app/commands/render.h"
#include "app/commands/replay.h"
#include "app/commands/session.h"
#include "app/commands/sim.h"
#include "app/commands/stream.h"
#include "app/commands/tools.h"
#include "app/commands/vary.h"
#include "app/commands/watch.h"
#include "app/commands/window.h"
#include "app/options/action.h"
#include "app/options/help.h"
#include "app/terminal/console.h"
#include "app/terminal/error_text.h"
#include "engine/base/printable.h"

#include <exception>
#include <fmt/core.h>
#include <memory>
#include <new>

namespace tractus::commands {

static constexpr int kExitFailure = 1;
static constexpr int kExitUsage = 2;

static int fail_usage(CLI::App const& root, std::string const& message)
{
    std::string command = root.get_name();
    for (auto chosen = root.get_subcommands(); !chosen.empty();
         chosen = chosen.front()->get_subcommands())
        command += " " + chosen.front()->get_name();
    terminal::print_error(
        fmt::format("error: {}; see \"{} --help\"\n", printable(message, "\n\t"), command));
    return kExitUsage;
}

static int fail_action(Error const& error)
{
    terminal::print_error(terminal::error_text(error, terminal::error_style()));
    return kExitFailure;
}

// The action's result; what the system or a library throws on the way is one, too.
static Result<void> carry_out(options::Action const& action)
{
    try {
        return action();
    } catch (std::bad_alloc const&) {
        return fail(Fault::User,
                    "there is not enough memory for this: derive fewer steps, make fewer plants "
                    "or a smaller picture");
    } catch (std::exception const& error) {
        return fail(Fault::Station, error.what());
    }
}

// Registers each command, in the order that --help lists them.
static void add_commands(CLI::App& root, options::Action& action, tools::Methods const& methods)
{
    add_demo_command(root, action, methods);
    add_window_command(root, action, methods);
    add_replay_command(root, action, methods);
    add_session_command(root, action, methods);
    add_vary_command(root, action, methods);
    add_grow_command(root, action, methods);
    for (auto* const add : methods.commands)
        add(root, action, methods);
    add_render_command(root, action, methods);
    add_derive_command(root, action);
    add_lsystem_command(root, action);
    add_devices_command(root, action);
    add_doctor_command(root, action);
    add_watch_command(root, action);
    add_calibrate_command(root, action);
    add_record_command(root, action, methods.tools);
    add_stream_command(root, action, methods);
    add_sim_command(root, action);
    add_tools_command(root, action, methods);
    add_decode_command(root, action);
    add_convert_command(root, action, methods);
    add_desktop_commands(root, action);
}

int run_command_line(int argc, char const* const* argv, tools::Methods const& methods)
{
    CLI::App root { "tractus: a 3D sketching station for plants", "tractus" };
    root.formatter(std::make_shared<options::HelpFormatter>());
    root.set_help_flag("-h,--help", "Print this help");
    root.set_version_flag("--version", "tractus " TRACTUS_VERSION, "Print the version");
    root.require_subcommand(0, 1);
    options::Action action;
    add_commands(root, action, methods);
    for (auto* const command : root.get_subcommands({})) {
        command->set_help_flag("-h,--help", "Print this help");
        if (!command->get_group().empty()) // Commands without a group are not listed.
            command->group("Commands");
    }
    root.footer( // After the commands, which would inherit it.

        "\"tractus COMMAND --help\" says what each can do; \"tractus demo\" is the way to begin.\n"
        "Exit codes: 0 success, 1 a failure that the message on standard error explains,\n"
        "2 wrong usage.");

    try {
        root.parse(argc, argv);
    } catch (CLI::CallForHelp const&) {
        action = [&] { return terminal::print_out(root.help()); };
    } catch (CLI::CallForVersion const&) {
        action = [&] { return terminal::print_out(root.version() + "\n"); };
    } catch (CLI::ParseError const& error) {
        return fail_usage(root, error.what());
    }
    if (!action)
        return fail_usage(root, "a command is missing, such as demo");
    auto const result = carry_out(action);
    return result ? 0 : fail_action(result.error());
}

} // namespace tractus::commands
