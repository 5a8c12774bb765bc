#include "app/methods/leaves/commands/sketched_leaf.h"

#include "app/batch/drawing.h"
#include "app/methods/leaves/leaf_sketch_file.h"
#include "app/options/checks.h"
#include "app/options/examples.h"
#include "app/options/shared_options.h"
#include "app/terminal/console.h"
#include "app/terminal/error_text.h"
#include "engine/base/file.h"
#include "engine/methods/leaves/drawn_leaf.h"
#include "engine/methods/leaves/print_grammar.h"

#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

namespace tractus::leaf {

namespace {

using Json = nlohmann::ordered_json;

struct SketchedLeaf {
    std::filesystem::path sketch;
    std::filesystem::path output;
    bool reports = false;
    std::string height;        // Heights for a recording that has no height sensor.
    tools::Methods methods {}; // Methods whose tools a recording may use.
};

double to_places(double value, double parts)
{
    return std::round(value * parts) / parts;
}

Json drawn_and_fitted(double drawn, double fitted, double parts)
{
    return { { "drawn", to_places(drawn, parts) }, { "fitted", to_places(fitted, parts) } };
}

// A vein as JSON. The numbers of strokes begin with 1.
Json vein_json(leaf::LeafFit::Vein const& vein, leaf::RecognisedLeaf const& seen)
{
    Json made { { "stroke", vein.stroke + 1 }, { "role", leaf::name_of(seen.roles[vein.stroke]) } };
    if (vein.parent != vein.stroke) {
        made["on"] = vein.parent + 1;
        made["at"] = drawn_and_fitted(vein.drawn_at, vein.fitted_at, 1e3);
    }
    made["angle_deg"] = drawn_and_fitted(vein.drawn_angle_deg, vein.fitted_angle_deg, 10);
    made["length_mm"] = drawn_and_fitted(vein.drawn_length_mm, vein.fitted_length_mm, 10);
    return made;
}

Json report_json(leaf::LeafFit const& fit, leaf::RecognisedLeaf const& seen, double overlap)
{
    Json roles = Json::array();
    for (auto const role : seen.roles)
        roles.push_back(leaf::name_of(role));
    Json veins = Json::array();
    for (auto const& vein : fit.veins)
        veins.push_back(vein_json(vein, seen));
    return { { "strokes", roles },
             { "leaflets", seen.leaflets.size() },
             { "size_mm", fit.leaf.size_mm },
             { "outline_overlap", to_places(overlap, 1e4) },
             { "asymmetry", to_places(fit.asymmetry, 1e4) },
             { "tremor_mm", to_places(fit.tremor_mm, 1e3) },
             { "bend_deg", fit.leaf.bend_deg },
             { "rise_deg", fit.leaf.rise_deg },
             { "sweep_deg", to_places(fit.sweep_deg, 10) },
             { "veins", veins } };
}

// An error whose message begins with the name of the drawing's file.
tl::unexpected<Error> about_sketch(SketchedLeaf const& leaf, Error const& error)
{
    return fail(error.fault, fmt::format("{}: {}", leaf.sketch.string(), error.message));
}

// Loads a drawing. The file's extension decides in which format it is read.
Result<leaf::LeafDrawing> load_drawing(SketchedLeaf const& arguments)
{
    auto const ending = arguments.sketch.extension();
    if (ending == ".json" || ending == ".svg")
        return load_leaf_sketch(arguments.sketch);
    leaf::LeafDrawing drawing;
    batch::DrawingOptions options { .log = arguments.sketch, .methods = arguments.methods };
    if (!arguments.height.empty())
        options.height = arguments.height;
    for (auto const& stroke : TRY(batch::drawn_strokes(options))) {
        auto& points = drawing.strokes.emplace_back();
        for (auto const& tip : TRY(stroke.tips.in_memory()))
            points.push_back(tip.position_mm);
    }
    return drawing;
}

// Warns if the grammar's outline differs much from the drawn one. A grammar has a midrib from the
// base to the farthest point and two halves, whose outline leaves the midrib only once. So it
// cannot have every shape.
void warn_of_outline(SketchedLeaf const& leaf, double overlap)
{
    constexpr double kFaithful = 0.95;
    if (overlap < kFaithful)
        terminal::print_warning(fmt::format(
            "{}: the leaf's outline overlaps the drawn one by {:.0f} %, less than {:.0f} "
            "%: deep lobes, a stalk in the middle of the blade and leaflets of different shapes "
            "are not kept; look at the picture, or draw each leaflet as a leaf",
            leaf.sketch.string(), 100 * overlap, 100 * kFaithful));
}

Result<void> write_sketched_leaf(SketchedLeaf const& arguments)
{
    auto const drawing = TRY(load_drawing(arguments));
    auto const seen = leaf::recognise_leaf(drawing);
    if (!seen)
        return about_sketch(arguments, seen.error());
    auto const fit = leaf::fit_leaf(*seen);
    if (!fit)
        return about_sketch(arguments, fit.error());
    auto const title = fmt::format("Drawn by pen: {}", arguments.sketch.stem().string());
    TRY(write_file(arguments.output, leaf::print_grammar(fit->leaf, title)));
    auto const overlap = leaf::overlap_with_drawing(*seen, *fit);
    if (!overlap)
        return about_sketch(arguments, overlap.error());
    warn_of_outline(arguments, *overlap);
    if (arguments.reports)
        return terminal::print_out(report_json(*fit, *seen, *overlap).dump(2) + "\n");
    auto const leaflets = seen->leaflets.empty()
        ? std::string()
        : fmt::format("leaflets {}, the longest ", seen->leaflets.size());
    return terminal::print_out(fmt::format(
        "wrote {}: {}{} mm, veins {}, outline {:.1f} % as drawn\n", arguments.output.string(),
        leaflets, fit->leaf.size_mm, fit->veins.size(), 100 * *overlap));
}

} // namespace

void add_sketch_leaf_command(CLI::App& leaves, options::Action& action,
                             tools::Methods const& methods)
{
    auto arguments = std::make_shared<SketchedLeaf>();
    arguments->methods = methods;
    auto* const sketch
        = leaves.add_subcommand("fit", "Make a grammar of a leaf that was drawn by pen");
    sketch
        ->add_option("FILE", arguments->sketch,
                     "A drawing (.json, .svg), a recording of a pen (.tractus-log), or a file of "
                     "strokes (.txt, .strokes, .tilt)")
        ->type_name("FILE")
        ->required();
    sketch->add_option("-o,--output", arguments->output, "The grammar's file")
        ->type_name("FILE.leaf")
        ->check(options::name_ending_in({ ".leaf" }))
        ->required();
    sketch->add_flag("--report", arguments->reports,
                     "Print as JSON what each stroke is, and how near the grammar comes to it");
    options::add_height_option(*sketch, arguments->height);
    sketch->footer(
        "JSON is {\"strokes\": [[[x, y, z], ...], ...]}, in millimetres. The strokes are the\n"
        "outline, as one closed line, two halves or one half, the midrib, and veins on it or\n"
        "round its begin, in any order and direction. Several closed lines along another one are\n"
        "the leaflets of a compound leaf.");
    options::add_examples(
        *sketch,
        { "leaves fit leaf.json -o mine.leaf", "leaves fit leaf.json --report -o mine.leaf" });
    sketch->callback(
        [arguments, &action] { action = [arguments] { return write_sketched_leaf(*arguments); }; });
}

} // namespace tractus::leaf
