#include "app/commands/grow.h"

#include "app/batch/pictures.h"
#include "app/batch/plant_file.h"
#include "app/batch/plant_group.h"
#include "app/batch/plant_report.h"
#include "app/batch/plant_to_grow.h"
#include "app/commands/ageing_plant.h"
#include "app/files/resources.h"
#include "app/methods/all_habits.h"
#include "app/options/checks.h"
#include "app/options/drawing_options.h"
#include "app/options/glb_options.h"
#include "app/options/growth_options.h"
#include "app/options/model_options.h"
#include "app/options/picture_options.h"
#include "app/options/solid_options.h"
#include "app/terminal/console.h"
#include "app/terminal/error_text.h"
#include "app/terminal/progress.h"
#include "engine/base/file.h"
#include "engine/export/glb_growth.h"
#include "engine/mesh/make_mesh.h"
#include "engine/scene/scene.h"
#include "engine/variation/ground.h"
#include "engine/variation/growth.h"

#include <filesystem>
#include <fmt/format.h>
#include <memory>

namespace tractus::commands {

namespace {

struct GrowArguments {
    batch::PlantToGrow plant;
    options::ModelOptions model; // The options of plant.model, plant.steps and plant.seed.
    options::DrawingArguments drawing;
    std::filesystem::path output;
    batch::PlantFileOptions file;
    // Number of ages in an animation that is written as one file; 0: no such animation.
    std::size_t ages = 0;
    // Number of files in an animation with one file per age; 0: no such animation.
    std::size_t frames = 0;
    double seconds = 10;
    double age = 1; // Age of the plant that is written; 1 is fully grown.
    bool report = false;

