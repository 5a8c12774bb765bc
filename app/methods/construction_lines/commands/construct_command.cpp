#include "app/methods/construction_lines/commands/construct_command.h"

#include "app/batch/plant_file.h"
#include "app/batch/session_plant.h"
#include "app/document/model_cost.h"
#include "app/methods/construction_lines/construct_report.h"
#include "app/methods/construction_lines/line_drawing.h"
#include "app/methods/construction_lines/line_sketch_file.h"
#include "app/options/checks.h"
#include "app/options/examples.h"
#include "app/options/picture_options.h"
#include "app/terminal/console.h"
#include "app/terminal/error_text.h"
#include "engine/base/file.h"
#include "engine/methods/construction_lines/line_model.h"
#include "engine/methods/construction_lines/organ_text.h"
#include "engine/scene/edit_words.h"
#include "engine/scene/scene.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace tractus::lines {

namespace {

namespace fs = std::filesystem;

struct ConstructArguments {
    tools::Methods methods;
    fs::path sketch;
    fs::path output;
    render::PictureSize picture;
    lines::SketchOverrides given;
    bool smooth = false;
    bool report = false;
    bool session = false;
};

// File name of the model: the name of the sketch's file without those characters that an L-system
// view cannot contain.
std::string model_name(fs::path const& sketch)
{
    auto name = sketch.stem().string();
    for (auto& character : name)
        if (std::isalnum(static_cast<unsigned char>(character)) == 0 && character != '-')
            character = '_';
    return name;
}

using Stems = std::vector<lines::MeasuredStem>;

Result<Stems> measure(ConstructArguments const& arguments, lines::LineDrawing const& drawing)
{
    // A sketch of unsorted strokes may lack lines, which are then guessed.
    auto const missing = drawing.roles.empty() ? lines::Missing::Refused : lines::Missing::Guessed;
    auto result = TRY(lines::measure_stems(drawing.stems, missing));
    for (auto const& notes : { drawing.notes, lines::notes_of(result) })
        for (auto const& note : notes)
            terminal::print_warning(fmt::format("{}: {}", arguments.sketch.string(), note));
    return result;
}

// An error whose message begins with the name of the sketch's file.
tl::unexpected<Error> about(fs::path const& file, Error const& error)
{
    return fail(error.fault, fmt::format("{}: {}", file.string(), error.message));
}

// Writes the model's files, which can be read by this program and by cpfg.
Result<void> write_model_files(fs::path const& base, lines::LineModel const& model)
{
    for (auto const& [name, text] : model.functions)
        TRY(write_file(base.parent_path() / name, text));
    TRY(write_file(fs::path(base).concat(".v"), model.source.view_text));
    return write_file(fs::path(base).concat(".l"), model.source.text);
}

// Writes the plant's files into the output folder and returns a list of their names.
Result<std::string> write_folder(ConstructArguments const& arguments, scene::LoadModel const& load,
                                 lines::LineModel model, Plant const& plant)
{
    lines::add_blade_surfaces(model);
    auto const name = model_name(arguments.sketch);
    auto const base = arguments.output / name;
    TRY(write_model_files(base, model));
    if (!arguments.report)
        for (auto const* const ending : { ".png", ".glb" })
            TRY(batch::write_plant_file(plant, name, fs::path(base).concat(ending),
                                        { .picture = arguments.picture }));
    if (arguments.session)
        TRY(batch::begin_session(fs::path(base).concat(".tractus"), { load },
                                 arguments.methods.edits));
    auto const count = [&](char const* ending) {
        return std::count_if(model.functions.begin(), model.functions.end(), [&](auto const& file) {
            return fs::path(file.first).extension() == ending;
        });
    };
    auto const surfaces = count(".s");
    auto const textures = static_cast<std::size_t>(count(".png"));
    return fmt::format("{}.l, .v, {} .func,{}{} .png, .glb{}", base.string(), count(".func"),
                       surfaces > 0 ? fmt::format(" {} .s,", surfaces) : "",
                       textures > 0 ? fmt::format(" {},", scene::counted(textures, "texture")) : "",
                       arguments.session ? ", .tractus" : "");
}

lines::Smoothing smoothing_of(ConstructArguments const& arguments)
{
    return arguments.smooth ? lines::Smoothing::Hand : lines::Smoothing::None;
}

// Makes the model of a sketch together with the sketches that serve as its organs.
Result<lines::LineModel> write_model(ConstructArguments const& arguments,
                                     lines::LineSketchFile const& file, Stems const& stems)
{
    std::vector<std::string> notes;
    auto const sketch
        = TRY(lines::load_composed(arguments.sketch, file, stems, smoothing_of(arguments), notes));
    for (auto const& note : notes)
        terminal::print_warning(note);
    auto model = lines::write_composed_model(sketch, model_name(arguments.sketch));
    if (!model)
        return about(arguments.sketch, model.error());
    return model;
}

Result<void> make_plant(ConstructArguments const& arguments, lines::LineSketchFile const& file,
                        lines::LineDrawing const& drawing, Stems const& stems)
{
    bool const to_file = batch::is_plant_file(arguments.output);
    auto const name = model_name(arguments.sketch);
    auto const model = TRY(write_model(arguments, file, stems));
    scene::LoadModel const load { .source = model.source, .includes = model.functions };
    auto const scene = TRY(scene::apply_edit({}, load, document::make_load_options()));
    auto written = arguments.output.string();
    std::string note;
    if (to_file)
        note = TRY(batch::write_plant_file(*scene.base, name, arguments.output,
                                           { .picture = arguments.picture }))
                   .sentence();
    else
        written = TRY(write_folder(arguments, load, model, *scene.base));
    if (arguments.report)
        return terminal::print_out(lines::print_report(stems, *scene.base, drawing));
    std::size_t nodes = 0;
    for (auto const& stem : stems)
        nodes += stem.construction.nodes.size();
    return terminal::print_out(fmt::format("{}: {} nodes, {} organs{}\n", written, nodes,
                                           scene.base->organs.size(), note));
}

Result<void> construct_plant(ConstructArguments const& arguments)
{
    if (arguments.session && batch::is_plant_file(arguments.output))
        return fail(Fault::User,
                    fmt::format("{}: a session needs a folder to be in: give one as the output",
                                arguments.output.string()));
    TRY(check_writable(batch::is_plant_file(arguments.output) ? arguments.output
                                                              : arguments.output / "model.l"));
    auto const file = TRY(lines::load_line_sketch(arguments.sketch, arguments.given));
    for (auto const& key : file.unknown_keys)
        terminal::print_warning(fmt::format("{}: \"{}\" is left out: nothing is called so",
                                            arguments.sketch.string(), key.substr(0, 40)));
    auto const drawing = lines::prepare_drawing(file, smoothing_of(arguments));
    if (!drawing)
        return about(arguments.sketch, drawing.error());
    auto const stems = measure(arguments, *drawing);
    if (!stems)
        return about(arguments.sketch, stems.error());
    return make_plant(arguments, file, *drawing, *stems);
}

void add_options(CLI::App& command, ConstructArguments& arguments)
{
    command
        .add_option("SKETCH", arguments.sketch,
                    "The sketch: a JSON file of lines in millimetres, or an SVG drawing (.svg)")
        ->type_name("SKETCH")
        ->required();
    command
        .add_option(
            "-o,--output", arguments.output,
            "The folder for the plant's files, made if it is not there; or the plant alone, "
            "as the file's ending says: "
                + batch::listed(batch::plant_endings()))
        ->type_name("OUTPUT")
        ->required();
    options::add_picture_size_option(command, arguments.picture);
    command
        .add_option("--pattern", arguments.given.pattern,
                    "How organs stand, in place of what the sketch says: distichous, decussate, "
                    "spiral, alternate or whorled(N)")
        ->type_name("PATTERN");
    command
        .add_option("--sizes", arguments.given.sizes,
                    "How sizes change around the stem from left to right: linear or half-ellipses")
        ->type_name("SIZES")
        ->check(options::one_of({ "linear", "half-ellipses" }));
    command
        .add_option("--divergence", arguments.given.divergence_deg,
                    "Degrees from organ to organ, of spiral and alternate")
        ->type_name("DEGREES")
        ->check(options::number(-360, 360));
    command
        .add_option("--nodes", arguments.given.nodes_per_layer,
                    "How many nodes each layer has, from below, such as 9,14")
        ->type_name("N,N,...")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(options::whole_number(0, lines::kMaxNodesInLayer));
    command.add_flag("--smooth", arguments.smooth,
                     "The lines are a hand's: take its tremor out of them first");
    command.add_flag("--session", arguments.session, "Also begin a session with the plant");
    command.add_flag("--report", arguments.report,
                     "Write the model alone, and print as JSON what was measured in the sketch");
}

} // namespace

