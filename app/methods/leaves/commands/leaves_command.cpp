#include "app/methods/leaves/commands/leaves_command.h"

#include "app/batch/plant_file.h"
#include "app/methods/leaves/commands/atlas_command.h"
#include "app/methods/leaves/commands/paint_command.h"
#include "app/methods/leaves/commands/sketched_leaf.h"
#include "app/methods/leaves/leaf_library.h"
#include "app/methods/leaves/leaf_mesh.h"
#include "app/options/checks.h"
#include "app/options/examples.h"
#include "app/options/picture_options.h"
#include "app/terminal/console.h"
#include "engine/base/file.h"
#include "engine/methods/leaves/leaf.h"
#include "engine/methods/leaves/leaf_grammar.h"

#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

namespace tractus::leaf {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int kMaxSteps = 1000;

struct LeavesArguments {
    fs::path grammar;
    std::optional<int> steps;
    std::optional<int> final_step;
    std::optional<double> age;
    std::uint64_t seed = 1;
    fs::path output;
    render::PictureSize picture;
    double size_mm = 100;
    std::optional<int> paint; // Side of the painted pictures in pixels; no value: not painted.
};

Result<leaf::Grammar> load_grammar(fs::path const& path)
{
    return load_leaf_grammar(path.string());
}

Json counts_json(leaf::MapCounts const& counts)
{
    return {
        { "faces", counts.faces },
        { "edges", counts.edges },
        { "vertices", counts.vertices },
        { "darts", counts.darts },
        { "chi", counts.euler_characteristic() },
        { "components", counts.components },
        { "border_edges", counts.border_edges },
        { "border_cycles", counts.border_cycles },
        { "triangles", counts.triangles },
    };
}

Json labels_json(leaf::Leaf const& leaf)
{
    Json labels = Json::object();
    for (auto const& [face, count] : leaf.face_counts())
        labels[std::string(1, face)] = count;
    return labels;
}

// The variables of a leaf as JSON. Numbers have nine decimals; numbers that are not finite become
// null.
Json variables_json(leaf::Grammar const& grammar, leaf::Leaf const& leaf)
{
    Json variables = Json::object();
    for (auto const& [name, first_value] : grammar.variables) {
        double const value = leaf.variable(name);
        double const rounded = std::round(value * 1e9) / 1e9;
        variables[grammar.names.name(name)] = std::isfinite(rounded) ? rounded : value;
    }
    return variables;
}

// The result of a step as JSON: counts for the veins alone, then the blade's faces, then counts for
// veins and blade together.
Result<Json> step_json(leaf::Grammar const& grammar, leaf::Leaf& leaf)
{
    Json step {
        { "step", leaf.step() },
        { "veins", counts_json(leaf.map().counts()) },
        { "labels", labels_json(leaf) },
        { "free_extremities", leaf.free_extremities() },
        { "variables", variables_json(grammar, leaf) },
    };
    TRY(leaf.fill());
    auto const& limb = leaf.limb();
    step["limb"]
        = { { "faces", limb.sizes.size() }, { "sizes", limb.sizes }, { "cuts", limb.cuts } };
    step["with_limb"] = counts_json(leaf.map().counts());
    return step;
}

double usual_age(LeavesArguments const& arguments)
{
    constexpr double kAdult = 0.5;
    return arguments.age.value_or(kAdult);
}

leaf::Leaf::Options leaf_options(LeavesArguments const& arguments)
{
    return { .final_step = arguments.final_step.value_or(arguments.steps.value_or(0)),
             .age = arguments.age.value_or(1),
             .seed = arguments.seed };
}

Result<void> count_cells(LeavesArguments const& arguments)
{
    auto const grammar = TRY(load_grammar(arguments.grammar));
    auto leaf = TRY(leaf::Leaf::begin(grammar, leaf_options(arguments)));
    Json steps = Json::array();
    steps.push_back(TRY(step_json(grammar, leaf)));
    while (leaf.step() < arguments.steps.value_or(0)) {
        TRY(leaf.derive());
        steps.push_back(TRY(step_json(grammar, leaf)));
    }
    return terminal::print_out(Json { { "steps", steps } }.dump() + "\n");
}

Result<void> check_grammar(LeavesArguments const& arguments)
{
    auto const grammar = TRY(load_grammar(arguments.grammar));
    TRY(leaf::Leaf::begin(grammar, {}));
    return terminal::print_out(fmt::format("{}: understood: faces {}, rules {}, variables {}\n",
                                           grammar.name, grammar.faces.size(), grammar.rules.size(),
                                           grammar.variables.size()));
}

// Grows the leaf by the number of steps given on the command line, if any, otherwise to the age
// given there (default: that of an adult leaf).
Result<GrownLeaf> leaf_to_draw(leaf::Grammar const& grammar, LeavesArguments const& arguments)
{
    if (!arguments.steps)
        return grow_leaf(grammar, { .age = usual_age(arguments), .seed = arguments.seed });
    auto leaf = TRY(leaf::Leaf::begin(grammar, leaf_options(arguments)));
    while (leaf.step() < *arguments.steps)
        TRY(leaf.derive());
    TRY(leaf.fill());
    auto triangles = leaf::triangles_of(leaf);
    return GrownLeaf { std::move(leaf), std::move(triangles) };
}

Result<mesh::Mesh> mesh_to_draw(leaf::Grammar const& grammar, GrownLeaf const& grown,
                                LeavesArguments const& arguments)
{
    if (!arguments.paint) {
        auto mesh = TRY(leaf_mesh(grown.triangles, arguments.size_mm));
        if (!arguments.steps && mesh.materials.size() > 1) {
            double const share = color_age(usual_age(arguments));
            mesh.materials[1].base_color
                = (grammar.young + share * (grammar.old - grammar.young)).cast<float>();
        }
        return mesh;
    }
    if (arguments.output.extension() == ".png")
        return fail(Fault::User,
                    "a .png of a leaf in space shows no painting: write .glb or .obj, or use "
                    "\"tractus leaves paint\", which paints the flat leaf");
    auto options = paint_options(grammar, { .age = usual_age(arguments), .seed = arguments.seed });
    options.side = *arguments.paint;
    auto const picture = leaf::paint_leaf(grown.leaf, grown.triangles, options);
    return painted_leaf_mesh(grown.triangles, picture, arguments.size_mm);
}

Result<void> draw_leaf(LeavesArguments const& arguments)
{
    auto const grammar = TRY(load_grammar(arguments.grammar));
    auto const grown = TRY(leaf_to_draw(grammar, arguments));
    auto const& triangles = grown.triangles;
    auto const mesh = TRY(mesh_to_draw(grammar, grown, arguments));
    auto const written
        = TRY(batch::write_mesh_file(mesh, arguments.grammar.stem().string(), arguments.output,
                                     { .picture = arguments.picture }));
    if (triangles.overlapping_faces > 0)
        terminal::print_error(fmt::format("{}: parts of the limb overlap themselves: {}\n",
                                          grammar.name, triangles.overlapping_faces));
    return terminal::print_out(fmt::format("wrote {}: {} triangles{}\n", arguments.output.string(),
                                           written.triangles, written.sentence()));
}

void add_grammar_argument(CLI::App& command, LeavesArguments& arguments)
{
    command.add_option("FILE", arguments.grammar, "A leaf grammar (.leaf)")
        ->type_name("FILE.leaf")
        ->check(options::suggest(leaf_names()))
        ->required();
}

void add_growth_options(CLI::App& command, LeavesArguments& arguments)
{
    command.add_option("--steps", arguments.steps, "How many steps to derive")
        ->type_name("N")
        ->check(options::whole_number(0, kMaxSteps));
    command
        .add_option("--finalstep", arguments.final_step,
                    "What the grammar reads as finalstep; without it, N")
        ->type_name("M")
        ->check(options::whole_number(0, kMaxSteps));
    command
        .add_option("--age", arguments.age,
                    "What the grammar reads as age, 0 to 1; without --steps, how old it is")
        ->type_name("AGE")
        ->check(options::number(0, 1));
    command.add_option("--seed", arguments.seed, "Which random numbers ran and nran give")
        ->type_name("SEED")
        ->capture_default_str();
}

} // namespace

