#include "app/methods/sketch_lsystem/commands/sketch_command.h"

#include "app/batch/drawing.h"
#include "app/batch/plant_file.h"
#include "app/batch/session_plant.h"
#include "app/document/model_cost.h"
#include "app/files/resources.h"
#include "app/io/model_file.h"
#include "app/io/stroke_file.h"
#include "app/methods/sketch_lsystem/commands/model_rule_file.h"
#include "app/methods/sketch_lsystem/commands/twig_file.h"
#include "app/methods/sketch_lsystem/rule_file.h"
#include "app/methods/sketch_lsystem/sketch_options.h"
#include "app/methods/sketch_lsystem/sketch_report.h"
#include "app/methods/sketch_lsystem/sketch_tool.h"
#include "app/options/checks.h"
#include "app/options/examples.h"
#include "app/options/picture_options.h"
#include "app/options/shared_options.h"
#include "app/terminal/console.h"
#include "app/terminal/error_text.h"
#include "app/tools/tool_cards.h"
#include "engine/base/file.h"
#include "engine/lsystem/view/leaf_sheet.h"
#include "engine/methods/sketch_lsystem/drawn_axis.h"
#include "engine/methods/sketch_lsystem/grow_edit.h"
#include "engine/methods/sketch_lsystem/stroke_resampler.h"
#include "engine/scene/scene.h"
#include "engine/stroke/foot_first.h"
#include "engine/stroke/upright_sheet.h"

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fmt/format.h>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace tractus::sketch {

namespace {

namespace fs = std::filesystem;

struct SketchArguments {
    tools::Methods methods;
    fs::path stroke;
    // File of a drawn twig, from which the rule is inferred; used instead of `stroke` and `rule`.
    fs::path twig;
    fs::path rule;
    fs::path folder;
    render::PictureSize picture;
    std::size_t number = 1; // Number of the stroke in its file, from 1.
    std::string surface;    // Surface on which the stroke was drawn; empty: surface_for() decides.
    // Where the plant stands: at the stroke's "foot", "begin" or "end".
    std::string stands = "foot";
    std::string height;     // Heights for a recording that has no height sensor.
    std::uint64_t seed = 1; // Random seed of a model.
    bool bare = false;
    bool report = false;
    bool session = false;
};

Result<Stroke> choose_stroke(SketchArguments const& arguments)
{
    batch::DrawingOptions options { .log = arguments.stroke, .methods = arguments.methods };
    if (!arguments.height.empty())
        options.height = arguments.height;
    auto const strokes = TRY(batch::drawn_strokes(options));
    if (arguments.number <= strokes.size())
        return strokes[arguments.number - 1];
    return fail(Fault::User,
                fmt::format("{}: it has no stroke {}, its last is {}", arguments.stroke.string(),
                            arguments.number, strokes.size()));
}

// The surface on which the stroke was drawn, as the user named it. If it is not named: space for a
// file of strokes; for a log, it is inferred from the pen's path.
StrokeSurface surface_for(SketchArguments const& arguments)
{
    if (arguments.surface.empty())
        return io::is_stroke_file(arguments.stroke) ? StrokeSurface::Space : StrokeSurface::Decided;
    return arguments.surface == "space" ? StrokeSurface::Space : StrokeSurface::Paper;
}

// The stroke, beginning at the plant's foot, and whether it was reversed for that.
struct FootFirst {
    Stroke stroke;
    StrokeSurface surface;
    bool is_drawn_reversed;
};
Result<FootFirst> stroke_from_foot(SketchArguments const& arguments)
{
    auto stroke = TRY(choose_stroke(arguments));
    auto const surface = resolve_surface(stroke.tips, surface_for(arguments));
    bool const is_drawn_reversed = arguments.stands == "end"
        || (arguments.stands == "foot"
            && is_drawn_to_foot(plant_tips(stroke.tips.vector(), surface), {}));
    if (is_drawn_reversed)
        stroke = turned_round(stroke);
    return FootFirst { std::move(stroke), surface, is_drawn_reversed };
}

void warn_of_turn(SketchArguments const& arguments, bool is_drawn_reversed)
{
    if (is_drawn_reversed && arguments.stands == "foot")
        terminal::print_warning(
            fmt::format("{}: the stroke runs from the tip to the foot and is turned round: "
                        "\"--stands begin\" leaves it as drawn",
                        arguments.stroke.string()));
}

Result<sketch::DrawnAxis> draw_axis(SketchArguments const& arguments, sketch::Rule const& rule)
{
    auto const [stroke, surface, is_drawn_reversed] = TRY(stroke_from_foot(arguments));
    auto const& tips = stroke.tips.vector();
    warn_of_turn(arguments, is_drawn_reversed);
    auto const nodes_mm = sketch::resample_stroke(rule, plant_tips(tips, surface));
    if (nodes_mm.size() < 2)
        return fail(
            Fault::User,
            fmt::format("{}: the stroke never gets {:g} mm away from where it begins, so the "
                        "rule is not applied once: draw a longer one, or give a rule with a "
                        "shorter first internode, l",
                        arguments.stroke.string(), rule.first_length_mm));
    return sketch::draw_axis(rule, nodes_mm);
}

bool names_card(SketchArguments const& arguments)
{
    return arguments.rule.extension() == ".card";
}

// Reads a preset of the tool that was saved in the window.
Result<SketchTool> read_card(SketchArguments const& arguments)
{
    constexpr std::size_t kMaxBytes = 4096;
    auto const text = TRY(read_text_file(arguments.rule, kMaxBytes));
    auto const card
        = TRY(tools::parse_card(arguments.methods.tools, text, arguments.rule.string()));
    if (auto const* const tool = card.get<SketchTool>())
        return *tool;
    return fail(
        Fault::User,
        fmt::format("{}: it is a card of another tool, and no rule", arguments.rule.string()));
}

Result<sketch::Rule> read_rule(SketchArguments const& arguments)
{
    if (arguments.rule.empty())
        return sketch::parse_rule("", "the usual rule");
    if (names_card(arguments))
        return rule_of(TRY(read_card(arguments)));
    return sketch::load_rule(arguments.rule);
}

// The model to grow; not set if the plant grows by a rule.
Result<sketch::ModelRule> read_model(SketchArguments const& arguments)
{
    sketch::ModelRule model;
    if (names_model(arguments.rule))
        model = TRY(load_model_rule(arguments.rule));
    else if (names_card(arguments))
        model = model_of(TRY(read_card(arguments)));
    model.seed = arguments.seed;
    return model;
}

Result<void> write_model_files(fs::path const& base, lsystem::ModelSource const& model)
{
    TRY(write_file(fs::path(base).concat(".l"), model.text));
    return write_file(fs::path(base).concat(".v"), model.view_text);
}

void warn_of_cut(sketch::Rule const& rule, sketch::DrawnAxis const& axis)
{
    if (axis.depth < sketch::kUncutDepth)
        terminal::print_warning(
            fmt::format("laterals fork at most {} times, so that the plant stays within {:g} "
                        "internodes; \"limit\" in the rule allows more",
                        axis.depth, rule.most_internodes));
}

// The edit that a pen in the window would have made. In a session with this edit, rule and stroke
// can be edited.
Result<sketch::GrowAlongStroke> drawn_edit(SketchArguments const& arguments,
                                           sketch::Rule const& rule)
{
    auto [stroke, surface, is_drawn_reversed] = TRY(stroke_from_foot(arguments));
    return sketch::GrowAlongStroke {
        .rule = rule,
        .stroke = std::move(stroke),
        .surface = surface,
        .leaves = arguments.bare ? sketch::Leaves::Bare : sketch::Leaves::Leafy,
        .is_drawn_reversed = is_drawn_reversed,
    };
}

// Writes the plant's picture, its mesh and, if requested, its session. The model has been written
// before.
Result<void> write_plant(SketchArguments const& arguments, scene::Edit const& load,
                         fs::path const& base, Result<sketch::GrowAlongStroke> const& drawn,
                         int segments)
{
    auto const scene = TRY(scene::apply_edit({}, load, document::make_load_options()));
    auto const name = arguments.stroke.stem().string();
    for (auto const* const ending : { ".png", ".glb" })
        TRY(batch::write_plant_file(*scene.base, name, fs::path(base).concat(ending),
                                    { .picture = arguments.picture }));
    if (arguments.session) {
        auto const edit = TRY(Result<sketch::GrowAlongStroke>(drawn));
        TRY(batch::begin_session(fs::path(base).concat(".tractus"), { edit },
                                 arguments.methods.edits));
    }
    return terminal::print_out(
        fmt::format("{0}.l, .v, .png, .glb{1}: {2} segments drawn, {3} internodes, {4} "
                    "leaves\n",
                    base.string(), arguments.session ? ", .tractus" : "", segments,
                    scene.base->segment_count(), scene.base->organs.size()));
}

Result<void> sketch_rule(SketchArguments const& arguments)
{
    auto const rule = TRY(read_rule(arguments));
    auto const axis = TRY(draw_axis(arguments, rule));
    auto const name = arguments.stroke.stem().string();
    auto const base = arguments.folder / name;
    auto const leaves = arguments.bare ? sketch::Leaves::Bare : sketch::Leaves::Leafy;
    auto const source = sketch::write_model(rule, axis, leaves, name);
    TRY(write_model_files(base, source));
    if (arguments.report) {
        auto const model = TRY(lsystem::compile_model(source));
        auto const report
            = TRY(sketch::print_report({ axis, sketch::nodes_of(axis, rule), axis.depth }, model));
        return terminal::print_out(report);
    }
    warn_of_cut(rule, axis);
    return write_plant(arguments, scene::LoadModel { .source = source }, base,
                       drawn_edit(arguments, rule), axis.segments());
}

// Writes the files that the model includes into its folder. Leaf sheets are left out, as they are
// grown again when the model is loaded.
Result<void> write_includes(fs::path const& folder, sketch::ModelRule const& model)
{
    for (auto const& [name, text] : model.includes)
        if (!lsystem::parse_leaf_sheet_name(name))
            TRY(write_file(folder / name, text));
    return {};
}

Result<void> sketch_model(SketchArguments const& arguments, sketch::ModelRule model)
{
    auto drawn = TRY(drawn_edit(arguments, {}));
    warn_of_turn(arguments, drawn.is_drawn_reversed);
    drawn.model = std::move(model);
    auto const nodes_mm = TRY(sketch::drawn_nodes_mm(drawn));
    auto const base = arguments.folder / arguments.stroke.stem();
    auto const source = TRY(sketch::model_of(drawn));
    TRY(write_model_files(base, source));
    TRY(write_includes(arguments.folder, drawn.model));
    auto axis = TRY(sketch::axis_along(drawn.model, nodes_mm, drawn.scale));
    if (!arguments.report)
        return write_plant(arguments, drawn, base, drawn, axis.axis.segments());
    auto const compiled = TRY(lsystem::compile_model(source, io::model_includes(base)));
    auto const report
        = TRY(sketch::print_report({ axis.axis, axis.nodes_mm, {} }, compiled, drawn.model.seed));
    return terminal::print_out(report);
}

void warn_of_misfit(SketchArguments const& arguments, sketch::TwigRule const& twig)
{
    if (!twig.is_rule())
        terminal::print_warning(fmt::format(
            "{}: no rule makes this twig: angles differ by {:.0f} degrees, lengths by {:.0f} %, "
            "places by {:.0f} % of an internode, turns by {:.0f} degrees from the nearest one",
            arguments.twig.string(), twig.angle_deviation_deg, 100 * twig.length_deviation,
            100 * twig.spacing_deviation, twig.twist_deviation_deg));
}

// Writes the file of the rule, and the plant that the rule grows along the axis of the twig.
Result<void> grow_twig(SketchArguments arguments, sketch::DrawnTwig const& twig,
                       sketch::Rule const& rule)
{
    TRY(check_writable(arguments.folder / "model.l"));
    arguments.stroke = arguments.twig;
    auto const name = arguments.twig.stem().string();
    auto const base = arguments.folder / name;
    auto const nodes_mm = sketch::resample_stroke(rule, twig.axis_mm);
    if (nodes_mm.size() < 2)
        return fail(Fault::User,
                    fmt::format("{}: the axis ends below the first node: draw it to its tip",
                                arguments.twig.string()));
    auto const axis = sketch::draw_axis(rule, nodes_mm);
    auto const leaves = arguments.bare ? sketch::Leaves::Bare : sketch::Leaves::Leafy;
    auto const source = sketch::write_model(rule, axis, leaves, name);
    TRY(write_file(fs::path(base).concat(".toml"), print_rule_file(rule)));
    TRY(write_model_files(base, source));
    if (arguments.report)
        return {};
    sketch::GrowAlongStroke drawn { .rule = rule,
                                    .surface = StrokeSurface::Space,
                                    .leaves = leaves };
    for (auto const& point : twig.axis_mm)
        drawn.stroke.tips.push_back({ .position_mm = point, .touching = true });
    return write_plant(arguments, scene::LoadModel { .source = source }, base, drawn,
                       axis.segments());
}

Result<void> sketch_from_twig(SketchArguments const& arguments)
{
    auto const twig = TRY(load_twig(arguments.twig));
    auto const found = sketch::find_twig_rule(twig);
    if (!found)
        return fail(found.error().fault,
                    fmt::format("{}: {}", arguments.twig.string(), found.error().message));
    warn_of_misfit(arguments, *found);
    if (!arguments.folder.empty())
        TRY(grow_twig(arguments, twig, found->rule));
    if (arguments.report)
        return terminal::print_out(print_twig_report(*found));
    return terminal::print_out(print_rule_file(found->rule));
}

Result<void> sketch_plant(SketchArguments const& arguments)
{
    if (!arguments.twig.empty())
        return sketch_from_twig(arguments);
    TRY(check_writable(arguments.folder / "model.l"));
    auto model = TRY(read_model(arguments));
    return model.is_set() ? sketch_model(arguments, std::move(model)) : sketch_rule(arguments);
}

// Adds the options that choose the stroke, and where on the stroke the plant stands.
void add_stroke_options(CLI::App& command, SketchArguments& arguments)
{
    command.add_option("--stroke", arguments.number, "Which of the strokes in the file")
        ->type_name("N")
        ->check(options::whole_number(1, 1'000'000))
        ->capture_default_str();
    command
        .add_option(
            "--surface", arguments.surface,
            "Whether the stroke was drawn in \"space\", or on \"paper\" that stands upright; "
            "without it a recording is on paper if its surface hardly moved")
        ->type_name("SURFACE")
        ->check(options::one_of({ "space", "paper" }));
    command
        .add_option(
            "--stands", arguments.stands,
            "Where the plant stands: where the stroke begins (\"begin\") or ends (\"end\"), "
            "or at its foot (\"foot\"), so that one that runs down is turned round")
        ->type_name("WHERE")
        ->check(options::one_of({ "foot", "begin", "end" }))
        ->capture_default_str();
}

void add_options(CLI::App& command, SketchArguments& arguments)
{
    auto* const stroke
        = command
              .add_option(
                  "STROKE", arguments.stroke,
                  "A file of strokes (.txt with x y z in mm on each line, .tilt), or a recording")
              ->type_name("STROKE")
              ->required();
    command
        .add_option("--rule", arguments.rule,
                    "The rule, a small TOML file or a card (.card) from the window, or a model, an "
                    "L-system file (.l) or one of ours; without it the usual rule")
        ->type_name("RULE|FILE")
        ->check(options::suggest(files::model_names()));
    auto* const output
        = command
              .add_option("-o,--output", arguments.folder,
                          "The folder for the plant's files; made if it is not there")
              ->type_name("FOLDER")
              ->required();
    options::add_picture_size_option(command, arguments.picture);
    command
        .add_option(
            "--from-twig", arguments.twig,
            "In place of a stroke and a rule a twig, {\"axis\": [[x, y], ...], \"laterals\": "
            "[[[x, y], ...], ...]} in mm: finds the rule that makes it, and grows it along "
            "the axis if there is an output")
        ->type_name("FILE")
        ->each([stroke, output](std::string const&) {
            stroke->required(false);
            output->required(false);
        });
    add_stroke_options(command, arguments);
    options::add_height_option(command, arguments.height);
    command
        .add_option("--seed", arguments.seed,
                    "Of a model's chance: another seed, other laterals along the same axis")
        ->type_name("N")
        ->check(options::whole_number(0, std::numeric_limits<std::int64_t>::max()))
        ->capture_default_str();
    command.add_flag("--bare", arguments.bare, "Without leaves; a model has its own");
    command.add_flag("--session", arguments.session, "Also begin a session with the plant");
    command.add_flag(
        "--report", arguments.report,
        "Write the model alone, and print as JSON what the stroke and the rule amount to");
}

} // namespace

void add_sketch_command(CLI::App& root, options::Action& action, tools::Methods const& methods)
{
    auto arguments = std::make_shared<SketchArguments>();
    arguments->methods = methods;
    auto* const command = root.add_subcommand("sketch", "Grow a rule along a drawn stroke");
    add_options(*command, *arguments);
    command->footer(
        "A Sketch L-system (Ijiri, Owada, Igarashi 2006): the stroke becomes the main axis, and "
        "each\n"
        "time it gets an internode longer the rule is applied, so a longer stroke is an older "
        "plant.\n"
        "A rule file has, each on a line, what differs from the usual: k laterals at a node (2), l "
        "mm\n"
        "the first internode's length (30), r and q each internode's length and width by the one\n"
        "before it (0.9, 0.85), w mm the first one's diameter (0.15 l), a degrees between a "
        "lateral\n"
        "and its parent (45), s and v its length and width by its parent's (0.62, 0.55), T and t\n"
        "degrees of twist from node to node along the stroke and along laterals (180/k), l_min mm "
        "the\n"
        "shortest internode (1), n_max the most segments of the stroke (64), limit the most "
        "internodes\n"
        "of the plant (200000).\n"
        "A model can be grown so whose text has the places for a stroke: birch, broadleaf, "
        "conifer,\n"
        "frond, palm, poplar and vine have them, and \"tractus lsystem check\" says what another "
        "lacks.");
    options::add_examples(*command,
                          { "sketch hand.tractus-log -o twig",
                            "sketch hand.tractus-log --rule frond --surface paper -o frond" });
    command->callback(
        [arguments, &action] { action = [arguments] { return sketch_plant(*arguments); }; });
}

} // namespace tractus::sketch
