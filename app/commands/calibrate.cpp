#include "app/commands/calibrate.h"

#include "app/calibration/calibration_controller.h"
#include "app/calibration/live_calibration.h"
#include "app/calibration/log_calibration.h"
#include "app/calibration/save_calibration.h"
#include "app/calibration/simulated_calibration.h"
#include "app/commands/device_sources.h"
#include "app/controllers/calibration_window.h"
#include "app/devices/live_devices.h"
#include "app/devices/live_recorder.h"
#include "app/devices/live_recording.h"
#include "app/options/checks.h"
#include "app/play/paced_log.h"
#include "app/terminal/console.h"
#include "app/terminal/terminal_keys.h"
#include "app/window/window.h"
#include "calib/rig_file.h"
#include "drivers/logs/log.h"
#include "engine/base/file.h"

#include <filesystem>
#include <fmt/core.h>
#include <memory>
#include <sstream>

namespace tractus::commands {

namespace {

namespace fs = std::filesystem;

struct CalibrateArguments {
    calibration::CalibrationProcedure procedure = calibration::CalibrationProcedure::Height;
    std::string rig;
    std::string log;
    std::vector<std::string> devices;
    bool simulate = false;
    std::uint64_t seed = 1;
    std::string record;
    std::vector<double> heights_mm;
    std::string model;
    double ruler_error_mm = 0.3;
    double linearity_percent = 0;
    std::string zero_cause;
    bool is_forced = false;
    bool window = false;
    int frames = 0;
    std::string screenshot;
};

// Loads the rig to start from: from its file if that exists, otherwise from the log. If there is
// neither, only the height procedure starts with a new rig.
Result<calib::Rig> load_start(CalibrateArguments const& arguments, std::string const& log_rig)
{
    std::error_code error;
    if (fs::exists(arguments.rig, error))
        return calib::load_rig(arguments.rig);
    if (!log_rig.empty())
        return calib::parse_rig(log_rig, arguments.log);
    if (arguments.procedure == calibration::CalibrationProcedure::Height)
        return calib::Rig { .sample_times = calib::SampleTimes::Evened };
    // Without calibrated heights, a rig would draw at wrong heights, so no other procedure may
    // create a rig.
    bool const needs_heights = calibration::needs_height(arguments.procedure);
    return fail(
        Fault::User,
        fmt::format("{} is not there, and calibrate {} {}: use \"tractus calibrate height "
                    "--rig {}\" first",
                    arguments.rig, calibration::name_of(arguments.procedure),
                    needs_heights ? "needs the heights in it" : "only adds to a rig that is there",
                    arguments.rig));
}

calibration::CalibrationController::Options desk_options(CalibrateArguments const& arguments,
                                                         calib::Rig rig)
{
    calibration::CalibrationController::Options options { .procedure = arguments.procedure,
                                                          .rig = std::move(rig) };
    options.height.ruler_error_mm = arguments.ruler_error_mm;
    options.height.linearity_percent = arguments.linearity_percent;
    options.zero_cause = calib::parse_zero_cause(arguments.zero_cause);
    options.is_forced = arguments.is_forced;
    if (!arguments.model.empty())
        options.height.kind = calib::parse_height_model_kind(arguments.model);
    return options;
}

Result<calibration::CalibrationOutcome> from_log(CalibrateArguments const& arguments)
{
    auto const log = TRY(drivers::read_log(arguments.log));
    auto rig = TRY(load_start(arguments, log.rig_text));
    return calibration::calibrate_from_log(log, desk_options(arguments, std::move(rig)),
                                           calibration::today());
}

Result<drivers::Log> simulated_log(CalibrateArguments const& arguments)
{
    calibration::SimulatedCalibration simulated { .procedure = arguments.procedure,
                                                  .heights_mm = arguments.heights_mm,
                                                  .geometry = calibration::simulated_geometry(
                                                      arguments.procedure) };
    simulated.person.seed = arguments.seed;
    std::ostringstream text;
    TRY(calibration::write_simulated_calibration(text, simulated));
    if (!arguments.record.empty())
        TRY(write_file(arguments.record, text.str()));
    return drivers::parse_log(text.str(), "simulated");
}

Result<calibration::CalibrationOutcome> from_simulation(CalibrateArguments const& arguments)
{
    auto rig = TRY(load_start(arguments, {}));
    auto const log = TRY(simulated_log(arguments));
    return calibration::calibrate_from_log(log, desk_options(arguments, std::move(rig)),
                                           calibration::today());
}

calibration::CalibrationPerson person_at(terminal::TerminalKeys& keys)
{
    bool const has_screen = keys.is_terminal();
    return {
        .key = [&keys] { return keys.read(); },
        .say =
            [has_screen](std::string const& line) {
                terminal::print_error((has_screen ? "\r\x1b[K" : "") + line + "\n");
            },
        .show =
            [has_screen](std::string const& line) {
                if (has_screen)
                    terminal::print_error("\r\x1b[K" + line);
            },
        .is_script = !has_screen,
    };
}

// Calibrates with live devices. Returns no value if the user quit.
Result<std::optional<calibration::CalibrationOutcome>>
from_devices(CalibrateArguments const& arguments)
{
    auto rig = TRY(load_start(arguments, {}));
    auto devices = TRY(open_devices(arguments.devices, "to calibrate"));
    auto const clock = devices::live_recording_by_the_clock({});
    calibration::LiveCalibrationOptions options { .heights_mm = arguments.heights_mm,
                                                  .is_forced = arguments.is_forced,
                                                  .start = clock.now(),
                                                  .now = clock.now,
                                                  .rest = clock.rest };
    std::unique_ptr<devices::LiveRecorder> recorder;
    if (!arguments.record.empty()) {
        std::error_code error;
        drivers::LogHeader const header { .devices = devices.infos(),
                                          .rig_text = fs::exists(arguments.rig, error)
                                              ? calib::print_rig(rig)
                                              : "",
                                          .start = options.start };
        recorder = std::make_unique<devices::LiveRecorder>(
            TRY(devices::LiveRecorder::create(arguments.record, header)));
        options.recorder = recorder.get();
    }
    auto controller = TRY(calibration::CalibrationController::create(
        devices.infos(), desk_options(arguments, std::move(rig))));
    bool is_done = false;
    {
        terminal::TerminalKeys keys;
        is_done = TRY(calibration::calibrate_live(controller, devices, person_at(keys), options,
                                                  stop_on_signals()));
        if (keys.is_terminal())
            terminal::print_error("\n");
    }
    if (!is_done)
        return std::optional<calibration::CalibrationOutcome>();
    return std::optional<calibration::CalibrationOutcome>(
        TRY(controller.finish(calibration::today())));
}

Result<void> keep(CalibrateArguments const& arguments,
                  calibration::CalibrationOutcome const& outcome)
{
    return terminal::print_out(outcome.report
                               + TRY(calibration::save_calibration(outcome, arguments.rig)));
}

// Opens real devices, or a log that is played at its original pace.
Result<devices::LiveDevices> open_for_window(CalibrateArguments const& arguments)
{
    if (!arguments.log.empty())
        return open_devices({ arguments.log }, "to calibrate");
    if (!arguments.simulate)
        return open_devices(arguments.devices, "to calibrate");
    // The log is shared by the sources of all its devices.
    auto const log = std::make_shared<drivers::Log const>(TRY(simulated_log(arguments)));
    auto const pace = play::pace_from_now(Timestamp {});
    std::vector<std::unique_ptr<drivers::ReportSource>> sources;
    for (std::size_t i = 0; i < log->devices.size(); ++i)
        sources.push_back(play::open_paced(log, i, pace));
    return devices::LiveDevices::start(std::move(sources));
}

Result<void> calibrate_in_window(CalibrateArguments const& arguments)
{
    auto rig = TRY(load_start(arguments, {}));
    auto devices = TRY(open_for_window(arguments));
    auto window = TRY(controllers::CalibrationWindow::create(
        std::move(devices),
        { .controller = desk_options(arguments, std::move(rig)),
          .heights_mm = arguments.heights_mm,
          .date = calibration::today(),
          .now = devices::live_recording_by_the_clock({}).now,
          .keep = [&](calibration::CalibrationOutcome const& outcome) {
              return calibration::save_calibration(outcome, arguments.rig);
          } }));
    return window::run_window(window,
                              { .title = fmt::format("tractus: calibrating {}", arguments.rig),
                                .frames = arguments.frames,
                                .screenshot = arguments.screenshot });
}

Result<void> calibrate(CalibrateArguments const& arguments)
{
    TRY(check_writable(arguments.rig));
    if (!arguments.record.empty())
        TRY(devices::check_new_file(arguments.record));
    if (!arguments.screenshot.empty())
        TRY(check_writable(arguments.screenshot));
    if (arguments.window)
        return calibrate_in_window(arguments);
    if (!arguments.log.empty())
        return keep(arguments, TRY(from_log(arguments)));
    if (arguments.simulate)
        return keep(arguments, TRY(from_simulation(arguments)));
    auto const outcome = TRY(from_devices(arguments));
    if (!outcome)
        return fail(Fault::User, fmt::format("stopped; {} is as it was", arguments.rig));
    return keep(arguments, *outcome);
}

void add_source_options(CLI::App& command, CalibrateArguments& arguments)
{
    auto* const log
        = command.add_option("LOG", arguments.log,
                             "A recording of this calibration: it is done again; without "
                             "it, live devices are calibrated");
    auto* const device
        = command
              .add_option(
                  "--device", arguments.devices,
                  fmt::format("What to calibrate, each {}; without it, every pen and height "
                              "sensor that is found",
                              devices::device_name_help()))
              ->type_name("DEVICE...")
              ->excludes(log);
    auto* const simulate = command
                               .add_flag("--simulate", arguments.simulate,
                                         "Let a simulated person calibrate the simulated rig")
                               ->excludes(log, device);
    command.add_option("--seed", arguments.seed, "Of the simulated person's hand and the noise")
        ->type_name("N")
        ->check(options::seed_number())
        ->capture_default_str()
        ->needs(simulate);
    command
        .add_option("--record", arguments.record,
                    "Record the calibration in this new .tractus-log, which gives the same rig "
                    "again")
        ->type_name("FILE")
        ->excludes(log);
}

void add_window_options(CLI::App& command, CalibrateArguments& arguments)
{
    auto* const window = command.add_flag(
        "--window", arguments.window, "In a window, with plots; a LOG is played at its pace there");
    command
        .add_option("--frames", arguments.frames,
                    "Close the window after so many frames; 0 stays open")
        ->type_name("N")
        ->check(options::whole_number(0, 1'000'000'000))
        ->capture_default_str()
        ->needs(window);
    command
        .add_option("--screenshot", arguments.screenshot, "Write the window's last frame as a PNG")
        ->type_name("FILE.png")
        ->check(options::picture_name())
        ->needs(window);
}

// Adds the subcommand of one procedure.
CLI::App* add_procedure(CLI::App& parent, calibration::CalibrationProcedure procedure,
                        std::string const& text, options::Action& action)
{
    auto arguments = std::make_shared<CalibrateArguments>();
    arguments->procedure = procedure;
    auto* const command = parent.add_subcommand(std::string(calibration::name_of(procedure)), text);
    command
        ->add_option("--rig", arguments->rig,
                     "The rig's file, a .rig.toml; what was there is kept as .bak")
        ->type_name("FILE")
        ->required()
        ->check(options::name_ending_in({ ".toml" }));
    add_source_options(*command, *arguments);
    add_window_options(*command, *arguments);
    if (calibration::takes_captures(procedure))
        command
            ->add_option("--heights", arguments->heights_mm,
                         "The heights to capture, in their order; without it, they are typed")
            ->type_name("MM,MM,...")
            ->delimiter(',');
    if (procedure == calibration::CalibrationProcedure::Height) {
        command
            ->add_option("--model", arguments->model,
                         "linear, string or monotone; without it, the simplest that the captures "
                         "support")
            ->type_name("MODEL")
            ->check(options::one_of({ "linear", "string", "monotone" }));
        command
            ->add_option("--ruler-error", arguments->ruler_error_mm,
                         "How exactly the ruler is read: the standard deviation of a height")
            ->type_name("MM")
            ->check(options::number(0.01, 10))
            ->capture_default_str();
        command
            ->add_option("--linearity", arguments->linearity_percent,
                         "How straight the potentiometer is by its data sheet, in percent of its "
                         "track; without it, the track is taken to be straight")
            ->type_name("PERCENT")
            ->check(options::number(0, 5));
        command->add_flag("--force", arguments->is_forced,
                          "Keep a fit whose captures disagree, or span less than 100 mm");
    }
    if (procedure == calibration::CalibrationProcedure::Zero)
        command
            ->add_option("--cause", arguments->zero_cause,
                         "Why heights are off: the string slipped, or the table, the spool's stand "
                         "or the ruler moved; without it, what captures at two heights tell, else "
                         "slipped")
            ->type_name("CAUSE")
            ->check(options::one_of({ "slipped", "moved" }));
    command->callback(
        [arguments, &action] { action = [arguments] { return calibrate(*arguments); }; });
    return command;
}

} // namespace

void add_calibrate_command(CLI::App& root, options::Action& action)
{
    auto* const command
        = root.add_subcommand("calibrate", "Find out what a rig's sensors mean, and how exactly");
    command->require_subcommand(1);
    add_procedure(*command, calibration::CalibrationProcedure::Height,
                  "What the height sensor's readings mean: set the surface to known heights",
                  action)
        ->footer("Five heights or more are advised, up and down, closer together where the string\n"
                 "runs aslant: 0, 60, 200, 400, 300, 120, 20. Enter captures, u takes back, f\n"
                 "fits, q quits; a pen that rests on the tablet captures the next of --heights.");
    add_procedure(
        *command, calibration::CalibrationProcedure::Travel,
        "How the surface moves aside while it rises: hold the pen against an upright edge", action)
        ->footer(
            "Stand a straight edge upright on the controller, hold the pen against it and on the\n"
            "tablet, and move the surface up and down. Enter begins and ends.");
    add_procedure(*command, calibration::CalibrationProcedure::Latency,
                  "How much later the pen arrives than the height: follow an inclined edge", action)
        ->footer("Fix a straight edge at some 45 degrees over the tablet, let the pen follow it\n"
                 "while the surface moves up and down several times. Enter begins and ends.");
    add_procedure(*command, calibration::CalibrationProcedure::Tilt,
                  "How far beside its nib the tablet sees a pen that leans: lean it around", action)
        ->footer(
            "Set the nib in a small dent that does not move on the tablet, of a paper glued to\n"
            "it say, and lean the pen slowly all around, as far as it goes, for 20 seconds.\n"
            "Enter begins and ends. A tablet that corrects for it itself is left alone.");
    add_procedure(*command, calibration::CalibrationProcedure::Zero,
                  "Where height zero is, from one capture; the scale stays", action)
        ->footer(
            "Set the surface to a known height, 0 say, let it rest, type it and press Enter. A\n"
            "second height, far from the first, tells a slipped string from a moved table.");
    add_procedure(*command, calibration::CalibrationProcedure::Check,
                  "How exact the rig is, at heights that were not used to calibrate it", action)
        ->footer("Says what a person would: within 0.6 mm over 60–380 mm. The rig's numbers stay.");
    for (auto* const procedure : command->get_subcommands({}))
        procedure->set_help_flag("-h,--help", "Print this help");
}

} // namespace tractus::commands