void add_leaves_command(CLI::App& root, options::Action& action, tools::Methods const& methods)
{
    auto* const command
        = root.add_subcommand("leaves", "Derive leaves from grammars, and make pages of them");
    command->require_subcommand(0, 1);
    add_atlas_options(*command, action);

    auto checked = std::make_shared<LeavesArguments>();
    auto* const check = command->add_subcommand(
        "check", "Say whether a grammar is understood, and if not, what is wrong where");
    add_grammar_argument(*check, *checked);
    options::add_examples(*check, { "leaves check ivy", "leaves check mine.leaf" });
    check->callback([checked, &action] { action = [checked] { return check_grammar(*checked); }; });

    auto counted = std::make_shared<LeavesArguments>();
    auto* const count = command->add_subcommand(
        "count", "Print as JSON how many faces, edges and vertices a leaf has after each step");
    add_grammar_argument(*count, *counted);
    add_growth_options(*count, *counted);
    count->get_option("--steps")->required();
    count->footer(
        "A grammar (Peyrat, Terraz, Mérillou, Galin 2008) grows a leaf's veins as faces,\n"
        "splits and glues them, and fills the limb between them. Counted are the veins\n"
        "by themselves, the limb, and both together.");
    options::add_examples(*count,
                          { "leaves count ivy --steps 9", "leaves count mine.leaf --steps 3" });
    count->callback([counted, &action] { action = [counted] { return count_cells(*counted); }; });

    auto drawn = std::make_shared<LeavesArguments>();
    auto* const draw
        = command->add_subcommand("draw", "Write a leaf as a picture, or as triangles");
    add_grammar_argument(*draw, *drawn);
    add_growth_options(*draw, *drawn);
    draw->add_option("-o,--output", drawn->output,
                     "A picture (.png), or triangles: " + batch::listed(batch::mesh_endings()))
        ->type_name("FILE")
        ->check(options::name_ending_in(batch::mesh_endings()))
        ->required();
    options::add_picture_size_option(*draw, drawn->picture);
    draw->add_option("--length", drawn->size_mm, "The longer side of the flat leaf, in mm")
        ->type_name("MM")
        ->check(options::number(0.1, 10'000))
        ->capture_default_str();
    draw->add_option("--paint", drawn->paint,
                     "Paint it with its grammar's colours, in pictures so wide and high")
        ->type_name("PIXELS")
        ->check(options::whole_number(16, 4096));
    options::add_examples(
        *draw,
        { "leaves draw ivy --steps 9 -o ivy.png", "leaves draw oak --length 90 -o oak-leaf.glb" });
    draw->callback([drawn, &action] { action = [drawn] { return draw_leaf(*drawn); }; });
    add_sketch_leaf_command(*command, action, methods);
    add_paint_commands(*command, action);
    add_atlas_examples(*command);
}

} // namespace tractus::leaf
