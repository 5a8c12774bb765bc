#include "app/methods/construction_lines/construct_command.h"

#include "app/methods/construction_lines/construct_report.h"
#include "app/methods/construction_lines/line_sketch_file.h"
#include "app/plants/plant_file.h"
#include "app/plants/session_plant.h"
#include "app/station/model_cost.h"
#include "app/terminal/console.h"
#include "app/terminal/error_text.h"
#include "drivers/file.h"
#include "engine/methods/construction_lines/capture_line.h"
#include "engine/methods/construction_lines/line_model.h"
#include "engine/scene/scene.h"
#include "engine/stroke/polyline.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <string>
#include <string_view>

namespace tractus {

namespace {

namespace fs = std::filesystem;

struct ConstructArguments {
    fs::path sketch;
    fs::path output;
    bool smooth = false;
    bool report = false;
    bool session = false;
};

// A line as a pen's stroke. One without two points is left for the sketch to be refused.
std::vector<Vec3> captured(std::vector<Vec3> const& tips)
{
    auto const points = distinct_points(tips);
    return points ? lines::capture_line(*points) : tips;
}

std::vector<Vec2> captured(std::vector<Vec2> const& tips)
{
    std::vector<Vec3> points;
    for (auto const& tip : tips)
        points.emplace_back(tip.x(), tip.y(), 0);
    std::vector<Vec2> line;
    for (auto const& point : captured(points))
        line.push_back(point.head<2>());
    return line;
}

void capture_lines(lines::LineSketch& sketch)
{
    sketch.stem = captured(sketch.stem);
    sketch.left = captured(sketch.left);
    sketch.right = captured(sketch.right);
    for (auto& line : sketch.inclinations)
        line = captured(line);
}

// What the model's files are called: the sketch's name, as far as a view can say it.
std::string model_name(fs::path const& sketch)
{
    auto name = sketch.stem().string();
    for (auto& character : name)
        if (std::isalnum(static_cast<unsigned char>(character)) == 0 && character != '-')
            character = '_';
    return name;
}

// A plant's file instead of a folder.
bool is_plant_file(fs::path const& output)
{
    constexpr std::array kEndings { ".glb", ".obj", ".png" };
    return std::find(kEndings.begin(), kEndings.end(), output.extension()) != kEndings.end();
}

Result<lines::Construction> measure(ConstructArguments const& arguments,
                                    lines::LineSketchFile& file)
{
    for (auto const& key : file.unknown_keys)
        print_warning(fmt::format("{}: \"{}\" is left out: nothing is called so",
                                  arguments.sketch.string(), key.substr(0, 40)));
    if (arguments.smooth)
        capture_lines(file.sketch);
    auto construction = lines::measure_sketch(file.sketch);
    if (!construction)
        return fail(construction.error().fault,
                    fmt::format("{}: {}", arguments.sketch.string(), construction.error().message));
    for (auto const& note : construction->notes)
        print_warning(fmt::format("{}: {}", arguments.sketch.string(), note));
    return construction;
}

Result<void> write_model_files(fs::path const& base, lines::LineModel const& model)
{
    for (auto const& [name, text] : model.functions)
        TRY(write_file(base.parent_path() / name, text));
    TRY(write_file(fs::path(base).concat(".v"), model.source.view_text));
    return write_file(fs::path(base).concat(".l"), model.source.text);
}

// The folder, and a sentence that says what is in it.
Result<std::string> write_folder(ConstructArguments const& arguments, LoadModel const& load,
                                 lines::LineModel const& model, Plant const& plant)
{
    auto const name = model_name(arguments.sketch);
    auto const base = arguments.output / name;
    TRY(write_model_files(base, model));
    if (!arguments.report)
        for (auto const* const ending : { ".png", ".glb" })
            TRY(write_plant_file(plant, name, fs::path(base).concat(ending)));
    if (arguments.session)
        TRY(begin_session(fs::path(base).concat(".tractus"), { load }));
    return fmt::format("{}.l, .v, {} .func, .png, .glb{}", base.string(), model.functions.size(),
                       arguments.session ? ", .tractus" : "");
}

Result<void> construct_plant(ConstructArguments const& arguments)
{
    bool const to_file = is_plant_file(arguments.output);
    TRY(check_writable(to_file ? arguments.output : arguments.output / "model.l"));
    auto file = TRY(lines::load_line_sketch(arguments.sketch));
    auto const construction = TRY(measure(arguments, file));
    auto const name = model_name(arguments.sketch);
    auto const model = lines::write_model(construction, file.pattern, name);
    LoadModel const load { .source = model.source, .includes = model.functions };
    auto const scene = TRY(apply_edit({}, load, load_options()));
    auto written = arguments.output.string();
    if (to_file)
        TRY(write_plant_file(*scene.base, name, arguments.output));
    else
        written = TRY(write_folder(arguments, load, model, *scene.base));
    if (arguments.report)
        return print_out(lines::print_report(construction, *scene.base));
    return print_out(fmt::format("{}: {} nodes, {} organs\n", written, construction.nodes.size(),
                                 scene.base->organs.size()));
}

void add_options(CLI::App& verb, ConstructArguments& arguments)
{
    verb.add_option("SKETCH", arguments.sketch, "The sketch, a JSON file of lines in millimetres")
        ->type_name("SKETCH")
        ->required();
    verb.add_option(
            "-o,--output", arguments.output,
            "The folder for the plant's files, made if it is not there; or the plant alone, "
            "as the file's ending says: .glb, .obj or .png")
        ->type_name("OUTPUT")
        ->required();
    verb.add_flag("--smooth", arguments.smooth,
                  "The lines are a hand's: take its tremor out of them first");
    verb.add_flag("--session", arguments.session, "Also begin a session with the plant");
    verb.add_flag("--report", arguments.report,
                  "Write the model alone, and print as JSON what was measured in the sketch");
}

} // namespace

void add_construct_command(CLI::App& root, Action& action)
{
    auto arguments = std::make_shared<ConstructArguments>();
    auto* const verb = root.add_subcommand("construct", "Make a plant from construction lines");
    add_options(*verb, *arguments);
    verb->footer(
        "An illustrator's sketch sets a model's parameters (Anastacio, Prusinkiewicz, Sousa 2008): "
        "a\n"
        "stem, the lines that the organs' tips reach on its left and right, and lines across it "
        "that\n"
        "say how organs lean. SKETCH is a JSON object of \"pattern\": distichous, decussate, "
        "spiral,\n"
        "alternate or whorled(N); \"divergence\": degrees, of spiral and alternate; \"stem\": "
        "points\n"
        "[u,v] or [u,v,w], to the right, up and towards the viewer, base first; \"left\" and "
        "\"right\":\n"
        "the boundaries; \"inclinations\": at least two lines; \"nodes_per_layer\": how many "
        "nodes\n"
        "stand between one line and the next, a number for each layer.");
    verb->callback(
        [arguments, &action] { action = [arguments] { return construct_plant(*arguments); }; });
}

} // namespace tractus
