#include "app/commands/vary.h"

#include "app/batch/collection.h"
#include "app/files/resources.h"
#include "app/options/checks.h"
#include "app/options/drawing_options.h"
#include "app/options/glb_options.h"
#include "app/options/growth_options.h"
#include "app/options/picture_options.h"
#include "app/options/shared_options.h"
#include "app/terminal/console.h"
#include "app/terminal/progress.h"
#include "engine/base/file.h"

#include <algorithm>
#include <memory>

namespace tractus::commands {

namespace {

struct VaryArguments {
    batch::CollectionOptions collection;
    std::string model;
    options::DrawingArguments drawing;
    std::string ages {};
    std::string stand = "grid";
    std::string shard = "1/1";
    std::string wind = "none";
    bool nodes = false;
};

Result<void> vary(VaryArguments const& arguments, tools::Methods const& methods)
{
    auto options = arguments.collection;
    if (options.details > 0 && options.output.extension() == ".html")
        return fail(Fault::User,
                    "--lods needs a .glb file or a folder: a page (.html) shows each plant at one "
                    "level of detail");
    TRY(check_writable(batch::is_one_file(options) ? options.output
                                                   : options.output / "plant.glb"));
    options.model = TRY(files::find_model(arguments.model));
    options.kinds = methods.edits;
    options.drawing = options::drawing_options(arguments.drawing, methods);
    if (!arguments.ages.empty()) {
        auto const [youngest, oldest] = options::parse_range(arguments.ages).value();
        options.ages = { youngest, oldest };
        options.individuality.age = 0;
    }
    auto const [number, parts] = options::parse_part(arguments.shard).value();
    options.shard = { number, parts };
    options.mesh.min_sides = std::min(options.mesh.min_sides, options.mesh.max_sides);
    if (arguments.stand == "scatter")
        options.stand = batch::Stand::Scatter;
    options.has_wind = arguments.wind != "none";
    if (arguments.wind == "uv")
        options.glb.wind = exports::GlbOptions::Wind::TextureCoordinates;
    if (arguments.wind == "colour")
        options.glb.wind = exports::GlbOptions::Wind::Colours;
    if (arguments.nodes)
        options.glb.organs = exports::GlbOptions::Organs::Nodes;
    terminal::Progress progress;
    return terminal::print_out(batch::print_report(TRY(batch::make_collection(options, progress))));
}

// Adds the options that say how many triangles the plants have.
void add_triangle_options(CLI::App& command, batch::CollectionOptions& collection)
{
    command
        .add_option("--sides", collection.mesh.max_sides, "Sides of the thickest branches, 3 to 64")
        ->type_name("N")
        ->check(options::whole_number(3, 64))
        ->capture_default_str();
    command
        .add_option(
            "--organ-error", collection.organ_error,
            "By how much leaves, petals and fruits may differ from their exact shapes, as a "
            "share of the plant's height, to save triangles; 0 for all triangles")
        ->type_name("SHARE")
        ->check(options::number(0, 0.1))
        ->capture_default_str();
    command
        .add_option("--lods", collection.details,
                    "Coarser levels of each plant, for being seen from afar (MSFT_lod): each has "
                    "half the triangles of the one before, and the last is a billboard")
        ->type_name("N")
        ->check(options::whole_number(0, batch::kMaxDetails))
        ->capture_default_str();
}

void add_output_options(CLI::App& command, VaryArguments& arguments)
{
    command
        .add_option("-o,--output", arguments.collection.output,
                    "A .glb for all plants, a .html that shows and turns them in a browser, or a "
                    "folder for one .glb each; made if it is not there")
        ->type_name("FOLDER|FILE.glb|FILE.html")
        ->required();
    command
        .add_option("--sheet", arguments.collection.sheet,
                    "Also draw a picture of small pictures of the plants, of at most 48")
        ->type_name("FILE.png")
        ->check(options::name_ending_in({ ".png" }));
    options::add_picture_size_option(
        command, arguments.collection.sheet_tile,
        "Width and height in pixels of each small picture of --sheet; one number for both",
        "; by how much the plants' own sizes differ is --sizes")
        ->needs("--sheet");
    command
        .add_option("--construction", arguments.collection.construction,
                    "How much what was sketched differs, too: a rule's angles, construction lines, "
                    "how an outlined tree's branches stand; 0 not at all, 1 as plants of a kind do")
        ->type_name("SPREAD")
        ->check(options::number(0, 4))
        ->capture_default_str();
    command
        .add_option("--shard", arguments.shard,
                    "Makes the I-th of N parts of the collection, so that many machines share it")
        ->type_name("I/N")
        ->check(options::part_of(1'000'000))
        ->capture_default_str();
    add_triangle_options(command, arguments.collection);
    command
        .add_option("--wind", arguments.wind,
                    "Where vertices keep what game engines need for the wind (pivot, axis, level, "
                    "phase and bend of their branch): none, attributes (_PIVOT and so on), uv "
                    "(TEXCOORD_1 to _4) or colour (COLOR_0)")
        ->type_name("CHANNELS")
        ->check(options::one_of({ "none", "attributes", "uv", "colour" }))
        ->capture_default_str();
    auto* const organs = options::add_glb_options(command, arguments.collection.glb);
    command.add_flag("--nodes", arguments.nodes, "Means --organs nodes")->excludes(organs);
}

} // namespace

void add_vary_command(CLI::App& root, options::Action& action, tools::Methods const& methods)
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
    options::add_drawing_options(*command, arguments->drawing, "plants vary by chance alone");
    command
        ->add_option("--count", arguments->collection.count, "Plants in the collection, all parts")
        ->type_name("N")
        ->check(options::whole_number(1, 4'000'000'000))
        ->capture_default_str();
    options::add_seed_option(*command, arguments->collection.seed);
    options::add_growth_options(*command, arguments->collection.growth,
                                "usual, or as in a session");
    options::add_individuality_options(*command, arguments->collection.individuality);
    command
        ->add_option("--ages", arguments->ages,
                     "How old the plants are, from the youngest to the oldest: above 0, and 1 is "
                     "full-grown; without it, as --younger says")
        ->type_name("A..B")
        ->check(options::number_range(0.01, 1))
        ->excludes("--younger");
    command
        ->add_option("--spread", arguments->stand,
                     "How they stand: grid, in rows, or scatter, out of line")
        ->check(options::one_of({ "grid", "scatter" }))
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

} // namespace tractus::commands
