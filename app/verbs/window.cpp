#include "app/verbs/window.h"

#include "app/log_replay.h"
#include "app/model_file.h"
#include "app/replay_window.h"
#include "app/resources.h"
#include "app/simulated_recording.h"
#include "app/verbs/checks.h"
#include "app/window/window.h"
#include "calib/rig_file.h"
#include "drivers/file.h"
#include "drivers/log.h"

#include <fmt/core.h>
#include <memory>
#include <sstream>

namespace tractus {

namespace {

struct Arguments {
    std::string log;
    std::string model = "broadleaf";
    std::string rig;
    std::string height;
    int frames = 0;
    std::string screenshot;
};

// The demo of a model of ours; on any other the hand does what it does in the broadleaf tree's
// demo.
Result<Log> drawn_by_the_simulated_hand(std::filesystem::path const& model, Scene const& scene)
{
    if (auto const demo = find_resource(fmt::format("demo/{}.tractus-log", model.stem().string())))
        return read_log(*demo);
    auto const path = TRY(find_resource("demo/broadleaf.hand.toml"));
    auto const text = TRY(read_file(path));
    auto const script = TRY(parse_gesture_script(text, path.string()));
    std::ostringstream log;
    TRY(write_simulated_recording(log, script, scene));
    return parse_log(log.str(), "simulated hand");
}

Result<void> open_window(Arguments const& arguments)
{
    auto const model = TRY(find_model(arguments.model));
    auto const edit = TRY(load_model_edit(model));
    ReplayOptions options;
    options.scene = TRY(apply_edit({}, edit));
    if (!arguments.rig.empty())
        options.rig = TRY(load_rig(arguments.rig));
    if (!arguments.height.empty())
        options.height = TRY(parse_height_scenario(arguments.height));
    auto const log = TRY(arguments.log.empty() ? drawn_by_the_simulated_hand(model, options.scene)
                                               : read_log(arguments.log));
    auto window = TRY(ReplayWindow::create(log, options, std::filesystem::current_path()));
    WindowOptions window_options;
    window_options.title
        = fmt::format("tractus: {} on {}", std::filesystem::path(log.name).filename().string(),
                      model.stem().string());
    window_options.frames = arguments.frames;
    window_options.screenshot = arguments.screenshot;
    return run_window(window, window_options);
}

} // namespace

void add_window_verb(CLI::App& root, Action& action)
{
    auto arguments = std::make_shared<Arguments>();
    auto* const verb = root.add_subcommand(
        "window", "Open the station's window: a recorded hand draws, and the plant changes");
    verb->add_option("LOG", arguments->log,
                     "The drawing: a .tractus-log, or anybody's hid-recorder file; without it, the "
                     "model's demo on the simulated rig");
    verb->add_option("--plant", arguments->model,
                     "The plant's model: an L-system file (.l), or broadleaf, conifer, daisy or "
                     "shrub")
        ->type_name("MODEL")
        ->capture_default_str();
    verb->add_option("--rig", arguments->rig,
                     "The rig's calibration, a .rig.toml; without it, the log's own")
        ->type_name("FILE");
    verb->add_option("--height", arguments->height,
                     "The surface's height in place of the log's height sensor: millimetres above "
                     "the desk, or a made-up movement: rise, fall, arch or sway")
        ->type_name("MM|MOVEMENT")
        ->check(height_scenario());
    verb->add_option("--frames", arguments->frames,
                     "Close after so many frames of 1/60 s; 0 stays open")
        ->type_name("N")
        ->check(whole_number(0, 1'000'000'000))
        ->capture_default_str();
    verb->add_option("--screenshot", arguments->screenshot, "Write the last frame as a PNG")
        ->type_name("FILE.png")
        ->check(picture_name());
    verb->footer("Needs a display. Pictures that are saved appear in the working folder.");
    verb->callback(
        [arguments, &action] { action = [arguments] { return open_window(*arguments); }; });
}

} // namespace tractus
