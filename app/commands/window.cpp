#include "app/commands/window.h"

#include "app/batch/malloc_tuning.h"
#include "app/batch/session_plant.h"
#include "app/commands/device_sources.h"
#include "app/commands/window_look.h"
#include "app/controllers/drawing_file.h"
#include "app/controllers/live_window.h"
#include "app/controllers/picture_files.h"
#include "app/controllers/replay_window.h"
#include "app/controllers/start_page_controller.h"
#include "app/controllers/unnamed_session.h"
#include "app/devices/live_devices.h"
#include "app/files/resources.h"
#include "app/files/user_folder.h"
#include "app/options/checks.h"
#include "app/options/shared_options.h"
#include "app/station/log_replay.h"
#include "app/terminal/console.h"
#include "app/terminal/error_text.h"
#include "app/window/window.h"
#include "app/window/workspace.h"
#include "calib/rig_file.h"
#include "drivers/links/closing_signals.h"
#include "drivers/logs/log.h"
#include "drivers/reports/clock.h"
#include "engine/base/file.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tractus::commands {

namespace {

constexpr auto kUsualModel = "broadleaf";

struct WindowArguments {
    tools::Methods methods;
    // A log, a session or a plant's file; sort_out() moves it to the field for its kind.
    std::string file;
    std::string log;
    std::vector<std::string> devices;
    std::string played; // Log whose devices are treated like connected ones.
    std::string recording;
    // Minimum extents of strokes as texts TOOL=MM; see tools/min_extent.h.
    std::vector<std::string> least;
    std::string session;
    // Model to draw on. Empty: the start page opens, or kUsualModel without a start page.
    std::string model;
    bool wants_start_page = false; // True: opens the start page, regardless of the other arguments.
    bool begins_tour = false;      // True: opens an empty sheet with the tour.
    std::string rig;
    std::string height;
    std::string picture; // Picture file to lay behind the drawing.
    std::string socket;  // Path of a socket on which other programs receive strokes; empty: none.
    bool fills_display = false;
    std::string display; // Name of the display to fill; empty: none is named, see `fills_display`.
    std::string view;    // Initial view, one of window::shown_words(); empty: not given.
    bool is_on_stage = false;
    // True: light colours; false: dark ones; no value: the user's last choice.
    std::optional<bool> is_light {};
    // Layout for left-handed use; no value: the user's last choice.
    std::optional<bool> is_left_handed {};
    double scale = 0;
    int frames = 0;
    std::string screenshot;
    std::string film;
    int film_rate = window::WindowOptions().film_rate;
};

std::string window_title(std::string const& hand, std::string const& drawing)
{
    return fmt::format("tractus: {} on {}", hand, drawing);
}

// Returns the path of the model to draw on, by default that of kUsualModel.
Result<std::filesystem::path> model_of(WindowArguments const& arguments)
{
    char const* const usual = arguments.begins_tour ? "empty" : kUsualModel;
    return files::find_plant(arguments.model.empty() ? usual : arguments.model);
}

// True if the user's window settings apply. They do not apply to screenshots, films and runs of a
// fixed number of frames, which must look the same for every user.
bool keeps_look(WindowArguments const& arguments)
{
    return arguments.frames == 0 && arguments.film.empty() && arguments.screenshot.empty()
        && !user_look_path().empty();
}

// Returns the window settings from the arguments; those not given are as the user chose them last.
window::WindowLook look_for(WindowArguments const& arguments)
{
    window::WindowLook look;
    if (keeps_look(arguments)) {
        if (auto const kept = load_look(user_look_path()))
            look = *kept;
        else
            terminal::print_warning(
                fmt::format("{}: the window looks as usual", kept.error().message));
    }
    look.is_light = arguments.is_light.value_or(look.is_light);
    look.is_left_handed = arguments.is_left_handed.value_or(look.is_left_handed);
    return look;
}

window::WindowOptions window_options(WindowArguments const& arguments, std::string title)
{
    window::WindowOptions options;
    options.title = std::move(title);
    if (arguments.fills_display || !arguments.display.empty())
        options.full_screen = arguments.display;
    options.view = arguments.view;
    options.is_on_stage = arguments.is_on_stage;
    options.look = look_for(arguments);
    if (keeps_look(arguments))
        options.keep_look = [warned = false](window::WindowLook const& look) mutable {
            auto const saved = save_look(user_look_path(), look);
            if (!saved && !std::exchange(warned, true))
                terminal::print_warning(saved.error().message);
        };
    options.scale = arguments.scale;
    options.frames = arguments.frames;
    options.when_at_rest = batch::return_freed_memory;
    options.should_close = drivers::ClosingSignals::has_signal_arrived;
    options.screenshot = arguments.screenshot;
    options.film = arguments.film;
    options.film_rate = arguments.film_rate;
    return options;
}

Result<void> show_replay(WindowArguments const& arguments)
{
    auto const model = TRY(model_of(arguments));
    station::ReplayOptions options { .methods = arguments.methods };
    auto scene = TRY(controllers::scene_of_plant(model, arguments.methods.edits));
    if (!arguments.rig.empty())
        options.rig = TRY(calib::load_rig(arguments.rig));
    if (!arguments.height.empty())
        options.height = TRY(calib::parse_height_scenario(arguments.height));
    auto const log = TRY(drivers::read_log(arguments.log));
    std::optional<session::Session> session;
    if (!arguments.session.empty()) {
        std::string trouble;
        session = TRY(controllers::open_or_begin({ model, arguments.session },
                                                 arguments.methods.edits, trouble));
        if (!trouble.empty())
            terminal::print_warning(trouble);
    }
    // Termination signals do not end the program before the window is closed and everything is
    // saved.
    drivers::ClosingSignals const signals;
    auto window = TRY(controllers::ReplayWindow::create(
        log, options, std::move(scene), std::filesystem::current_path(), std::move(session)));
    auto const name = std::filesystem::path(log.name).filename().string();
    auto const on = arguments.session.empty() ? model : std::filesystem::path(arguments.session);
    auto const title = window_title(name, on.empty() ? "an empty sheet" : on.stem().string());
    return window::run_window(window, window_options(arguments, title));
}

// True if the simulated hand is the only device, so that the user just watches.
bool plays_hand(WindowArguments const& arguments)
{
    return arguments.devices == std::vector<std::string> { "simulated" };
}

// True if the window begins with the start page: it is requested, or the arguments name nothing to
// open, record or save as a picture, and no fixed number of frames.
bool begins_with_start_page(WindowArguments const& arguments)
{
    if (arguments.wants_start_page)
        return true;
    if (arguments.begins_tour)
        return false;
    return arguments.model.empty() && arguments.session.empty() && arguments.played.empty()
        && arguments.picture.empty() && arguments.recording.empty() && arguments.frames == 0
        && arguments.screenshot.empty();
}

// Opens the requested drawing with its session, by default a new session, and prints where it is
// saved. Returns the drawing's name, or an empty text if the start page opens.
Result<std::string> open_first_drawing(WindowArguments const& arguments,
                                       controllers::LiveWindowOptions& options)
{
    auto start = std::make_unique<controllers::StartPageController>(
        controllers::start_page_of_user(arguments.methods));
    options.start_page = std::move(start);
    options.unnamed = std::make_shared<std::filesystem::path>();
    if (begins_with_start_page(arguments)) {
        options.start_page->open({});
        return std::string();
    }
    auto const model = TRY(model_of(arguments));
    auto drawing
        = TRY(controllers::open_drawing({ model, arguments.session }, arguments.methods.edits));
    options.scene = std::move(drawing.scene);
    options.session = std::move(drawing.session);
    options.model = drawing.model;
    *options.unnamed = drawing.unnamed;
    if (!drawing.trouble.empty())
        terminal::print_warning(drawing.trouble);
    if (!drawing.unnamed.empty())
        TRY(terminal::print_out(
            fmt::format("What is drawn is kept in {}\n", drawing.unnamed.string())));
    return drawing.name;
}

// Shows the window for live devices until the user closes it.
Result<void> draw_in_window(devices::LiveDevices devices, controllers::LiveWindowOptions options,
                            window::WindowOptions const& how)
{
    // Termination signals do not end the program before the window is closed and everything is
    // saved.
    drivers::ClosingSignals const signals;
    auto window = TRY(controllers::LiveWindow::create(std::move(devices), std::move(options)));
    return window::run_window(window, how);
}

struct Clock {
    std::function<Timestamp()> now;
    // Current time if it advances with frames; null if the real clock is used.
    std::shared_ptr<Timestamp> counted {};
};

Clock clock_for(WindowArguments const& arguments)
{
    bool const plays = !arguments.played.empty() || plays_hand(arguments) || arguments.begins_tour;
    if (!plays || arguments.frames == 0)
        return { drivers::monotonic_now };
    auto const counted = std::make_shared<Timestamp>();
    return { [counted] { return *counted; }, counted };
}

// Returns the minimum extents of strokes from the command line; tools not given there have those of
// the user's settings.
Result<tools::MinExtents> read_min_extents(WindowArguments const& arguments)
{
    auto extents
        = TRY(tools::parse_min_extents(fmt::format("{}", fmt::join(arguments.least, " "))));
    if (keeps_look(arguments))
        extents.merge(TRY(load_min_extents(user_look_path())));
    for (auto const& [tool, mm] : extents)
        if (!tools::find_tool_kind(arguments.methods.tools, tool))
            return fail(Fault::User,
                        fmt::format("a least extent {}={:g}, but there is no tool {}: \"tractus "
                                    "tools\" lists those that there are",
                                    tool, mm, tool));
    return extents;
}

Result<void> show_devices(WindowArguments const& arguments, devices::LiveDevices devices,
                          Clock const& clock)
{
    controllers::LiveWindowOptions options { .methods = arguments.methods };
    options.rig_file
        = arguments.rig.empty() ? files::user_rig_path() : std::filesystem::path(arguments.rig);
    std::error_code ignored;
    if (!arguments.rig.empty()
        || (arguments.played.empty() && devices.rig_text().empty()
            && std::filesystem::exists(options.rig_file, ignored)))
        options.rig = TRY(calib::load_rig(options.rig_file));
    if (!arguments.height.empty())
        options.height_mm = TRY(options::constant_height_mm(arguments.height));
    options.min_extents = TRY(read_min_extents(arguments));
    // Opening a drawing may create a file, so it comes after everything else that can fail.
    auto const drawing = TRY(open_first_drawing(arguments, options));
    options.folder = std::filesystem::current_path();
    if (auto const folder = files::user_folder(); !folder.empty()) {
        options.cards = folder / "cards";
        options.leaves = folder / "leaves";
    }
    options.picture_folders = files::user_picture_folders();
    options.cache = files::user_cache_folder();
    options.picture = arguments.picture;
    options.recording = arguments.recording;
    options.socket = arguments.socket;
    options.begins_tour = arguments.begins_tour;
    options.now = clock.now;
    options.counted_time = clock.counted;
    if (!clock.counted || arguments.begins_tour)
        // The mouse replaces missing devices, except where a recording is played by counted frames.
        options.mouse.emplace(options.now);
    auto const name = devices.infos().empty() ? "mouse" : devices.infos().front().name;
    auto how = window_options(arguments, drawing.empty() ? "tractus" : window_title(name, drawing));
    auto const tidy_up = [unnamed = options.unnamed] {
        if (!unnamed->empty())
            controllers::remove_if_nothing_was_drawn(*unnamed);
    };
    how.when_display_has_gone = tidy_up;
    auto const done = draw_in_window(std::move(devices), std::move(options), how);
    tidy_up();
    return done;
}

// Moves the file argument to the field for its kind: a session is continued, a plant is drawn on,
// and any other file is a recording to replay.
Result<WindowArguments> sort_out(WindowArguments arguments)
{
    if (batch::is_session_file(arguments.file)) {
        std::error_code ignored;
        if (!std::filesystem::exists(arguments.file, ignored))
            return fail(
                Fault::User,
                fmt::format("there is no session {}: --session begins one", arguments.file));
        if (!arguments.session.empty())
            return fail(Fault::User,
                        fmt::format("{} and --session are two sessions: give one", arguments.file));
        arguments.session = arguments.file;
        return arguments;
    }
    constexpr std::array<std::string_view, 6> kPlants {
        ".l", ".obj", ".glb", ".mtg", ".ply", ".csv"
    };
    auto const ending = std::filesystem::path(arguments.file).extension().string();
    if (std::find(kPlants.begin(), kPlants.end(), ending) != kPlants.end()) {
        if (!arguments.model.empty())
            return fail(Fault::User,
                        fmt::format("{} and --plant are two plants: give one", arguments.file));
        arguments.model = arguments.file;
        return arguments;
    }
    bool const has_drawing = !arguments.model.empty() || !arguments.session.empty()
        || !arguments.file.empty() || arguments.wants_start_page;
    if (plays_hand(arguments) && !has_drawing)
        arguments.model = devices::LiveDevices::hand_plant();
    arguments.log = arguments.file;
    if (!arguments.log.empty()
        && !(arguments.devices.empty() && arguments.played.empty() && arguments.recording.empty()
             && arguments.socket.empty()))
        return fail(Fault::User,
                    fmt::format("{} is replayed: --device, --log, --record and --socket are for "
                                "drawing",
                                arguments.log));
    return arguments;
}

// Checks that a film has an end, and creates a new folder for it. In an existing folder, numbered
// pictures of a longer film could be left over and be taken for this film's end.
Result<void> prepare_film(WindowArguments const& arguments)
{
    if (arguments.log.empty() && arguments.frames == 0)
        return fail(Fault::User,
                    "a film has an end: give the recording to replay, or --frames with how many "
                    "frames it lasts");
    TRY(make_folder(arguments.film));
    std::error_code error;
    bool const is_empty = std::filesystem::is_empty(arguments.film, error);
    if (error || !is_empty)
        return fail(
            Fault::User,
            fmt::format("{} holds files already: a film begins an empty folder", arguments.film));
    return check_writable(std::filesystem::path(arguments.film) / "00001.png");
}

// Opens the requested recording or drawing with the requested or connected devices; without devices
// the mouse draws.
Result<void> open_window(WindowArguments const& arguments)
{
    batch::keep_freed_memory();
    // Checked before the window opens, so that an error appears in the terminal.
    if (!arguments.picture.empty())
        TRY(controllers::load_back_picture(arguments.picture, Vec2(1, 1)));
    if (!arguments.screenshot.empty())
        TRY(check_writable(arguments.screenshot));
    if (!arguments.film.empty())
        TRY(prepare_film(arguments));
    if (!arguments.log.empty())
        return show_replay(arguments);
    auto const clock = clock_for(arguments);
    if (!arguments.played.empty())
        return show_devices(
            arguments, TRY(devices::LiveDevices::play_log(arguments.played, clock.now)), clock);
    if (plays_hand(arguments))
        return show_devices(arguments, TRY(devices::LiveDevices::play_hand(clock.now)), clock);
    if (!arguments.devices.empty())
        return show_devices(arguments, TRY(devices::LiveDevices::open_named(arguments.devices)),
                            clock);
    auto const found = devices::find_pens_and_height_sensors();
    auto devices = found.empty() ? devices::LiveDevices::start({}) : open_found(found);
    return show_devices(arguments, TRY(std::move(devices)), clock);
}

// Adds options for devices and saving.
void add_drawing_options(CLI::App& command, WindowArguments& arguments)
{
    command
        .add_option("--device", arguments.devices,
                    fmt::format("What to read in place of what is found, each {}",
                                devices::device_name_help()))
        ->type_name("DEVICE...");
    command
        .add_option("--log", arguments.played,
                    "Read this recording as if its devices were there: its pen draws and presses "
                    "what the window shows; with --frames the same at each run")
        ->type_name("FILE")
        ->excludes("--device");
    command
        .add_option("--record", arguments.recording,
                    "Record all that the devices send and every choice of a tool: a new "
                    ".tractus-log")
        ->type_name("FILE");
    command
        .add_option("--least", arguments.least,
                    "How far a stroke has to get for a tool, in millimetres, as draw=6; what gets "
                    "less far does nothing; 0: every touch counts")
        ->type_name("TOOL=MM...");
    command
        .add_option("--session", arguments.session,
                    "Keep every stroke in this session as soon as it ends: a new one of the plant, "
                    "or one that is gone on with; without it, a new one named after the plant and "
                    "the time, in ~/.local/share/tractus")
        ->type_name("FILE.tractus")
        ->check(options::name_ending_in({ ".tractus" }));
}

// Adds options for the window's appearance and for how long it stays open.
void add_look_options(CLI::App& command, WindowArguments& arguments)
{
    command.add_flag("--full-screen", arguments.fills_display,
                     "Fill a display: the tablet's own, if it has one, else that which the window "
                     "opens on");
    command
        .add_option("--display", arguments.display,
                    "Fill this display: its number, or a part of its name")
        ->type_name("DISPLAY");
    auto const views = window::shown_words();
    command
        .add_option("--view", arguments.view,
                    "The view to begin with: all side by side, or the one that fills the window; "
                    "without it, the pad for a tablet's pen and else all")
        ->type_name("VIEW")
        ->check(options::one_of({ views.begin(), views.end() }));
    command.add_flag("--on-stage", arguments.is_on_stage,
                     "Show nothing but what grows, until Esc or the ring of tools ends that");
    auto const add_choice
        = [&](char const* name, std::optional<bool>& chosen, bool value, char const* help) {
              return command.add_flag_callback(
                  name, [&chosen, value] { chosen = value; }, help);
          };
    add_choice("--light", arguments.is_light, true, "Light colours, for a bright room")
        ->excludes(add_choice("--dark", arguments.is_light, false,
                              "Dark ones; without either, as chosen last in the window"));
    add_choice("--left-handed", arguments.is_left_handed, true,
               "The menu on the left and the scale of heights on the right")
        ->excludes(add_choice("--right-handed", arguments.is_left_handed, false,
                              "The other way round; without either, as chosen last in the window"));
    command
        .add_option("--scale", arguments.scale,
                    "How large letters and buttons are; 0 takes the display's own scale")
        ->type_name("X")
        ->check(options::number(0, 8));
    command
        .add_option("--frames", arguments.frames,
                    "Close after so many frames of 1/60 s; 0 stays open")
        ->type_name("N")
        ->check(options::whole_number(0, 1'000'000'000))
        ->capture_default_str();
    command.add_option("--screenshot", arguments.screenshot, "Write the last frame as a PNG")
        ->type_name("FILE.png")
        ->check(options::picture_name());
    command
        .add_option("--film", arguments.film,
                    "Write the window as pictures, 00001.png and on, into this new or empty "
                    "folder: while a "
                    "recording is replayed, or for --frames; the same pictures at each run")
        ->type_name("FOLDER");
    command.add_option("--film-rate", arguments.film_rate, "Pictures for a second of --film")
        ->type_name("N")
        ->check(options::whole_number(1, 60))
        ->capture_default_str()
        ->needs("--film");
}

} // namespace

void add_window_command(CLI::App& root, options::Action& action, tools::Methods const& methods)
{
    auto arguments = std::make_shared<WindowArguments>();
    arguments->methods = methods;
    auto* const command = root.add_subcommand(
        "window", "Open the station's window: a hand draws, and the plant changes");
    command->alias("draw");
    command->add_option(
        "FILE", arguments->file,
        "A session (.tractus) to go on with; a plant to draw on, as of --plant; or a drawing to "
        "replay, any recording that \"tractus replay\" takes; without it, one draws: with the "
        "tablets and the height sensor that are found, and with the mouse in place of what is "
        "missing");
    add_drawing_options(*command, *arguments);
    options::add_plant_option(*command, arguments->model)->required(false);
    command
        ->add_flag("--start-page", arguments->wants_start_page,
                   "Begin with the page on which one chooses, also with --log, --record, --frames "
                   "or --screenshot")
        ->excludes("--plant")
        ->excludes("--session");
    command
        ->add_option("--picture", arguments->picture,
                     "Lay this PNG or JPEG behind what is drawn, to draw after it")
        ->type_name("FILE");
    command
        ->add_option("--socket", arguments->socket,
                     "Tell other programs at a local socket of this name what is drawn, as "
                     "\"tractus stream\" does, and what grows by it")
        ->type_name("PATH");
    options::add_rig_option(*command, arguments->rig);
    options::add_height_option(*command, arguments->height);
    add_look_options(*command, *arguments);
    command->footer(
        "Begins with a page on which one chooses: an empty sheet, a model, or a drawing to go\n"
        "on with. With FILE, --plant, --session, --log, --record, --frames or --screenshot it\n"
        "begins with the drawing, of a broadleaf unless something else is named.\n"
        "\n"
        "Needs a display. Pictures that are saved appear in the working folder. While a pen is\n"
        "in range, the mouse counts for nothing in the window, since the desktop moves it with\n"
        "the pen; drivers/70-tractus.rules says how to stop that everywhere.");
    command->callback([arguments, &action] {
        action = [arguments]() -> Result<void> { return open_window(TRY(sort_out(*arguments))); };
    });
}

void add_tour_command(CLI::App& root, options::Action& action, tools::Methods const& methods)
{
    auto arguments = std::make_shared<WindowArguments>();
    arguments->methods = methods;
    arguments->begins_tour = true;
    auto* const command = root.add_subcommand(
        "tour", "See the station in five minutes: a hand draws a tree, and then you try");
    add_look_options(*command, *arguments);
    command->footer(
        "Opens the window on an empty sheet. A simulated hand draws a tree; then the window\n"
        "asks for one thing after another and waits until it is done: a limb, wind, other\n"
        "leaves, a season, many plants of the kind, a file for other programs. Each step can\n"
        "be skipped, and the tour ended. With a tablet, a height sensor, or the mouse in their\n"
        "place. The start page offers the same. Needs a display.");
    command->callback(
        [arguments, &action] { action = [arguments] { return open_window(*arguments); }; });
}

} // namespace tractus::commands
