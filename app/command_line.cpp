#include "app/command_line.h"

#include "app/verbs/decode.h"
#include "app/verbs/demo.h"
#include "app/verbs/derive.h"
#include "app/verbs/devices.h"
#include "app/verbs/grow.h"
#include "app/verbs/record.h"
#include "app/verbs/render.h"
#include "app/verbs/replay.h"
#include "app/verbs/verb.h"
#include "app/verbs/window.h"

#include <fmt/core.h>

namespace tractus {

static constexpr int kExitFailure = 1;
static constexpr int kExitUsage = 2;

static char const* prefix(Fault fault)
{
    switch (fault) {
    case Fault::User:
        return "error";
    case Fault::Device:
        return "device error";
    case Fault::Station:
        return "station error";
    }
    return "error";
}

int run_command_line(int argc, char const* const* argv)
{
    CLI::App root { "tractus: a 3D sketching station for plants", "tractus" };
    root.require_subcommand(0, 1);
    Action action;
    // Each verb registers itself here, in the order that --help lists them.
    add_decode_verb(root, action);
    add_demo_verb(root, action);
    add_derive_verb(root, action);
    add_devices_verb(root, action);
    add_grow_verb(root, action);
    add_record_verb(root, action);
    add_render_verb(root, action);
    add_replay_verb(root, action);
    add_window_verb(root, action);

    try {
        root.parse(argc, argv);
    } catch (CLI::ParseError const& error) {
        return root.exit(error) == 0 ? 0 : kExitUsage;
    }
    if (!action) {
        fmt::print("{}", root.help());
        return kExitUsage;
    }
    if (auto const result = action(); !result) {
        fmt::print(stderr, "{}: {}\n", prefix(result.error().fault), result.error().message);
        return kExitFailure;
    }
    return 0;
}

} // namespace tractus
