#include "app/command_line.h"

#include "app/help.h"
#include "app/terminal/console.h"
#include "app/terminal/error_text.h"
#include "app/verbs/calibrate.h"
#include "app/verbs/convert.h"
#include "app/verbs/decode.h"
#include "app/verbs/demo.h"
#include "app/verbs/derive.h"
#include "app/verbs/desktop.h"
#include "app/verbs/devices.h"
#include "app/verbs/doctor.h"
#include "app/verbs/grow.h"
#include "app/verbs/lsystem.h"
#include "app/verbs/record.h"
#include "app/verbs/render.h"
#include "app/verbs/replay.h"
#include "app/verbs/session.h"
#include "app/verbs/sim.h"
#include "app/verbs/stream.h"
#include "app/verbs/tools.h"
#include "app/verbs/vary.h"
#include "app/verbs/verb.h"
#include "app/verbs/watch.h"
#include "app/verbs/window.h"
#include "engine/base/printable.h"

#include <exception>
#include <fmt/core.h>
#include <memory>
#include <new>

namespace tractus {

static constexpr int kExitFailure = 1;
static constexpr int kExitUsage = 2;

static int fail_usage(CLI::App const& root, std::string const& message)
{
    std::string command = root.get_name();
    for (auto chosen = root.get_subcommands(); !chosen.empty();
         chosen = chosen.front()->get_subcommands())
        command += " " + chosen.front()->get_name();
    print_error(fmt::format("error: {}; see \"{} --help\"\n", printable(message, "\n\t"), command));
    return kExitUsage;
}

static int fail_action(Error const& error)
{
    print_error(error_text(error, error_style()));
    return kExitFailure;
}

// The action's result; what the system or a library throws on the way is one, too.
static Result<void> carry_out(Action const& action)
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

// Registers each verb, in the order that --help lists them.
static void add_verbs(CLI::App& root, Action& action, Methods const& methods)
{
    add_demo_verb(root, action, methods);
    add_window_verb(root, action, methods);
    add_replay_verb(root, action, methods);
    add_session_verb(root, action, methods);
    add_vary_verb(root, action, methods);
    add_grow_verb(root, action, methods);
    for (auto* const add : methods.commands)
        add(root, action, methods);
    add_render_verb(root, action, methods);
    add_derive_verb(root, action);
    add_lsystem_verb(root, action);
    add_devices_verb(root, action);
    add_doctor_verb(root, action);
    add_watch_verb(root, action);
    add_calibrate_verb(root, action);
    add_record_verb(root, action, methods.tools);
    add_stream_verb(root, action, methods);
    add_sim_verb(root, action);
    add_tools_verb(root, action, methods);
    add_decode_verb(root, action);
    add_convert_verb(root, action, methods);
    add_desktop_verbs(root, action);
}

int run_command_line(int argc, char const* const* argv, Methods const& methods)
{
    CLI::App root { "tractus: a 3D sketching station for plants", "tractus" };
    root.formatter(std::make_shared<HelpFormatter>());
    root.set_help_flag("-h,--help", "Print this help");
    root.set_version_flag("--version", "tractus " TRACTUS_VERSION, "Print the version");
    root.require_subcommand(0, 1);
    Action action;
    add_verbs(root, action, methods);
    for (auto* const verb : root.get_subcommands({})) {
        verb->set_help_flag("-h,--help", "Print this help");
        if (!verb->get_group().empty()) // Verbs without a group are not listed.
            verb->group("Verbs");
    }
    root.footer( // After the verbs, which would inherit it.

        "\"tractus VERB --help\" says what each can do; \"tractus demo\" is the way to begin.\n"
        "Exit codes: 0 success, 1 a failure that the message on standard error explains,\n"
        "2 wrong usage.");

    try {
        root.parse(argc, argv);
    } catch (CLI::CallForHelp const&) {
        action = [&] { return print_out(root.help()); };
    } catch (CLI::CallForVersion const&) {
        action = [&] { return print_out(root.version() + "\n"); };
    } catch (CLI::ParseError const& error) {
        return fail_usage(root, error.what());
    }
    if (!action)
        return fail_usage(root, "a verb is missing, such as demo");
    auto const result = carry_out(action);
    return result ? 0 : fail_action(result.error());
}

} // namespace tractus
