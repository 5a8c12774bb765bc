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
#include "engine/base/nearest_word.h"
#include "engine/base/printable.h"

#include <algorithm>
#include <exception>
#include <fmt/core.h>
#include <fmt/ranges.h>
#include <map>
#include <memory>
#include <new>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::commands {

static constexpr int kExitFailure = 1;
static constexpr int kExitUsage = 2;

// Returns the commands that the arguments name, from the root to the innermost subcommand.
static std::vector<CLI::App const*> chosen_commands(CLI::App const& root)
{
    std::vector<CLI::App const*> chosen { &root };
    for (auto below = root.get_subcommands(); !below.empty();
         below = below.front()->get_subcommands())
        chosen.push_back(below.front());
    return chosen;
}

static int fail_usage(CLI::App const& root, std::string const& message)
{
    std::string command;
    for (auto const* const part : chosen_commands(root))
        command += (command.empty() ? "" : " ") + part->get_name();
    terminal::print_error(
        fmt::format("error: {}; see \"{} --help\"\n", printable(message, "\n\t"), command));
    return kExitUsage;
}

static std::vector<std::string> option_names(CLI::App const& command)
{
    std::vector<std::string> names;
    for (auto const* const option : command.get_options())
        for (auto const& name : option->get_lnames())
            names.push_back("--" + name);
    return names;
}

static std::vector<std::string> command_names(CLI::App const& parent)
{
    std::vector<std::string> names;
    for (auto const* const command : parent.get_subcommands({}))
        // --help does not list commands without a group.
        if (!command->get_group().empty())
            names.push_back(command->get_name());
    return names;
}

// Returns "; replay and vary have it", to append to the name of an option that the command lacks,
// or an empty string if no other command has the option.
static std::string others_with_option(CLI::App const& root, std::string const& option)
{
    std::vector<std::string> others;
    for (auto const* const command : root.get_subcommands({})) {
        auto const options = option_names(*command);
        if (!command->get_group().empty() && std::ranges::find(options, option) != options.end())
            others.push_back(command->get_name());
    }
    if (others.empty())
        return {};
    return fmt::format("; {} {} it", fmt::join(others, " and "),
                       others.size() == 1 ? "has" : "have");
}

// Returns the message about wrong arguments. Unknown words are reported first, as a misspelt word
// may be the cause of a missing argument.
static std::string usage_error(CLI::App const& root, CLI::ParseError const& error)
{
    auto const extras = root.remaining(true);
    auto const is_option = [](std::string_view word) { return word.starts_with('-'); };
    auto const& command = *chosen_commands(root).back();
    if (auto const option = std::find_if(extras.begin(), extras.end(), is_option);
        option != extras.end()) {
        auto const name = option->substr(0, option->find('='));
        auto const meant = did_you_mean(name, option_names(command));
        return fmt::format("there is no option {}{}", name,
                           meant.empty() ? others_with_option(root, name) : meant);
    }
    if (extras.empty())
        return error.what();
    auto const& word = extras.front();
    auto const commands = command_names(command);
    if (!commands.empty())
        return fmt::format("there is no command {}{}", word, did_you_mean(word, commands));
    return fmt::format("unexpected argument {}", word);
}

static int fail_action(Error const& error)
{
    terminal::print_error(terminal::error_text(error, terminal::error_style()));
    return kExitFailure;
}

// Runs the action and converts exceptions thrown by the system or by libraries to errors.
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

// Registers all commands, in the order in which --help lists them.
static void add_commands(CLI::App& root, options::Action& action, tools::Methods const& methods)
{
    add_demo_command(root, action, methods);
    add_tour_command(root, action, methods);
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

// Sets the headings under which --help lists the commands, by the user's activity.
static void group_commands(CLI::App& root)
{
    static std::map<std::string, std::string, std::less<>> const groups {
        { "window", "Draw" },       { "replay", "Draw" },        { "session", "Draw" },
        { "demo", "Draw" },         { "tour", "Draw" },          { "vary", "Make plants" },
        { "grow", "Make plants" },  { "render", "Make plants" }, { "derive", "Language" },
        { "lsystem", "Language" },  { "devices", "Devices" },    { "doctor", "Devices" },
        { "watch", "Devices" },     { "calibrate", "Devices" },  { "record", "Devices" },
        { "stream", "Devices" },    { "sim", "Devices" },        { "tools", "Recordings" },
        { "decode", "Recordings" }, { "convert", "Recordings" },
    };
    for (auto* const command : root.get_subcommands({})) {
        command->set_help_flag("-h,--help", "Print this help");
        for (auto* const below : command->get_subcommands({}))
            if (!below->get_group().empty())
                below->group("Commands");
        // --help does not list commands without a group.
        if (command->get_group().empty())
            continue;
        auto const group = groups.find(command->get_name());
        // Commands that methods add belong to "Make plants".
        command->group(group == groups.end() ? "Make plants" : group->second);
    }
}

// Returns the arguments after the program's name in reverse order, as CLI::App::parse() expects
// them. Converts "help X" to "X --help".
static std::vector<std::string> reversed_arguments(int argc, char const* const* argv)
{
    std::vector<std::string> words(argv + std::min(1, argc), argv + argc);
    if (!words.empty() && words.front() == "help") {
        words.erase(words.begin());
        words.push_back("--help");
    }
    std::reverse(words.begin(), words.end());
    return words;
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
    group_commands(root);
    root.footer( // Set after the commands are added, as they would inherit the footer.

        "\"tractus COMMAND --help\" says what each can do; \"tractus demo\" is the way to begin.\n"
        "Exit codes: 0 success, 1 a failure that the message on standard error explains,\n"
        "2 wrong usage.");

    try {
        root.parse(reversed_arguments(argc, argv));
    } catch (CLI::CallForHelp const& help) {
        if (!root.remaining(true).empty()) // Help was requested together with an unknown command.
            return fail_usage(root, usage_error(root, help));
        action = [&] { return terminal::print_out(root.help()); };
    } catch (CLI::CallForVersion const&) {
        action = [&] { return terminal::print_out(root.version() + "\n"); };
    } catch (CLI::ParseError const& error) {
        return fail_usage(root, usage_error(root, error));
    }
    if (!action)
        return fail_usage(root, "a command is missing, such as demo");
    auto const result = carry_out(action);
    return result ? 0 : fail_action(result.error());
}

} // namespace tractus::commands
