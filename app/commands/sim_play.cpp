#include "app/commands/sim_play.h"

#include "app/document/model_cost.h"
#include "app/files/resources.h"
#include "app/io/model_file.h"
#include "app/options/recordings_help.h"
#include "app/play/simulated_recording.h"
#include "app/terminal/console.h"
#include "drivers/logs/log_source.h"
#include "engine/base/file.h"

#include <atomic>
#include <csignal>
#include <fmt/core.h>
#include <memory>
#include <sstream>

namespace tractus::commands {

namespace {

std::atomic<bool> unplug_asked = false;

void ask_to_unplug(int)
{
    unplug_asked = true;
}

Result<drivers::Log> simulate(SimPlayArguments const& arguments)
{
    auto const text = TRY(read_text_file(arguments.script));
    auto script = TRY(sim::parse_gesture_script(text, arguments.script));
    if (arguments.is_unkind)
        script.unkindness = sim::all_unkindness(script.seed);
    auto const model = TRY(files::find_model(arguments.model));
    auto const edit = TRY(io::load_plant_edit(model));
    auto const scene = TRY(scene::apply_edit({}, edit, document::make_load_options()));
    std::ostringstream recording;
    TRY(play::write_simulated_recording(recording, script, scene, {}));
    return drivers::parse_log(recording.str(), arguments.script);
}

play::PlaybackSet::Then what_then(SimPlayArguments const& arguments)
{
    if (arguments.repeat)
        return play::PlaybackSet::Then::Repeat;
    return arguments.stay ? play::PlaybackSet::Then::Stay : play::PlaybackSet::Then::Leave;
}

} // namespace

void add_sim_play_options(CLI::App& command, SimPlayArguments& arguments)
{
    auto* const log = command.add_option(
        "LOG", arguments.log, fmt::format("The recording to play: {}", options::kRecordings));
    auto* const simulate
        = command
              .add_option("--simulate", arguments.script,
                          "Let the simulated hand do what this script says, a .hand.toml, as "
                          "\"tractus record --simulate\" does")
              ->type_name("SCRIPT")
              ->excludes(log);
    command.add_option("--plant", arguments.model, "The model whose branches the script traces")
        ->type_name("MODEL")
        ->capture_default_str()
        ->needs(simulate);
    command
        .add_flag("--unkind", arguments.is_unkind,
                  "Simulate hands, devices and computers at their worst, as \"tractus record "
                  "--unkind\" does")
        ->needs(simulate);
    auto* const stay = command.add_flag("--stay", arguments.stay,
                                        "Stay plugged in when everything was played, until Ctrl-C");
    command.add_flag("--repeat", arguments.repeat, "Play it again and again, until Ctrl-C")
        ->excludes(stay);
}

Result<drivers::Log> load_sim_play(SimPlayArguments const& arguments)
{
    if (arguments.log.empty() && arguments.script.empty())
        return fail(Fault::User,
                    "there is nothing to play: name a LOG, or a script with "
                    "--simulate SCRIPT");
    auto log = arguments.script.empty() ? TRY(drivers::read_log(arguments.log))
                                        : TRY(simulate(arguments));
    if (log.empty())
        return fail(Fault::User, fmt::format("there are no reports to play in {}", log.name));
    return log;
}

std::function<play::NextReport()> reports_of(drivers::Log const& log, std::size_t device,
                                             std::optional<double> rate_hz)
{
    return [&log, device, rate_hz]() -> play::NextReport {
        // std::function objects are copied; the copies share this source.
        auto const source = std::make_shared<drivers::LogSource>(log, device);
        return [&log, source, rate_hz,
                count = 0]() mutable -> Result<std::optional<drivers::RawReport>> {
            auto report = TRY(source->read(Duration(0)));
            if (report)
                report->received = rate_hz ? Timestamp(from_seconds(count++ / *rate_hz))
                                           : Timestamp(report->received - log.begin());
            return report;
        };
    };
}

Result<void> run_sim_play(play::PlaybackSet play, SimPlayArguments const& arguments)
{
    play.then = what_then(arguments);
    play.on_begin = [] { terminal::print_error("somebody reads: playing; Ctrl-C unplugs\n"); };
    terminal::print_error("plugged in, waiting for a program to read; Ctrl-C unplugs\n");
    std::signal(SIGINT, ask_to_unplug);
    std::signal(SIGTERM, ask_to_unplug);
    std::signal(SIGHUP, ask_to_unplug);
    TRY(play::play_parts(play, unplug_asked));
    std::uint64_t lost = 0;
    for (auto const* const device : play.devices)
        lost += device->lost_count();
    terminal::print_error(
        lost ? fmt::format("unplugged; {} reports came too fast, or while nobody read, and "
                           "were lost\n",
                           lost)
             : "unplugged; nothing was lost\n");
    return {};
}

} // namespace tractus::commands