    bool is_varied() const { return plant.is_varied() || !drawing.log.empty(); }
};

// Returns the path of a frame's file: tree.glb becomes tree-01.glb and so on.
std::filesystem::path frame_path(std::filesystem::path const& output, std::size_t frame,
                                 std::size_t frames)
{
    auto const name = fmt::format("{}-{:0{}}{}", output.stem().string(), frame,
                                  std::to_string(frames).size(), output.extension().string());
    return output.parent_path() / name;
}

Result<std::unique_ptr<AgeingPlant>>
ageing_plant(GrowArguments const& arguments, scene::Scene const& scene, std::string const& name)
{
    if (scene.base->segment_count() == 0)
        return fail(Fault::User, fmt::format("{}: the plant has no branch that could grow", name));
    return arguments.is_varied()
        ? varied_plant(scene, arguments.plant.growth.along_ground)
        : plant_of_ages(scene, document::make_load_options(arguments.plant.cost));
}

// Describes what was written. An .mtg graph has no triangles to count.
std::string describe_result(Plant const& plant, batch::WrittenFile const& written,
                            std::filesystem::path const& output)
{
    auto text = fmt::format("{} segments, {} organs", plant.segment_count(), plant.organs.size());
    if (output.extension() != ".mtg")
        text += fmt::format(", {} triangles", written.triangles);
    return text + written.sentence();
}

// Returns the age of the plant in a frame, counted from 1. Ages are evenly spaced; in the last
// frame the plant is fully grown.
double age_of(std::size_t frame, std::size_t frames)
{
    return static_cast<double>(frame) / static_cast<double>(frames);
}

Result<void> write_one(GrowArguments const& arguments, Plant const& plant, std::string const& name)
{
    if (arguments.report && !arguments.output.empty())
        TRY(batch::write_plant_file(plant, name, arguments.output, arguments.file));
    if (arguments.report)
        return terminal::print_out(batch::print_plant_report(plant));
    auto const written
        = TRY(batch::write_plant_file(plant, name, arguments.output, arguments.file));
    return terminal::print_out(fmt::format("{}: {}\n", arguments.output.string(),
                                           describe_result(plant, written, arguments.output)));
}

// Writes the plant at the age that the user chose.
Result<void> write_young(GrowArguments const& arguments, scene::Scene const& scene,
                         std::string const& name)
{
    auto const ageing = TRY(ageing_plant(arguments, scene, name));
    return write_one(arguments, ageing->parts(arguments.age), name);
}

// Writes a file for each age, with those parts of the plant that have grown by then.
Result<void> write_sequence(GrowArguments const& arguments, scene::Scene const& scene,
                            std::string const& name)
{
    auto const ageing = TRY(ageing_plant(arguments, scene, name));
    auto file = arguments.file;
    if (arguments.output.extension() == ".png") {
        render::Framing framing({}, file.picture.aspect());
        framing.add(mesh::make_mesh(ageing->parts(1)));
        // All ages share one camera, which is fitted to the fully grown plant.
        file.camera = framing.camera();
    }
    for (std::size_t i = 1; i <= arguments.frames; ++i) {
        double const age = age_of(i, arguments.frames);
        auto const plant = ageing->parts(age);
        auto const path = frame_path(arguments.output, i, arguments.frames);
        auto const written = TRY(batch::write_plant_file(plant, name, path, file));
        TRY(terminal::print_out(fmt::format("{}: age {:.3f}, {}\n", path.string(), age,
                                            describe_result(plant, written, path))));
    }
    return {};
}

// Writes all ages into one file, as morph targets of one mesh.
Result<void> write_animation(GrowArguments const& arguments, scene::Scene const& scene,
                             std::string const& name)
{
    if (arguments.output.extension() != ".glb")
        return fail(Fault::User,
                    fmt::format("{}: an animation in one file is a .glb; --sequence writes {} "
                                "files, one for each age",
                                arguments.output.string(), arguments.output.extension().string()));
    auto const ageing = TRY(ageing_plant(arguments, scene, name));
    Plant const whole = ageing->grow(1);
    mesh::AgedMesh const mesh(whole);
    exports::GrowthFilm film { .name = name, .mesh = &mesh, .seconds = arguments.seconds };
    for (std::size_t i = 1; i <= arguments.ages; ++i)
        film.ages.push_back(age_of(i, arguments.ages));
    film.plant_at = [&](double age) -> Plant const& { return ageing->grow(age); };
    exports::GlbSummary summary;
    auto const write = [&](std::ostream& out) -> Result<void> {
        summary = TRY(exports::write_glb(out, film));
        return {};
    };
    TRY(write_file(arguments.output, write));
    return terminal::print_out(fmt::format(
        "{}: {} ages in {} s, {} segments, {} organs, {} triangles, "
        "{:.1f} MB\n",
        arguments.output.string(), arguments.ages, arguments.seconds, whole.segment_count(),
        whole.organs.size(), summary.triangles, static_cast<double>(summary.bytes) / 1e6));
}

Result<void> write_varied(GrowArguments const& arguments, scene::Scene const& scene,
                          std::string const& name)
{
    auto group = TRY(batch::PlantGroup::create(scene));
    if (arguments.plant.growth.along_ground)
        group.keep_above_ground();
    auto const plant = group.plant_as_displayed();
    if (auto const below = variation::describe_underground(group.underground(), plant);
        !below.empty())
        terminal::print_warning(
            fmt::format("{}: {}: --along-ground bends branches along it", name, below));
    return write_one(arguments, plant, name);
}

// Prints a list of measurements of each plant of a scene. Also writes the plants if an output file
// is named.
Result<void> report_all(GrowArguments const& arguments, scene::Scene const& scene,
                        std::string const& name)
{
    if (!arguments.output.empty()) {
        auto group = TRY(batch::PlantGroup::create(scene));
        TRY(batch::write_plant_file(group.plant_as_displayed(), name, arguments.output,
                                    arguments.file));
    }
    std::string list;
    for (auto const& plant : scene.plants) {
        auto report = batch::print_plant_report(*plant->base);
        while (!report.empty() && report.back() == '\n')
            report.pop_back();
        list += (list.empty() ? "[" : ",\n ") + report;
    }
    return terminal::print_out(list + "]\n");
}

// Warns if indicators were drawn but growth is set not to follow them.
void warn_of_ignored_indicators(scene::Scene const& scene)
{
    auto const& growth = scene.growth;
    if (scene.indicators.empty() || growth.parameters.indicator_gain * growth.variability != 0)
        return;
    terminal::print_warning(fmt::format(
        "the drawing has {} motion indicator{}, which plants that grow \"as drawn\" do not follow: "
        "add --growth usual",
        scene.indicators.size(), scene.indicators.size() == 1 ? "" : "s"));
}

Result<scene::Scene> add_drawing(batch::DrawingOptions const& options, scene::Scene scene)
{
    terminal::Progress progress;
    batch::DrawingReport report;
    auto drawing = TRY(batch::read_drawing(options, std::move(scene), progress, report));
    progress.finish();
    for (auto const& note : report.notes)
        terminal::print_warning(note);
    return std::move(drawing.scene);
}

// Returns what to grow, with the model's options.
batch::PlantToGrow plant_of(GrowArguments const& arguments)
{
    auto plant = arguments.plant;
    plant.model = arguments.model.model;
    plant.steps = arguments.model.steps;
    plant.seed = arguments.model.seed;
    return plant;
}

Result<void> grow_plant(GrowArguments const& arguments, tools::Methods const& methods)
{
    TRY(options::check_solid_options(arguments.file.solid, arguments.output));
    if (!arguments.output.empty())
        TRY(check_writable(arguments.output));
    auto [scene, name, is_session, warnings]
        = TRY(batch::load_plant_to_grow(plant_of(arguments), methods));
    for (auto const& warning : warnings)
        terminal::print_warning(warning);
    scene = TRY(batch::with_growth(arguments.plant.growth, std::move(scene)));
    if (auto const drawing = options::drawing_options(arguments.drawing, methods)) {
        if (!is_session && scene.base->segment_count() == 0)
            return fail(Fault::User,
                        fmt::format("{}: the plant has no branch that a stroke could shape", name));
        scene = TRY(add_drawing(*drawing, std::move(scene)));
    }
    warn_of_ignored_indicators(scene);
    if (arguments.ages > 0)
        return write_animation(arguments, scene, name);
    if (arguments.frames > 0)
        return write_sequence(arguments, scene, name);
    if (arguments.age < 1)
        return write_young(arguments, scene, name);
    if (arguments.report && scene.plants.size() > 1)
        return report_all(arguments, scene, name);
    if (!is_session && !arguments.is_varied() && scene.plants.size() == 1)
        return write_one(arguments, *scene.in_season, name);
    return write_varied(arguments, scene, name);
}

// Lists the formats: ".glb (glTF), .obj (Wavefront OBJ) ...".
std::string describe_formats()
{
    std::vector<std::string> list;
    for (auto const& format : batch::plant_formats())
        list.push_back(fmt::format("{} ({})", format.ending, format.label));
    return fmt::format("{}", fmt::join(list, ", "));
}

// How a .usda holds organs if --organs says how a .glb does.
exports::UsdOptions::Organs usd_organs(exports::GlbOptions::Organs organs)
{
    using Organs = exports::UsdOptions::Organs;
    return organs == exports::GlbOptions::Organs::Instanced ? Organs::Instanced : Organs::Merged;
}

void add_habit_options(CLI::App& command, GrowArguments& arguments)
{
    auto* const habit
        = command
              .add_option("--habit", arguments.plant.tree.habit,
                          "A tree that grows by itself, from a seed or, with a model, from that "
                          "plant as it stands: a species by its English or Latin name, or a .habit "
                          "file")
              ->type_name("HABIT|FILE")
              ->check(options::suggest(methods::habit_names()));
    command.add_option("--years", arguments.plant.tree.years, "How many years it grows")
        ->type_name("N")
        ->check(options::whole_number(1, 200))
        ->needs(habit)
        ->capture_default_str();
    auto* const stand
        = command
              .add_option("--stand", arguments.plant.tree.stand,
                          "How many trees of the habit grow beside each other, in rows, and shade "
                          "each other")
              ->type_name("N")
              ->check(options::whole_number(1, 400))
              ->needs(habit)
              ->capture_default_str();
    command
        .add_option("--spacing", arguments.plant.tree.spacing_m,
                    "The distance of their rows, in metres")
        ->type_name("M")
        ->check(options::number(0.1, 1000))
        ->needs(stand)
        ->capture_default_str();
    command
        .add_flag("--fill", arguments.plant.tree.fills,
                  "It fills the crown of a tree that was drawn by its outline, in a session; trunk "
                  "and drawn branches remain")
        ->needs(habit);
    command.add_flag("--report", arguments.report,
                     "Print as JSON what is measured of the plant: height, crown, slenderness, "
                     "Horton's ratios");
}

void add_animation_options(CLI::App& command, GrowArguments& arguments)
{
    auto* const animation
        = command
              .add_option("--animation", arguments.ages,
                          "Write the plant as it grows, from its youth to its full size, as one "
                          ".glb: a morph target for each of N ages, and an animation of them")
              ->type_name("N")
              ->check(options::whole_number(2, 10'000))
              ->excludes("--organs") // Morph targets need a single mesh with float coordinates.
              ->excludes("--quantized")
              ->excludes("--compressed");
    command.add_option("--seconds", arguments.seconds, "How long the animation takes")
        ->type_name("S")
        ->check(options::number(0.01, 1e6))
        ->needs(animation)
        ->capture_default_str();
    command
        .add_option("--sequence", arguments.frames,
                    "Write it as it grows, a file for each of N ages: FILE-1 to FILE-N, as many "
                    "digits as N has")
        ->type_name("N")
        ->check(options::whole_number(1, 10'000))
        ->excludes(animation);
}

// Throws CLI::ValidationError if there is neither a file to write nor a report to print. A model
// that does not exist is left to grow_plant() to report, as its name may be the actual mistake.
void check_output(GrowArguments const& arguments)
{
    bool const writes = !arguments.report || arguments.ages > 0 || arguments.frames > 0;
    auto const& model = arguments.model.model;
    if (!writes || !arguments.output.empty() || (!model.empty() && !files::find_model(model)))
        return;
    auto const name = model.empty() ? "tree" : std::filesystem::path(model).stem().string();
    throw CLI::ValidationError(
        fmt::format("say what to write, such as -o {0}.glb or -o {0}.png", name));
}

} // namespace

void add_grow_command(CLI::App& root, options::Action& action, tools::Methods const& methods)
{
    auto arguments = std::make_shared<GrowArguments>();
    auto* const command = root.add_subcommand(
        "grow", "Grow a model and write it for other programs, or as a picture");
    options::add_model_options(*command, arguments->model);
    // MODEL is optional here, as a habit may be given instead.
    command->get_option("MODEL")->required(false);
    add_habit_options(*command, *arguments);
    options::add_cost_options(*command, arguments->plant.cost);
    options::add_companion_options(*command, arguments->plant.companions);
    command
        ->add_option(
            "-o,--output", arguments->output,
            fmt::format("What to write: its ending says in which format: {}", describe_formats()))
        ->type_name("FILE")
        ->check(options::name_ending_in(batch::plant_endings()));
    options::add_picture_size_option(*command, arguments->file.picture);
    auto* const organs = options::add_glb_options(*command, arguments->file.glb);
    options::add_solid_options(*command, arguments->file.solid);
    options::add_growth_options(*command, arguments->plant.growth, "as drawn, or as in a session");
    options::add_drawing_options(*command, arguments->drawing,
                                 "the plant is as its model gives it");
    add_animation_options(*command, *arguments);
    options::add_age_option(*command, arguments->age);
    command->get_option("--age")->excludes("--animation")->excludes("--sequence");
    command->footer(
        "MODEL may also be a skeleton that another program has drawn as lines (.obj, .glb), a\n"
        "measured tree (cylinders, .csv or .txt; a skeleton, .ply; a graph, .mtg), or a\n"
        "session (.tractus): then it is the plant as drawn, as the station's window shows it,\n"
        "or with --seed another variation. With --growth the seed also says how a model\n"
        "grows. The same model, drawing and seed always give the same file.");
    command->callback([arguments, methods, organs, &action] {
        if (organs->count() > 0)
            arguments->file.usd.organs = usd_organs(arguments->file.glb.organs);
        check_output(*arguments);
        action = [arguments, methods] { return grow_plant(*arguments, methods); };
    });
}

} // namespace tractus::commands