void add_construct_command(CLI::App& root, options::Action& action, tools::Methods const& methods)
{
    auto arguments = std::make_shared<ConstructArguments>();
    arguments->methods = methods;
    auto* const command = root.add_subcommand("construct", "Make a plant from construction lines");
    add_options(*command, *arguments);
    command->footer(
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
        "the boundaries; \"boundaries\": more of them in space, [u,v,w]; \"sizes\": linear or\n"
        "half-ellipses from left to right around the stem; \"inclinations\": at least two lines;\n"
        "\"nodes_per_layer\": how many nodes stand between one line and the next, a number for "
        "each\n"
        "layer; \"face\": flat, up or down, how organs are turned; \"organs\": for each layer from "
        "below\n"
        "null, the file of a sketch whose plants stand there, views as \"organ\" has them, or an "
        "object\n"
        "of \"pattern\", \"divergence\", \"face\" and \"organ\"; \"organ\": the leaves' shape, an "
        "object of\n"
        "\"left\", \"right\", \"midrib\", \"section\", \"color\" and \"texture\", the name of a "
        "PNG "
        "file;\n"
        "\"strokes\": in place of all lines, what was drawn, in any order, pieces and corrections "
        "too;\n"
        "\"stems\": more stems of the "
        "plant, objects of \"stem\" and, if what grows "
        "on the "
        "first\n"
        "one does not grow on it, too, lines of its own. A stem that begins on another one stands\n"
        "there, on its top as a fork.");
    options::add_examples(
        *command,
        { "construct sketch.json -o plant.glb", "construct sketch.json --report -o plant.obj" });
    command->callback(
        [arguments, &action] { action = [arguments] { return construct_plant(*arguments); }; });
}

} // namespace tractus::lines
