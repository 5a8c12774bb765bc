#include "app/commands/record.h"

#include "app/commands/device_sources.h"
#include "app/devices/live_devices.h"
#include "app/devices/live_recorder.h"
#include "app/devices/live_recording.h"
#include "app/document/model_cost.h"
#include "app/files/resources.h"
#include "app/io/model_file.h"
#include "app/options/checks.h"
#include "app/play/simulated_recording.h"
#include "app/terminal/console.h"
#include "calib/rig_file.h"
#include "engine/base/file.h"

#include <filesystem>
#include <fmt/core.h>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tractus::commands {

namespace {

namespace fs = std::filesystem;

struct RecordArguments {
    fs::path output;
    std::optional<double> seconds;
    std::vector<std::string> devices;
    std::string rig;
    std::string script;
    std::string model = "broadleaf";
    bool is_unkind = false;
};

Result<void> record_devices(RecordArguments const& arguments)
{
    TRY(devices::check_new_file(arguments.output));
    auto const options = devices::live_recording_by_the_clock(arguments.seconds);
    auto const start = options.now();
    auto devices = TRY(open_devices(arguments.devices, "to record"));
    drivers::LogHeader header { .devices = devices.infos(),
                                .rig_text = devices.rig_text(),
                                .start = start };
    if (!arguments.rig.empty()) {
        auto const rig = TRY(calib::load_rig(arguments.rig));
        header.rig_text = calib::print_rig(rig);
    }
    auto recorder = TRY(devices::LiveRecorder::create(arguments.output, header));
    for (auto const& device : devices.infos())
        terminal::print_error(fmt::format("recording {} at {}\n", device.name, device.location));
    if (!arguments.seconds)
        terminal::print_error("until Ctrl-C\n");
    auto const counts = TRY(devices::record_live(devices, recorder, options, stop_on_signals()));
    return terminal::print_out(
        fmt::format("{}: {} reports{}\n", arguments.output.string(), counts.reports,
                    counts.lost ? fmt::format(", {} lost", counts.lost) : ""));
}

Result<void> record_simulated(RecordArguments const& arguments, tools::ToolKinds tools)
{
    TRY(devices::check_new_file(arguments.output));
    auto const text = TRY(read_text_file(arguments.script));
    auto script = TRY(sim::parse_gesture_script(text, arguments.script));
    if (arguments.is_unkind)
        script.unkindness = sim::all_unkindness(script.seed);
    auto const model = TRY(files::find_plant(arguments.model));
    scene::Scene scene;
    if (!model.empty()) {
        auto const edit = TRY(io::load_plant_edit(model));
        scene = TRY(scene::apply_edit({}, edit, document::make_load_options()));
    }
    auto const write = [&](std::ostream& out) {
        return play::write_simulated_recording(out, script, scene, tools);
    };
    TRY(write_file(arguments.output, write));
    return terminal::print_out(
        fmt::format("{}: {} gestures\n", arguments.output.string(), script.gestures.size()));
}

} // namespace

void add_record_command(CLI::App& root, options::Action& action, tools::ToolKinds tools)
{
    auto arguments = std::make_shared<RecordArguments>();
    auto* const command = root.add_subcommand(
        "record", "Record what a tablet and a height sensor send, real or simulated");
    command
        ->add_option("-o,--output", arguments->output,
                     "The new .tractus-log; a file that is there already is never written over")
        ->type_name("FILE")
        ->required();
    auto* const seconds
        = command->add_option("--seconds", arguments->seconds, "How long; without it, until Ctrl-C")
              ->type_name("SECONDS")
              ->check(options::number(0.001, 1e6));
    auto* const device
        = command
              ->add_option("--device", arguments->devices,
                           fmt::format("What to record, each {}; without it, every pen and height "
                                       "sensor that is found",
                                       devices::device_name_help()))
              ->type_name("DEVICE...");
    auto* const rig = command
                          ->add_option("--rig", arguments->rig,
                                       "The rig's calibration, a .rig.toml, to stand in the log")
                          ->type_name("FILE");
    auto* const simulate
        = command
              ->add_option("--simulate", arguments->script,
                           "Let the simulated hand on the simulated rig do what this script says, "
                           "a .hand.toml")
              ->type_name("SCRIPT")
              ->excludes(seconds, device, rig);
    command
        ->add_option("--plant", arguments->model,
                     "The model whose branches the script traces; empty: an empty sheet")
        ->type_name("MODEL")
        ->capture_default_str()
        ->needs(simulate);
    command
        ->add_flag("--unkind", arguments->is_unkind,
                   "Simulate what hands, devices and computers do at their worst: dabs, hooks, "
                   "tremor, lost and late reports, wrong heights, stalls; the script's own "
                   "[unkind] chooses among them")
        ->needs(simulate);
    command->footer(
        "Records until the time is over, Ctrl-C, or every log that is played is over; what\n"
        "has come is in the file within a quarter of a second, and a stroke when it ends. A\n"
        "device that is unplugged is waited for. \"tractus replay\", \"tractus decode\" and\n"
        "\"tractus convert\" read the file.");
    command->callback([arguments, tools, &action] {
        action = [arguments, tools] {
            return arguments->script.empty() ? record_devices(*arguments)
                                             : record_simulated(*arguments, tools);
        };
    });
}

} // namespace tractus::commands
