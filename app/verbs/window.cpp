#include "app/verbs/window.h"

#include "app/log_replay.h"
#include "app/model_file.h"
#include "app/replay_window.h"
#include "app/resources.h"
#include "app/window/window.h"
#include "calib/rig_file.h"
#include "drivers/log.h"

#include <fmt/core.h>
#include <memory>

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
    std::filesystem::path path = arguments.log;
    if (path.empty())
        path = TRY(find_resource(fmt::format("demo/{}.tractus-log", model.stem().string())));
    auto const log = TRY(read_log(path));
    auto window = TRY(ReplayWindow::create(log, options, std::filesystem::current_path()));
    WindowOptions window_options;
    window_options.title
        = fmt::format("tractus: {} on {}", path.filename().string(), model.stem().string());
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
    verb->add_option("log", arguments->log,
                     "The recording; default: the model's demo on the simulated rig");
    verb->add_option("--plant", arguments->model,
                     "The model: an L-system file, or the name of one of ours")
        ->capture_default_str();
    verb->add_option("--rig", arguments->rig,
                     "The rig's calibration (.rig.toml); default: the log's own");
    verb->add_option("--height", arguments->height,
                     "In place of a height sensor: millimetres, or rise, fall, arch or sway");
    verb->add_option("--frames", arguments->frames,
                     "Close after so many frames of 1/60 s; 0: stay open")
        ->capture_default_str()
        ->check(CLI::NonNegativeNumber);
    verb->add_option("--screenshot", arguments->screenshot, "Write the last frame as a PNG");
    verb->callback(
        [arguments, &action] { action = [arguments] { return open_window(*arguments); }; });
}

} // namespace tractus
