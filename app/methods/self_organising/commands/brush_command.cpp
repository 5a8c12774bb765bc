#include "app/methods/self_organising/commands/brush_command.h"

#include "app/batch/drawing.h"
#include "app/batch/plant_file.h"
#include "app/batch/session_plant.h"
#include "app/document/model_cost.h"
#include "app/files/resources.h"
#include "app/methods/self_organising/case_file.h"
#include "app/methods/self_organising/habit_file.h"
#include "app/options/checks.h"
#include "app/options/examples.h"
#include "app/options/glb_options.h"
#include "app/options/picture_options.h"
#include "app/options/shared_options.h"
#include "app/terminal/console.h"
#include "engine/base/file.h"
#include "engine/methods/self_organising/grown_tree.h"
#include "engine/methods/self_organising/life.h"
#include "engine/scene/scene.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace tractus::self_organising {

namespace {

namespace fs = std::filesystem;

struct BrushArguments {
    tools::Methods methods;
    fs::path example;
    bool report = false;
    fs::path strokes;
    std::string from;   // File of a plant from which the tree grows; empty: it grows from a seed.
    std::string height; // Heights for a recording that has no height sensor.
    std::string habit = "oak";
    int years = 12;
    std::uint64_t seed = 1;
    std::string radius = "8..40";
    double scale = 10;      // Size of the tree as a multiple of the strokes' size.
    bool is_scaled = false; // True if the user gave --scale.
    bool waits = false;
    fs::path output;
    batch::PlantFileOptions file;
};

Result<void> report_case(BrushArguments const& arguments)
{
    auto example = TRY(load_case(arguments.example));
    auto const laws = example.laws;
    auto const grown = TRY(grow_case(std::move(example)));
    return terminal::print_out(print_case_report(grown, laws));
}

// The weight with which each stroke gets a share of the years. It is the stroke's duration or, if
// the file has no times, the stroke's length.
std::vector<double> weights_of(std::vector<Stroke> const& strokes)
{
    std::vector<double> seconds;
    std::vector<double> lengths_mm;
    for (auto const& stroke : strokes) {
        auto const& tips = stroke.tips.vector();
        seconds.push_back(to_seconds(tips.back().time - tips.front().time));
        double length_mm = 0;
        for (std::size_t i = 1; i < tips.size(); ++i)
            length_mm += (tips[i].position_mm - tips[i - 1].position_mm).norm();
        lengths_mm.push_back(std::max(length_mm, 1.0));
    }
    bool const has_times
        = std::all_of(seconds.begin(), seconds.end(), [](double s) { return s > 0; });
    return has_times ? seconds : lengths_mm;
}

// Divides `years` among the strokes by their weights. Each stroke gets at least one year.
std::vector<int> years_of(std::vector<Stroke> const& strokes, int years)
{
    auto const weights = weights_of(strokes);
    double const all = std::accumulate(weights.begin(), weights.end(), 0.0);
    std::vector<int> shares;
    double until = 0;
    int given = 0;
    for (auto const weight : weights) {
        until += weight;
        auto const end = static_cast<int>(std::lround(years * until / all));
        shares.push_back(std::max(end - given, 1));
        given += shares.back();
    }
    return shares;
}

// The strokes that the brush follows. Empty if no file of strokes was given: the plant then grows
// by itself.
Result<std::vector<Stroke>> strokes_of(BrushArguments const& arguments)
{
    if (arguments.strokes.empty())
        return std::vector<Stroke> {};
    batch::DrawingOptions options { .log = arguments.strokes, .methods = arguments.methods };
    if (!arguments.height.empty())
        options.height = arguments.height;
    auto strokes = TRY(batch::drawn_strokes(options));
    std::erase_if(strokes, [](Stroke const& stroke) { return stroke.tips.empty(); });
    if (strokes.empty())
        return fail(Fault::User,
                    fmt::format("{}: there is no stroke in it", arguments.strokes.string()));
    return strokes;
}

// The periods of the tree's life: one for each stroke, or a single period if there is no stroke.
Result<std::vector<LifePeriod>> parts_of(BrushArguments const& arguments)
{
    auto strokes = TRY(strokes_of(arguments));
    if (strokes.empty())
        return std::vector<LifePeriod> { { .years = arguments.years } };
    // The option parser has checked that the range of radii is valid.
    auto const [min_mm, most_mm] = *options::parse_range(arguments.radius);
    auto const years = years_of(strokes, arguments.years);
    std::vector<LifePeriod> parts;
    for (std::size_t i = 0; i < strokes.size(); ++i)
        parts.push_back({ .years = years[i],
                          .stroke = std::move(strokes[i]),
                          .min_radius_mm = min_mm,
                          .most_radius_mm = most_mm,
                          .waits_outside = arguments.waits });
    return parts;
}

// Edits that load the plant from which the tree grows. Sets `plant` to the plant's id.
Result<std::vector<scene::Edit>> beginning_edits(BrushArguments const& arguments,
                                                 scene::ItemId& plant)
{
    auto const path = TRY(files::find_model(arguments.from));
    auto edits = TRY(batch::growing_plant_edits({ path, arguments.methods.edits },
                                                { .preset = "as drawn" }, arguments.seed));
    plant = TRY(batch::growing_plant(path, edits)).state.active;
    return edits;
}

Result<std::vector<scene::Edit>> edits_of(BrushArguments const& arguments)
{
    auto const habit = TRY(load_habit(arguments.habit));
    auto parts = TRY(parts_of(arguments));
    scene::ItemId plant = 1;
    std::vector<scene::Edit> edits;
    if (arguments.from.empty()) {
        edits.emplace_back(PlantTree { .habit = habit,
                                       .seed = arguments.seed,
                                       .scale = 1 / arguments.scale,
                                       .first = std::move(parts[0]),
                                       .id = plant });
    } else {
        edits = TRY(beginning_edits(arguments, plant));
        // Without --scale, the plant keeps the size at which the window shows it.
        if (arguments.is_scaled)
            edits.emplace_back(scene::SetScale { 1 / arguments.scale });
        edits.emplace_back(GrowFrom {
            .plant = plant, .habit = habit, .seed = arguments.seed, .next = std::move(parts[0]) });
    }
    for (std::size_t i = 1; i < parts.size(); ++i)
        edits.emplace_back(GrowOn { plant, std::move(parts[i]) });
    return edits;
}

// Counts the edits that grow a tree along a stroke.
std::size_t brushed_count(std::vector<scene::Edit> const& edits)
{
    auto const is_brushed = [](scene::Edit const& edit) {
        if (auto const* const planted = edit.get<PlantTree>())
            return !planted->first.stroke.tips.empty();
        if (auto const* const from = edit.get<GrowFrom>())
            return !from->next.stroke.tips.empty();
        auto const* const on = edit.get<GrowOn>();
        return on && !on->next.stroke.tips.empty();
    };
    return static_cast<std::size_t>(std::count_if(edits.begin(), edits.end(), is_brushed));
}

Result<void> brush(BrushArguments const& arguments)
{
    if (!arguments.example.empty())
        return report_case(arguments);
    bool const has_input = !arguments.strokes.empty() || !arguments.from.empty();
    if (!has_input || arguments.output.empty())
        return fail(Fault::User,
                    "give the strokes of the brush and, with -o FILE, the file to write");
    TRY(check_writable(arguments.output));
    auto const edits = TRY(edits_of(arguments));
    auto const scene = TRY(scene::apply_edits({}, edits, document::make_load_options()));
    auto const input = arguments.strokes.empty() ? fs::path(arguments.from) : arguments.strokes;
    auto const name = input.stem().string();
    std::string note;
    if (batch::is_session_file(arguments.output))
        TRY(batch::begin_session(arguments.output, edits, arguments.methods.edits));
    else
        note = TRY(batch::write_plant_file(*scene.base, name, arguments.output, arguments.file))
                   .sentence();
    return terminal::print_out(fmt::format(
        "{}: {} strokes, {} internodes, {} leaves{}\n", arguments.output.string(),
        brushed_count(edits), scene.base->segment_count(), scene.base->organs.size(), note));
}

void add_brush_options(CLI::App& command, BrushArguments& arguments)
{
    command
        .add_option("--from", arguments.from,
                    "In place of a seed, the plant from which the tree grows as it stands: a "
                    "model, a measured tree, a session; without strokes it grows by itself")
        ->type_name("PLANT");
    command
        .add_option("--habit", arguments.habit,
                    "The species: one of ours by its English or Latin name, or a .habit file")
        ->type_name("HABIT|FILE")
        ->check(options::suggest(self_organising::habit_names()))
        ->capture_default_str();
    command
        .add_option("--years", arguments.years, "How many years the tree grows along all strokes")
        ->type_name("N")
        ->check(options::whole_number(1, kMaxYears))
        ->capture_default_str();
    command.add_option("--seed", arguments.seed, "Another seed, another tree in the same volume")
        ->type_name("N")
        ->check(options::seed_number())
        ->capture_default_str();
    command
        .add_option("--radius", arguments.radius,
                    "The brush's radius in millimetres of the strokes, from no pressure to full")
        ->type_name("MM..MM")
        ->check(options::number_range(0.1, 1000))
        ->capture_default_str();
    command
        .add_option("--scale", arguments.scale,
                    "How many times larger the tree is than the strokes; without it, 10, or as the "
                    "window shows the plant of --from")
        ->type_name("X")
        ->check(options::number(0.01, 10'000));
    command.add_flag("--waits", arguments.waits,
                     "Only what is in the brush grows; without it, wherever it has been");
    options::add_height_option(command, arguments.height);
}

} // namespace

void add_brush_command(CLI::App& root, options::Action& action, tools::Methods const& methods)
{
    auto arguments = std::make_shared<BrushArguments>();
    arguments->methods = methods;
    auto* const command
        = root.add_subcommand("brush", "Grow a tree into the volume that a brush sweeps");
    command
        ->add_option(
            "STROKES", arguments->strokes,
            "A file of strokes (.txt with x y z in mm on each line, .tilt), or a recording")
        ->type_name("STROKES");
    add_brush_options(*command, *arguments);
    auto endings = batch::plant_endings();
    endings.emplace_back(".tractus");
    command
        ->add_option("-o,--output", arguments->output,
                     "What to write, as its ending says: " + batch::listed(endings)
                         + " (a session)")
        ->type_name("FILE")
        ->check(options::name_ending_in(endings));
    options::add_picture_size_option(*command, arguments->file.picture);
    options::add_glb_options(*command, arguments->file.glb);
    auto* const example
        = command
              ->add_option("--case", arguments->example,
                           "In place of strokes: an example of the laws alone, a JSON file")
              ->type_name("CASE")
              ->excludes("STROKES");
    command
        ->add_flag("--report", arguments->report,
                   "Print as JSON what each step of the example did, and its nodes")
        ->needs(example);
    command->footer(
        "The brush is a ball about the pen's tip, as wide as the pen is pressed. Where it comes "
        "it\n"
        "sows markers of free space, for which the tree's buds compete (Runions and others 2007,\n"
        "Longay and others 2012). The first stroke plants a tree, the others lead it on.");
    options::add_examples(*command,
                          { "brush hand.tractus-log --habit willow --years 6 -o willow.png",
                            "brush --from daisy --years 3 -o overgrown.glb" });
    command->callback([arguments, command, &action] {
        arguments->is_scaled = command->count("--scale") > 0;
        action = [arguments] { return brush(*arguments); };
    });
}

} // namespace tractus::self_organising
