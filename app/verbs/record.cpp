#include "app/verbs/record.h"

#include "app/console.h"
#include "app/live_recording.h"
#include "app/model_file.h"
#include "app/resources.h"
#include "app/simulated_recording.h"
#include "app/verbs/checks.h"
#include "calib/rig_file.h"
#include "drivers/device_kind.h"
#include "drivers/file.h"
#include "drivers/hid_source.h"

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fmt/core.h>
#include <fstream>
#include <memory>

namespace tractus {

namespace {

namespace fs = std::filesystem;

struct Arguments {
    fs::path output;
    std::optional<double> seconds;
    std::vector<std::string> nodes;
    std::string rig;
    std::string script;
    std::string model = "broadleaf";
};

std::atomic<bool> stop_asked = false;

void ask_to_stop(int)
{
    stop_asked = true;
}

// A recording cannot be made again, so it is never written over.
Result<void> check_new(fs::path const& path)
{
    std::error_code error;
    if (fs::exists(path, error))
        return fail(Fault::User,
                    fmt::format("{} is already there: choose another name, a recording "
                                "is never written over",
                                path.string()));
    return {};
}

// The nodes that were named, or else every pen and height sensor.
Result<std::vector<DeviceInfo>> choose_devices(std::vector<std::string> const& nodes)
{
    std::vector<DeviceInfo> chosen;
    for (auto const& device : enumerate_hid()) {
        bool const is_named = std::find(nodes.begin(), nodes.end(), device.location) != nodes.end();
        if (nodes.empty() ? describe_device(device).kind != DeviceKind::Other : is_named)
            chosen.push_back(device);
    }
    if (chosen.size() < std::max<std::size_t>(nodes.size(), 1))
        return fail(
            Fault::User,
            nodes.empty()
                ? "there is no tablet and no height sensor to record: see \"tractus devices\", "
                  "or record the simulated rig with --simulate SCRIPT"
                : "not every named node is there: see \"tractus devices\"");
    return chosen;
}

Result<void> record_devices(Arguments const& arguments)
{
    TRY(check_new(arguments.output));
    auto const devices = TRY(choose_devices(arguments.nodes));
    LiveRecordingOptions options { .seconds = arguments.seconds, .rig_text = {} };
    if (!arguments.rig.empty()) {
        auto const rig = TRY(load_rig(arguments.rig));
        options.rig_text = print_rig(rig);
    }
    // Under its final name from the first report on: a log is whole at any length.
    std::ofstream out(arguments.output, std::ios::binary);
    if (!out)
        return fail(
            Fault::User,
            fmt::format("cannot write {}: {}", arguments.output.string(), std::strerror(errno)));
    for (auto const& device : devices)
        print_error(fmt::format("recording {} at {}\n", device.name, device.location));
    if (!arguments.seconds)
        print_error("until Ctrl-C\n");
    std::signal(SIGINT, ask_to_stop);
    std::signal(SIGTERM, ask_to_stop);
    auto const counts = TRY(record_live(out, devices, options, stop_asked));
    return print_out(fmt::format("{}: {} reports{}\n", arguments.output.string(), counts.reports,
                                 counts.lost ? fmt::format(", {} lost", counts.lost) : ""));
}

Result<void> record_simulated(Arguments const& arguments)
{
    TRY(check_new(arguments.output));
    auto const text = TRY(read_file(arguments.script));
    auto const script = TRY(parse_gesture_script(text, arguments.script));
    auto const model = TRY(find_model(arguments.model));
    auto const edit = TRY(load_model_edit(model));
    auto const scene = TRY(apply_edit({}, edit));
    auto const write
        = [&](std::ostream& out) { return write_simulated_recording(out, script, scene); };
    TRY(write_file(arguments.output, write));
    return print_out(
        fmt::format("{}: {} gestures\n", arguments.output.string(), script.gestures.size()));
}

} // namespace

void add_record_verb(CLI::App& root, Action& action)
{
    auto arguments = std::make_shared<Arguments>();
    auto* const verb = root.add_subcommand(
        "record", "Record what a tablet and a height sensor send, real or simulated");
    verb->add_option("-o,--output", arguments->output,
                     "The new .tractus-log; a file that is there already is never written over")
        ->type_name("FILE")
        ->required();
    auto* const seconds
        = verb->add_option("--seconds", arguments->seconds, "How long; without it, until Ctrl-C")
              ->type_name("SECONDS")
              ->check(number(0.001, 1e6));
    auto* const device
        = verb->add_option("--device", arguments->nodes,
                           "The hidraw nodes to record, as \"tractus devices\" lists "
                           "them; without it, every pen and height sensor")
              ->type_name("NODE...");
    auto* const rig = verb->add_option("--rig", arguments->rig,
                                       "The rig's calibration, a .rig.toml, to stand in the log")
                          ->type_name("FILE");
    auto* const simulate
        = verb->add_option("--simulate", arguments->script,
                           "Let the simulated hand on the simulated rig do what this script says, "
                           "a .hand.toml")
              ->type_name("SCRIPT")
              ->excludes(seconds, device, rig);
    verb->add_option("--plant", arguments->model, "The model whose branches the script traces")
        ->type_name("MODEL")
        ->capture_default_str()
        ->needs(simulate);
    verb->footer(
        "Records until the time is over, Ctrl-C, or no device is left; what has come is in\n"
        "the file within a quarter of a second. \"tractus replay\" and \"tractus decode\" read\n"
        "it.");
    verb->callback([arguments, &action] {
        action = [arguments] {
            return arguments->script.empty() ? record_devices(*arguments)
                                             : record_simulated(*arguments);
        };
    });
}

} // namespace tractus
