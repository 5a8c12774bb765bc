#include "app/commands/stream.h"

#include "app/commands/device_sources.h"
#include "app/files/user_folder.h"
#include "app/options/checks.h"
#include "app/options/shared_options.h"
#include "app/stream/stream_drawing.h"
#include "app/terminal/console.h"
#include "app/terminal/error_text.h"
#include "calib/rig_file.h"
#include "drivers/height_decoders.h"
#include "drivers/logs/log.h"
#include "drivers/tablets/pen_decoders.h"

#include <algorithm>
#include <filesystem>
#include <fmt/core.h>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tractus::commands {

namespace {

struct StreamArguments {
    std::string log; // Path of the log to stream; empty: live devices are read.
    std::vector<std::string> devices;
    std::string socket; // Path of the socket to write to; empty: standard output.
    std::string rig;
    std::string height;
    std::optional<double> speed;
    std::optional<double> seconds;
    bool strokes_only = false;
    tools::Methods methods;
};

Result<stream::StreamOutput> open_stream_output(StreamArguments const& arguments,
                                                Bounds const& volume_mm)
{
    auto const what = arguments.strokes_only ? stream::StreamOutput::What::Strokes
                                             : stream::StreamOutput::What::All;
    if (arguments.socket.empty())
        return stream::StreamOutput::open(terminal::print_out, volume_mm, what);
    auto output = TRY(stream::StreamOutput::open_socket(arguments.socket, volume_mm, what));
    terminal::print_error(fmt::format("streaming at {}\n", arguments.socket));
    return output;
}

// Warns if the station received reports that could not be decoded.
void warn_of_losses(station::Station const& station)
{
    auto const& counts = station.counts();
    if (counts.broken_reports > 0)
        terminal::print_warning(fmt::format("{} reports could not be decoded, the first: {}",
                                            counts.broken_reports, counts.first_broken));
    for (auto const& sentence : calib::describe_faults(station.height_monitor(), {}))
        terminal::print_warning(sentence);
}

Result<void> stream_recording(StreamArguments const& arguments)
{
    auto const log = TRY(drivers::read_log(arguments.log));
    if (auto const warnings = drivers::summarize_warnings(log); !warnings.empty())
        terminal::print_warning(warnings);
    station::ReplayOptions options { .methods = arguments.methods };
    if (!arguments.rig.empty())
        options.rig = TRY(calib::load_rig(arguments.rig));
    if (!arguments.height.empty())
        options.height = TRY(calib::parse_height_scenario(arguments.height));
    auto replay = TRY(station::LogReplay::create(log, options));
    for (auto const& sentence : replay.left_out())
        terminal::print_warning(sentence);
    // Installed before the socket is created, so that a signal during streaming still removes it.
    auto const& stop = stop_on_signals();
    auto output = TRY(open_stream_output(arguments, replay.station().volume_mm()));
    TRY(stream::stream_log(replay, output, arguments.speed, stop));
    warn_of_losses(replay.station());
    return {};
}

bool has_sensor_of_height(devices::LiveDevices const& devices)
{
    auto const& infos = devices.infos();
    return std::any_of(infos.begin(), infos.end(), [](auto const& info) {
        return drivers::make_height_decoder(info).has_value();
    });
}

// Returns the rig that the arguments name, otherwise that of the played log, otherwise the user's
// own.
Result<std::optional<calib::Rig>> find_stream_rig(StreamArguments const& arguments,
                                                  devices::LiveDevices const& devices)
{
    if (!arguments.rig.empty())
        return TRY(calib::load_rig(arguments.rig));
    if (!devices.rig_text().empty())
        return TRY(calib::parse_rig(devices.rig_text(), "the log's rig"));
    std::error_code ignored;
    if (auto const own = files::user_rig_path(); std::filesystem::exists(own, ignored))
        return TRY(calib::load_rig(own));
    return std::optional<calib::Rig>();
}

// Returns a rig that only knows the size of the first tablet, for use if there is no calibrated
// rig.
calib::Rig rig_of_first_tablet(devices::LiveDevices const& devices)
{
    calib::Rig rig;
    for (auto const& info : devices.infos())
        if (auto const decoder = drivers::make_pen_decoder(info)) {
            rig.tablet_size_mm = (*decoder)->traits().size_mm;
            break;
        }
    return rig;
}

Result<station::StationOptions> live_station_options(StreamArguments const& arguments,
                                                     devices::LiveDevices const& devices)
{
    auto const rig = TRY(find_stream_rig(arguments, devices));
    bool const has_sensor = has_sensor_of_height(devices);
    if (!rig && has_sensor && arguments.height.empty())
        return fail(Fault::User,
                    "there is a height sensor but no calibration of it: give one with --rig, or "
                    "the surface's height with --height");
    station::StationOptions options;
    options.rig = rig ? *rig : rig_of_first_tablet(devices);
    options.tools = arguments.methods.tools;
    if (has_sensor && arguments.height.empty())
        return options;
    calib::HeightScenario scenario;
    if (!arguments.height.empty())
        scenario.constant_mm = TRY(options::constant_height_mm(arguments.height));
    else
        terminal::print_warning("there is no height sensor: all is drawn at height 0");
    options.scripted_height
        = calib::ScriptedHeight { .scenario = scenario, .first_pen = {}, .last_pen = {} };
    return options;
}

Result<void> stream_devices(StreamArguments const& arguments)
{
    auto devices = TRY(open_devices(arguments.devices, "to draw with"));
    auto const options = TRY(live_station_options(arguments, devices));
    auto station = TRY(station::Station::create(devices.infos(), options));
    auto const& stop = stop_on_signals();
    auto output = TRY(open_stream_output(arguments, station.volume_mm()));
    TRY(stream::stream_live(devices, station, output,
                            devices::live_recording_by_the_clock(arguments.seconds), stop));
    warn_of_losses(station);
    if (auto const lost = devices.lost_count(); lost > 0)
        terminal::print_warning(
            fmt::format("{} reports were lost, since the lines were not taken in time: "
                        "give --socket, which waits for nobody",
                        lost));
    return {};
}

void add_stream_options(CLI::App& command, StreamArguments& arguments)
{
    auto* const log = command.add_option("LOG", arguments.log,
                                         "A recording; without it, what is drawn now is streamed");
    command
        .add_option("--device", arguments.devices,
                    fmt::format("What to read, each {}; without it, every pen and height sensor "
                                "that is found",
                                devices::device_name_help()))
        ->type_name("DEVICE...")
        ->excludes(log);
    command
        .add_option("--socket", arguments.socket,
                    "Stream at a local socket of this name, to any number of readers, in place of "
                    "standard output")
        ->type_name("PATH");
    command.add_flag("--strokes", arguments.strokes_only, "Finished strokes alone, no tips");
    options::add_rig_option(command, arguments.rig);
    options::add_height_option(command, arguments.height);
    command
        .add_option("--speed", arguments.speed,
                    "Stream a log at the pace of the hand, 1, or so many times as fast; without "
                    "it, as fast as it can be read")
        ->type_name("X")
        ->check(options::number(0.01, 1000))
        ->needs(log);
    command.add_option("--seconds", arguments.seconds, "How long; without it, until Ctrl-C")
        ->type_name("SECONDS")
        ->check(options::number(0.001, 1e6))
        ->excludes(log);
}

} // namespace

void add_stream_command(CLI::App& root, options::Action& action, tools::Methods const& methods)
{
    auto arguments = std::make_shared<StreamArguments>();
    arguments->methods = methods;
    auto* const command = root.add_subcommand(
        "stream", "Give the pen in space to other programs: tips and strokes as JSON lines");
    add_stream_options(*command, *arguments);
    command->footer(
        "One JSON object a line: \"stream\" at first, which has the version, then \"tip\" for "
        "each\n"
        "sample of the pen, \"stroke\" for each stroke that is finished, and \"end\". Lengths are\n"
        "millimetres, z up. The manual's page \"Streaming\" has all members, and a script for\n"
        "Blender. Standard output waits for its reader, and a socket never does: for one that\n"
        "is too slow tips are left out. A log begins when the socket has a reader.");
    command->callback([arguments, &action] {
        action = [arguments] {
            return arguments->log.empty() ? stream_devices(*arguments)
                                          : stream_recording(*arguments);
        };
    });
}

} // namespace tractus::commands
