#include "app/methods/silhouettes/commands/silhouette_command.h"

#include "app/batch/plant_file.h"
#include "app/batch/session_plant.h"
#include "app/files/resources.h"
#include "app/io/model_file.h"
#include "app/methods/silhouettes/silhouette_file.h"
#include "app/methods/silhouettes/silhouette_lines.h"
#include "app/methods/silhouettes/silhouette_report.h"
#include "app/options/checks.h"
#include "app/options/examples.h"
#include "app/options/glb_options.h"
#include "app/options/picture_options.h"
#include "app/terminal/console.h"
#include "app/terminal/error_text.h"
#include "engine/base/file.h"
#include "engine/methods/silhouettes/measured_style.h"
#include "engine/methods/silhouettes/tree_edits.h"
#include "engine/methods/silhouettes/tree_preset.h"
#include "engine/scene/scene.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tractus::silhouette {

namespace {

namespace fs = std::filesystem;

constexpr int kMaxLevels = 3;
constexpr std::size_t kMaxPlaces = 2000;

struct SilhouetteArguments {
    std::vector<fs::path> drawings;
    fs::path output;
    silhouette::TreeForm form; // Form given by the options, without `patterns`.
    // Patterns of branches for the levels from the trunk on. The last one applies to all further
    // levels.
    std::vector<std::string> patterns;
    std::optional<int> whorl; // Number of branches in each whorl.
    // Number of the trunk's branches that are in the plane of the drawing.
    std::optional<int> branches;
    std::string style; // File of a plant whose style is measured and then used for the tree.
    // The parsed command, which knows the options that were given.
    CLI::App const* command = nullptr;
    double height_m = 8;
    // Number of places in an arrangement. If given, only an arrangement is computed.
    std::optional<std::size_t> count;
    // Which other branches take the style of a branch on which parts are drawn.
    silhouette::StyleScope style_to = silhouette::StyleScope::None;
    bool report = false;
    bool session = false;
    tools::Methods methods;
    batch::PlantFileOptions file;
};

// The form given by the options, with a pattern for each level. The last pattern applies to all
// further levels.
silhouette::TreeForm form_of(SilhouetteArguments const& arguments)
{
    auto form = arguments.form;
    form.has_whole_nodes = true;
    if (arguments.branches)
        form.plane_branches = *arguments.branches;
    else if (form.plane_branches == 0)
        form.plane_branches = silhouette::kUsualPlaneBranches;
    // Without branches in the plane the tree is filled as the paper says, and not further.
    form.leaves_reach_outline = form.plane_branches > 0 && silhouette::fills_outline(form);
    if (form.plane_branches == 0)
        form.base_angle_deg = 0, form.tip_angle_deg = 0, form.rise = 0;
    form.bases_by_angle = form.base_angle_deg > 0 || form.tip_angle_deg > 0 || form.rise != 0;
    std::vector<silhouette::Pattern> given;
    for (auto const& word : arguments.patterns)
        // The check one_of() of the option has made sure that the pattern exists.
        given.push_back(*silhouette::pattern_of(word));
    for (std::size_t level = 0; level < form.patterns.size() && !given.empty(); ++level)
        form.patterns[level] = given[std::min(level, given.size() - 1)];
    for (auto& pattern : form.patterns)
        if (arguments.whorl && pattern == Pattern::Whorls)
            pattern.whorl = *arguments.whorl;
    return form;
}

// Fails with a user error if --whorl is given although no level has whorls.
Result<void> check_whorl(SilhouetteArguments const& arguments)
{
    auto const patterns = form_of(arguments).patterns;
    bool const has_whorls
        = std::any_of(patterns.begin(), patterns.end(),
                      [](Pattern const& pattern) { return pattern == Pattern::Whorls; });
    if (arguments.whorl && !has_whorls)
        return fail(Fault::User,
                    "--whorl says how many branches a whorl has, and there are none: give "
                    "--arrangement whorls, too");
    return {};
}

constexpr std::array kAngleOptions { "--base-angle", "--tip-angle", "--rise" };

// Fails with a user error if --branches 0, which makes trees as the paper describes them, is given
// together with an option for the angles of branches.
Result<void> check_angles(SilhouetteArguments const& arguments)
{
    for (auto const* const option : kAngleOptions)
        if (arguments.branches == 0 && arguments.command->count(option) > 0)
            return fail(
                Fault::User,
                fmt::format("{} is of no use with --branches 0: leave one of them away", option));
    return {};
}

// The plant whose style is measured. If the file is a session, the plant that the session shows.
Result<Plant> plant_of_style(SilhouetteArguments const& arguments)
{
    if (batch::is_session_file(arguments.style))
        return batch::shown_plant(
            TRY(batch::load_session_scene(arguments.style, arguments.methods.edits)));
    auto const path = TRY(files::find_model(arguments.style));
    auto const edit = TRY(io::load_plant_edit(path));
    auto const scene = TRY(scene::apply_edit({}, edit));
    for (auto const& warning : scene.model_warnings)
        terminal::print_warning(warning);
    return *scene.base;
}

Result<silhouette::MeasuredStyle> measured_style(SilhouetteArguments const& arguments)
{
    auto style = silhouette::measure_style(TRY(plant_of_style(arguments)));
    if (!style)
        return fail(style.error().fault,
                    fmt::format("{}: {}", arguments.style, style.error().message));
    return style;
}

// The form measured on the style's plant. Options given on the command line override it.
silhouette::TreeForm styled_form(SilhouetteArguments const& arguments,
                                 silhouette::MeasuredStyle const& style)
{
    auto const& given = arguments.form;
    auto form = silhouette::form_of(style);
    auto const is_given = [&](char const* option) { return arguments.command->count(option) > 0; };
    if (is_given("--levels"))
        form.levels = given.levels;
    if (is_given("--leaves"))
        form.leaves = given.leaves;
    if (is_given("--leaf-width"))
        form.leaf_width = given.leaf_width;
    form.density = given.density;
    form.seed = given.seed;
    form.base_angle_deg = given.base_angle_deg;
    form.tip_angle_deg = given.tip_angle_deg;
    form.rise = given.rise;
    form.bark = given.bark;
    return form;
}

tl::unexpected<Error> about_drawing(fs::path const& file, Error const& error)
{
    return fail(error.fault, fmt::format("{}: {}", file.string(), error.message));
}

// Writes the tree to the requested files and returns the files' names.
Result<std::string> write_tree(SilhouetteArguments const& arguments, fs::path const& drawing,
                               Plant const& plant)
{
    auto const name = drawing.stem().string();
    if (batch::is_plant_file(arguments.output)) {
        TRY(batch::write_plant_file(plant, name, arguments.output, arguments.file));
        return arguments.output.string();
    }
    auto const base = arguments.output / name;
    for (auto const* const ending : { ".png", ".glb" })
        TRY(batch::write_plant_file(plant, name, fs::path(base).concat(ending), arguments.file));
    return base.string() + ".png, .glb";
}

Result<std::string> write_session(SilhouetteArguments const& arguments, fs::path const& file,
                                  silhouette::SilhouetteFile const& drawing,
                                  silhouette::Skeleton const& skeleton)
{
    double const scale = silhouette::drawn_height(skeleton) / (1000 * arguments.height_m);
    silhouette::DrawTree const first { .form = form_of(arguments), .scale = scale };
    auto edits = silhouette::edits_of_lines(drawing, first, arguments.style_to);
    if (!edits)
        return about_drawing(file, edits.error());
    auto path = arguments.output / file.stem();
    path += ".tractus";
    TRY(batch::begin_session(path, *std::move(edits), arguments.methods.edits));
    return path.filename().string();
}

Result<void> make_tree_of(SilhouetteArguments const& arguments, fs::path const& drawing,
                          std::optional<silhouette::MeasuredStyle> const& style)
{
    auto file = TRY(silhouette::load_silhouette(drawing));
    for (auto const& key : file.unknown_keys)
        terminal::print_warning(fmt::format("{}: \"{}\" is left out: nothing is called so",
                                            drawing.string(), key.substr(0, 40)));
    auto const form = form_of(arguments);
    auto const as_read = file;
    auto const skeleton
        = silhouette::infer_lines(file, silhouette::skeleton_options(form), arguments.style_to);
    if (!skeleton)
        return about_drawing(drawing, skeleton.error());
    for (auto const& note : skeleton->systems[0].notes)
        terminal::print_warning(fmt::format("{}: {}", drawing.string(), note));
    auto const tree = silhouette::make_tree(
        *skeleton, silhouette::tree_options(form, 1000 * arguments.height_m));
    std::string written;
    if (!arguments.output.empty())
        written = TRY(write_tree(arguments, drawing, tree.plant));
    if (arguments.session)
        written += ", " + TRY(write_session(arguments, drawing, as_read, *skeleton));
    if (arguments.report)
        return terminal::print_out(
            silhouette::print_report(*skeleton, tree, style, as_read.crown_lines));
    return terminal::print_out(
        fmt::format("{}: {} branches, {} leaves, {:.0f} % of the outline covered\n", written,
                    tree.plant.axes.size() - 1 + tree.sprays, tree.leaves,
                    100 * skeleton->systems[0].coverage_after));
}

Result<void> arrange_alone(SilhouetteArguments const& arguments)
{
    if (arguments.patterns.size() != 1 || !arguments.count)
        return fail(Fault::User,
                    "there is no drawing: give a file, or --arrangement and --count for an "
                    "arrangement alone");
    TRY(check_whorl(arguments));
    auto const pattern = form_of(arguments).patterns[0];
    auto const arrangement = silhouette::arrange(
        {}, { .pattern = pattern, .count = *arguments.count }, { .seed = arguments.form.seed });
    return terminal::print_out(
        silhouette::print_arrangement(arrangement, pattern, arguments.form.seed));
}

Result<void> make_trees(SilhouetteArguments arguments)
{
    if (arguments.drawings.empty())
        return arrange_alone(arguments);
    if (arguments.output.empty() && !arguments.report)
        return fail(Fault::User, "nothing is asked for: give --output, --report, or both");
    if (arguments.drawings.size() > 1 && batch::is_plant_file(arguments.output))
        return fail(
            Fault::User,
            fmt::format("{}: several trees need a folder to be in", arguments.output.string()));
    if (!arguments.output.empty())
        TRY(check_writable(batch::is_plant_file(arguments.output) ? arguments.output
                                                                  : arguments.output / "tree.glb"));
    if (arguments.session && (arguments.output.empty() || batch::is_plant_file(arguments.output)))
        return fail(Fault::User, "a session needs a folder to be in: give one as --output");
    std::optional<silhouette::MeasuredStyle> style;
    if (!arguments.style.empty()) {
        style = TRY(measured_style(arguments));
        arguments.form = styled_form(arguments, *style);
        TRY(silhouette::check_form(arguments.form));
    }
    TRY(check_whorl(arguments));
    TRY(check_angles(arguments));
    for (auto const& drawing : arguments.drawings)
        TRY(make_tree_of(arguments, drawing, style));
    return {};
}

// Adds the options for leaves, for the arrangement and for the number of branches.
void add_leaf_options(CLI::App& command, SilhouetteArguments& arguments)
{
    command.add_option("--leaves", arguments.form.leaves, "Leaves on each twig")
        ->type_name("N")
        ->capture_default_str()
        ->check(options::whole_number(1, 500));
    command
        .add_option("--leaf-width", arguments.form.leaf_width,
                    "Of a leaf, as a share of its length")
        ->type_name("SHARE")
        ->capture_default_str()
        ->check(options::number(0.01, 2));
}

void add_style_options(CLI::App& command, SilhouetteArguments& arguments)
{
    std::vector<std::string> forms;
    for (auto const& ready : silhouette::tree_presets())
        forms.emplace_back(ready.name);
    command
        .add_option_function<std::string>(
            "--form",
            [&form = arguments.form](std::string const& name) {
                for (auto const& ready : silhouette::tree_presets())
                    if (ready.name == name)
                        form = ready.form;
            },
            fmt::format(
                "How the tree's branches stand, at which angles, how many there are, and its "
                "leaves, but for what other options say: {}",
                fmt::join(forms, ", ")))
        ->type_name("NAME")
        ->check(options::one_of(forms));
    command
        .add_option("--style", arguments.style,
                    "Branches as they are measured on a plant, but for what other options say: one "
                    "of our models, or the file of a model, a session or a measured tree")
        ->type_name("PLANT")
        ->excludes(command.get_option("--form"));
    command
        .add_option_function<std::string>(
            "--style-to",
            [&style_to = arguments.style_to](std::string const& word) {
                style_to = word == "siblings" ? silhouette::StyleScope::Siblings
                    : word == "deeper"        ? silhouette::StyleScope::Deeper
                                              : silhouette::StyleScope::None;
            },
            "Whom the style of a branch with parts of the drawing goes to: siblings, the branches "
            "beside it, deeper, those and the ones below, or none")
        ->type_name("WHOM")
        ->default_str("none")
        ->check(options::one_of({ "siblings", "deeper", "none" }));
}

void add_form_options(CLI::App& command, SilhouetteArguments& arguments)
{
    command
        .add_option("--levels", arguments.form.levels,
                    "How often branches branch before twigs come")
        ->type_name("N")
        ->capture_default_str()
        ->check(options::whole_number(1, kMaxLevels));
    command
        .add_option("--arrangement", arguments.patterns,
                    "How branches stand around what bears them, for all levels or one after the "
                    "other: even, spiral, decussate, whorls, two-rows or horizontal")
        ->type_name("PATTERN,...")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(
            options::one_of({ "even", "spiral", "decussate", "whorls", "two-rows", "horizontal" }));
    command
        .add_option("--whorl", arguments.whorl,
                    "How many branches stand at a node where they stand in whorls; 3 without it")
        ->type_name("N")
        ->check(options::whole_number(kMinWhorl, kMaxWhorl));
    command
        .add_option(
            "--branches", arguments.branches,
            "Branches of the trunk in the drawing's plane where the outline has fewer bumps "
            "than that, as many as the form has without it; 0: branches in bumps, and in "
            "gaps until the crown is full, and no leaves added to fill the outline")
        ->type_name("N")
        ->check(options::whole_number(0, kMaxPlaneBranches));
    command
        .add_option("--density", arguments.form.density,
                    "Times as many branches as usual besides those in the drawing's plane")
        ->type_name("TIMES")
        ->capture_default_str()
        ->check(options::number(0, 10));
}

void add_bark_option(CLI::App& command, SilhouetteArguments& arguments)
{
    std::vector<std::string> const names(kBarkNames.begin(), kBarkNames.end());
    command
        .add_option_function<std::string>(
            "--bark",
            [&form = arguments.form](std::string const& name) {
                form.bark = bark_kind(name).value_or(BarkKind::Furrowed);
            },
            fmt::format("Bark of the trunk and its branches, which changes with their girth: {}",
                        fmt::join(names, ", ")))
        ->type_name("KIND")
        ->check(options::one_of(names));
}

void add_angle_options(CLI::App& command, SilhouetteArguments& arguments)
{
    command
        .add_option("--base-angle", arguments.form.base_angle_deg,
                    "Between the trunk and its lowest branches, where they leave it")
        ->type_name("DEGREES")
        ->check(options::number(kMinAngle_deg, kMaxAngle_deg));
    command
        .add_option("--tip-angle", arguments.form.tip_angle_deg,
                    "Between the trunk and its highest branches, where they leave it")
        ->type_name("DEGREES")
        ->check(options::number(kMinAngle_deg, kMaxAngle_deg));
    command
        .add_option("--rise", arguments.form.rise,
                    "How the trunk's branches turn on their way out: upwards, or below 0 down, "
                    "-2 to 2")
        ->type_name("NUMBER")
        ->check(options::number(-2, 2));
}

void add_options(CLI::App& command, SilhouetteArguments& arguments)
{
    command
        .add_option("DRAWING", arguments.drawings,
                    "JSON files of an outline and a trunk in millimetres, or SVG drawings (.svg)")
        ->type_name("DRAWING");
    command
        .add_option("-o,--output", arguments.output,
                    "The folder for pictures and glTF, made if it is not there; or the tree alone, "
                    "as the file's ending says: "
                        + batch::listed(batch::plant_endings()))
        ->type_name("OUTPUT");
    options::add_picture_size_option(command, arguments.file.picture);
    // These options are added before the form's options, which override a style.
    add_style_options(command, arguments);
    add_form_options(command, arguments);
    add_angle_options(command, arguments);
    add_bark_option(command, arguments);
    add_leaf_options(command, arguments);
    command.add_option("--height", arguments.height_m, "Of the whole tree, metres")
        ->type_name("METRES")
        ->capture_default_str()
        ->check(options::number(0.01, 200));
    command.add_option("--seed", arguments.form.seed, "Of what the drawing leaves open")
        ->type_name("N")
        ->capture_default_str()
        ->check(options::seed_number());
    command
        .add_option("--count", arguments.count,
                    "Without a drawing: prints an arrangement of so many branches as JSON")
        ->type_name("N")
        ->check(options::whole_number(1, kMaxPlaces));
    command.add_flag("--report", arguments.report,
                     "Print as JSON what was inferred from each drawing");
    command.add_flag("--session", arguments.session,
                     "Write a session, too, in which the tree is as if a pen had drawn it");
    options::add_glb_options(command, arguments.file.glb);
}

} // namespace

