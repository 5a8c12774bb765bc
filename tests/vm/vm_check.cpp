// Runs the checks of checks.h as subcommands for the scenarios.
#include "tests/vm/checks.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <functional>
#include <string>
#include <vector>

namespace tractus {

namespace {

// Arguments of all checks; each check uses some of them.
struct Arguments {
    TruthOptions truth;
    std::vector<std::size_t> devices;
    bool is_first_repeated = false;
    std::size_t device = 0;
    double pause_ms = 50;
    unsigned encoder_counts = 0;
    HeightExpectation height;
    StreamExpectation stream;
    std::size_t min_strokes = 1;
    std::string node;
    WatchedWindow window;
    std::string other;
    std::vector<std::string> logs;
    double seconds = 1;
};

using Check = std::function<Result<void>()>;

void add_checks(CLI::App& root, Arguments& arguments, Check& check)
{
    auto& truth = arguments.truth;
    auto* const same = root.add_subcommand("same-reports", "Did every report come as it was sent?");
    same->add_option("SENT", truth.sent)->required();
    same->add_option("GOT", truth.got)->required();
    same->add_option("--device", arguments.devices, "Of SENT; without it, all");
    same->add_flag("--first-repeated", arguments.is_first_repeated, "As gadgets do");
    same->callback([&] {
        check = [&] {
            return compare_reports(truth.sent, truth.got, arguments.devices,
                                   arguments.is_first_repeated ? FirstReport::Repeated
                                                               : FirstReport::Once);
        };
    });

    auto* const gaps = root.add_subcommand("gaps", "How regularly did a device send?");
    gaps->add_option("GOT", truth.got)->required();
    gaps->add_option("--device", arguments.device, "Of GOT; without it, the first");
    gaps->add_option("--pause-ms", arguments.pause_ms, "Longer gaps do not count");
    gaps->callback([&] {
        check = [&] { return measure_gaps(truth.got, arguments.device, arguments.pause_ms); };
    });

    auto* const strokes = root.add_subcommand("strokes", "Are the strokes where the hand was?");
    strokes->add_option("SCRIPT", truth.script)->required();
    strokes->add_option("SENT", truth.sent)->required();
    strokes->add_option("GOT", truth.got)->required();
    strokes->add_option("MODEL", truth.model)->required();
    strokes->add_option("--strokes", truth.strokes, "How many; without it, all of SCRIPT");
    strokes->add_flag("--torn", truth.is_torn, "GOT may end before SENT");
    strokes->add_option("--rms-mm", truth.limit_rms_mm, "At most");
    strokes->add_option("--max-mm", truth.limit_max_mm, "At most");
    strokes->add_option("--path-mm", truth.limit_path_mm, "At most");
    strokes->callback([&] { check = [&] { return compare_strokes(truth); }; });

    auto* const interrupted
        = root.add_subcommand("interrupted-strokes", "Was what was drawn kept, piece by piece?");
    interrupted->add_option("GOT", truth.got)->required();
    interrupted->add_option("MODEL", truth.model)->required();
    interrupted->add_option("--least", arguments.min_strokes);
    interrupted->callback([&] {
        check = [&] {
            return check_interrupted_strokes(truth.got, truth.model, arguments.min_strokes);
        };
    });

    auto* const late = root.add_subcommand("read-late", "Is all there if nobody takes it at once?");
    late->add_option("NODE", arguments.node)->required();
    late->add_option("SENT", truth.sent)->required();
    late->add_option("--seconds", arguments.seconds);
    late->callback(
        [&] { check = [&] { return read_late(arguments.node, truth.sent, arguments.seconds); }; });
}

void add_drawing_checks(CLI::App& root, Arguments& arguments, Check& check)
{
    auto& watched = arguments.window;
    auto* const window = root.add_subcommand("live-window", "What does the station's window show?");
    window->add_option("MODEL", watched.model)->required();
    window->add_option("RIG", watched.rig_file)->required();
    window->add_option("--session", watched.session, "Keeps what is drawn");
    window->add_option("--record", watched.recording, "A new log of all that comes");
    window->add_option("--tools", watched.tools, "A log whose tools are chosen, one a stroke");
    window->callback([&] { check = [&] { return watch_live_window(watched); }; });

    auto* const replay
        = root.add_subcommand("replay-session", "What do recordings draw, one after the other?");
    replay->add_option("MODEL", watched.model)->required();
    replay->add_option("SESSION", watched.session)->required();
    replay->add_option("LOGS", arguments.logs)->required();
    replay->callback([&] {
        check = [&] {
            return go_on_with_recordings({ watched.model, watched.session }, arguments.logs);
        };
    });

    auto* const same = root.add_subcommand("same-drawing", "Do two sessions have the same edits?");
    same->add_option("SESSION", watched.session)->required();
    same->add_option("OTHER", arguments.other)->required();
    same->callback(
        [&] { check = [&] { return compare_drawings(watched.session, arguments.other); }; });
}

void add_height_checks(CLI::App& root, Arguments& arguments, Check& check)
{
    auto& got = arguments.truth.got;
    auto* const height = root.add_subcommand("height", "Did the height sensor say what it should?");
    height->add_option("GOT", got)->required();
    height->add_option("--fraction", arguments.height.fraction, "Of full scale")->required();
    height->add_option("--tolerance", arguments.height.tolerance, "The same");
    height->callback([&] { check = [&] { return check_height(got, arguments.height); }; });

    auto* const same = root.add_subcommand("same-heights", "Were these the heights, in time?");
    same->add_option("SENT", arguments.truth.sent)->required();
    same->add_option("GOT", got)->required();
    same->add_option("--tolerance", arguments.height.tolerance, "Of full scale");
    same->callback([&] {
        check = [&] {
            return compare_heights(arguments.truth.sent, got, arguments.height.tolerance);
        };
    });

    auto* const encoder = root.add_subcommand("same-counts", "Did an encoder count the heights?");
    encoder->add_option("SENT", arguments.truth.sent)->required();
    encoder->add_option("GOT", got)->required();
    encoder->add_option("--counts", arguments.encoder_counts, "Over the full scale")->required();
    encoder->callback([&] {
        check
            = [&] { return compare_encoder(arguments.truth.sent, got, arguments.encoder_counts); };
    });

    auto* const stream = root.add_subcommand("stream", "Did the own sensor's frames come whole?");
    stream->add_option("GOT", got)->required();
    stream->add_option("--max-lost", arguments.stream.max_lost_frames);
    stream->add_option("--restarts", arguments.stream.restarts, "Of the sensor's clock");
    stream->callback([&] { check = [&] { return check_stream(got, arguments.stream); }; });
}

int run(int argc, char const* const* argv)
{
    CLI::App root("Judges what a scenario did");
    Arguments arguments;
    Check check;
    add_checks(root, arguments, check);
    add_drawing_checks(root, arguments, check);
    add_height_checks(root, arguments, check);
    root.require_subcommand(1);
    CLI11_PARSE(root, argc, argv);
    auto const result = check();
    if (!result)
        fmt::print("failed: {}\n", result.error().message);
    return result ? 0 : 1;
}

} // namespace

} // namespace tractus

int main(int argc, char** argv)
{
    return tractus::run(argc, argv);
}
