#include "app/commands/vary.h"

#include "app/batch/collection.h"
#include "app/files/resources.h"
#include "app/options/checks.h"
#include "app/options/drawing_options.h"
#include "app/options/glb_options.h"
#include "app/options/growth_options.h"
#include "app/options/shared_options.h"
#include "app/terminal/console.h"
#include "app/terminal/progress.h"
#include "engine/base/file.h"

#include <algorithm>
#include <memory>

namespace tractus {

namespace {

struct VaryArguments {
    CollectionOptions collection;
    std::string model;
    DrawingArguments drawing;
    std::string ages = "1";
    std::string stand = "grid";
    std::string shard = "1/1";
    std::string wind = "none";
    bool nodes = false;
};

Result<void> vary(VaryArguments const& arguments, Methods const& methods)
{
    auto options = arguments.collection;
    bool const is_one_file = options.output.extension() == ".glb";
    TRY(check_writable(is_one_file ? options.output : options.output / "plant.glb"));
    options.model = TRY(find_model(arguments.model));
    options.kinds = methods.edits;
    options.drawing = drawing_options(arguments.drawing, methods);
    auto const [youngest, oldest] = parse_range(arguments.ages).value();
    options.ages = { youngest, oldest };
    auto const [number, parts] = parse_part(arguments.shard).value();
    options.shard = { number, parts };
    options.mesh.min_sides = std::min(options.mesh.min_sides, options.mesh.max_sides);
    if (arguments.stand == "scatter")
        options.stand = Stand::Scatter;
    options.has_wind = arguments.wind != "none";
    if (arguments.wind == "uv")
        options.glb.wind = GlbOptions::Wind::TextureCoordinates;
    if (arguments.wind == "colour")
        options.glb.wind = GlbOptions::Wind::Colours;
    if (arguments.nodes)
        options.glb.organs = GlbOptions::Organs::Nodes;
    Progress progress;
    return print_out(print_report(TRY(make_collection(options, progress))));
}

void add_output_options(CLI::App& command, VaryArguments& arguments)
{
    command
        .add_option("-o,--output", arguments.collection.output,
                    "A .glb for all plants, or a folder for one .glb each; made if it is not there")
        ->type_name("FOLDER|FILE.glb")
        ->required();
    command
        .add_option("--sheet", arguments.collection.sheet,
                    "Also draw a picture of small pictures of the plants, of at most 48")
        ->type_name("FILE.png")
        ->check(name_ending_in({ ".png" }));
    command
        .add_option("--construction", arguments.collection.construction,
                    "How much what was sketched differs, too: a rule's angles, construction lines, "
                    "how an outlined tree's branches stand; 0 not at all, 1 as plants of a kind do")
        ->type_name("SPREAD")
        ->check(number(0, 4))
        ->capture_default_str();
    command
        .add_option("--shard", arguments.shard,
                    "Makes the I-th of N parts of the collection, so that many machines share it")
        ->type_name("I/N")
        ->check(part_of(1'000'000))
        ->capture_default_str();
    command
        .add_option("--sides", arguments.collection.mesh.max_sides,
                    "Sides of the thickest branches, 3 to 64")
        ->type_name("N")
        ->check(whole_number(3, 64))
        ->capture_default_str();
    command
        .add_option("--lods", arguments.collection.details,
                    "Coarser levels of each plant, for being seen from afar (MSFT_lod): each has "
                    "half the triangles of the one before, and the last is a billboard")
        ->type_name("N")
        ->check(whole_number(0, kMostDetails))
        ->capture_default_str();
    command
        .add_option("--wind", arguments.wind,
                    "Where vertices keep what game engines need for the wind (pivot, axis, level, "
                    "phase and bend of their branch): none, attributes (_PIVOT and so on), uv "
                    "(TEXCOORD_1 to _4) or colour (COLOR_0)")
        ->type_name("CHANNELS")
        ->check(one_of({ "none", "attributes", "uv", "colour" }))
        ->capture_default_str();
    auto* const organs = add_glb_options(command, arguments.collection.glb);
    command.add_flag("--nodes", arguments.nodes, "Means --organs nodes")->excludes(organs);
}

} // namespace

void add_vary_command(CLI::App& root, Action& action, Methods const& methods)
{
    auto arguments = std::make_shared<VaryArguments>();
    auto* const command = root.add_subcommand(
        "vary", "Make a collection: many plants that all keep what was drawn, no two alike");
    command
        ->add_option(
            "MODEL", arguments->model,
            "The plant's model: an L-system file (.l), a skeleton of lines (.obj, .glb), a "
            "measured tree (.csv, .txt, .ply, .mtg), a session with what was drawn in it "
            "(.tractus), or one of ours by its name")
        ->required();
    add_drawing_options(*command, arguments->drawing, "plants vary by chance alone");
    command
        ->add_option("--count", arguments->collection.count, "Plants in the collection, all parts")
        ->type_name("N")
        ->check(whole_number(1, 4'000'000'000))
        ->capture_default_str();
    add_seed_option(*command, arguments->collection.seed);
    add_growth_options(*command, arguments->collection.growth, "usual, or as in a session");
    command
        ->add_option("--ages", arguments->ages,
                     "How old the plants are, from the youngest to the oldest: above 0, and 1 is "
                     "full-grown")
        ->type_name("A..B")
        ->check(number_range(0.01, 1))
        ->capture_default_str();
    command
        ->add_option("--spread", arguments->stand,
                     "How they stand: grid, in rows, or scatter, turned and out of line")
        ->check(one_of({ "grid", "scatter" }))
        ->type_name("HOW")
        ->capture_default_str();
    add_output_options(*command, *arguments);
    command->footer(
        "A manifest in JSON says of each plant how to make it again and where it stands.\n"
        "The same arguments give the same files, and parts are exactly parts of the whole:\n"
        "a cluster makes a collection with one --shard for each of its jobs. Stopped with\n"
        "Ctrl-C, it leaves whole files.");
    command->callback([arguments, methods, &action] {
        action = [arguments, methods] { return vary(*arguments, methods); };
    });
}

} // namespace tractus