void add_silhouette_command(CLI::App& root, options::Action& action, tools::Methods const& methods)
{
    auto arguments = std::make_shared<SilhouetteArguments>();
    arguments->methods = methods;
    auto* const command = root.add_subcommand("silhouette", "Make a tree from its outline");
    arguments->command = command;
    add_options(*command, *arguments);
    command->footer(
        "A trunk and the outline of the crown around it make a tree (Wither, Boudon, Cani, Godin\n"
        "2009): a branch ends in each bump of the outline, others fill what is empty, and all are\n"
        "spread around the trunk. DRAWING is a JSON object of \"outline\": points [x,y] to the "
        "right\n"
        "and up, around the crown, or a list of such strokes; and \"trunk\": points, base first, "
        "which\n"
        "may be missing. \"parts\", strokes around parts of the crown, are outlines of single "
        "branches,\n"
        "or, from a branch on, branches of that branch. \"leaves\" are parts that are leaves. "
        "\"splits\" and\n"
        "\"joins\" are points on bumps of an outline, and between two, that make two of one, or "
        "one of two.\n"
        "\"styles\" are strokes from a branch over others, which branch as that one does. "
        "\"rings\",\n"
        "\"climbs\" and \"sides\" are lines in space on the crown's surface.");
    options::add_examples(*command,
                          { "silhouette crown.json -o tree.glb",
                            "silhouette --arrangement spiral --count 8 -o spirals" });
    command->callback(
        [arguments, &action] { action = [arguments] { return make_trees(*arguments); }; });
}

} // namespace tractus::silhouette
