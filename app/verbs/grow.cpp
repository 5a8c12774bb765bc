#include "app/verbs/grow.h"

#include "app/console.h"
#include "app/model_file.h"
#include "app/pictures.h"
#include "app/resources.h"
#include "app/verbs/checks.h"
#include "app/verbs/model_options.h"
#include "drivers/file.h"
#include "engine/export/glb_writer.h"
#include "engine/export/obj_writer.h"
#include "engine/mesh/make_mesh.h"
#include "engine/scene/scene.h"

#include <filesystem>
#include <fmt/core.h>
#include <memory>

namespace tractus {

namespace {

struct GrowArguments {
    ModelOptions model;
    ModelCost cost;
    std::filesystem::path output;
};

// Answers the number of triangles.
Result<std::uint64_t> write_plant(Plant const& plant, std::string const& name,
                                  std::filesystem::path const& path)
{
    std::uint64_t triangles = 0;
    if (path.extension() == ".glb") { // Meshed while it is written: plants may be large.
        PlacedMesh const placed { .name = name, .mesh = PlantToMesh { .plant = &plant } };
        auto const write = [&](std::ostream& out) -> Result<void> {
            triangles = TRY(write_glb(out, { &placed, 1 })).triangles;
            return {};
        };
        TRY(write_file(path, write));
        return triangles;
    }
    auto const mesh = make_mesh(plant);
    if (path.extension() == ".png") {
        auto pictures = TRY(PictureMaker::create());
        auto const picture = pictures.plant(mesh, {});
        TRY(write_file(path, [&](std::ostream& out) { return write_png(out, picture); }));
    } else {
        PlacedMesh const placed { .name = name, .mesh = &mesh };
        TRY(write_file(path, [&](std::ostream& out) { return write_obj(out, { &placed, 1 }); }));
    }
    return mesh.triangle_count();
}

Result<void> grow_model(GrowArguments const& arguments)
{
    auto const path = TRY(find_model(arguments.model.model));
    auto edit = TRY(load_plant_edit(path));
    if (auto* const model = std::get_if<LoadModel>(&edit)) {
        model->steps = arguments.model.steps;
        model->seed = arguments.model.seed;
    }
    auto const scene = TRY(apply_edit({}, edit, load_options(arguments.cost)));
    for (auto const& warning : scene.model_warnings)
        print_error(fmt::format("warning: {}\n", warning));
    auto const triangles = TRY(write_plant(*scene.base, path.stem().string(), arguments.output));
    return print_out(fmt::format("{}: {} segments, {} organs, {} triangles\n",
                                 arguments.output.string(), scene.base->segment_count(),
                                 scene.base->organs.size(), triangles));
}

} // namespace

void add_grow_verb(CLI::App& root, Action& action)
{
    auto arguments = std::make_shared<GrowArguments>();
    auto* const verb
        = root.add_subcommand("grow", "Grow a model and write it as glTF, OBJ or a picture");
    add_model_options(*verb, arguments->model);
    add_cost_options(*verb, arguments->cost);
    verb->add_option("-o,--output", arguments->output,
                     "What to write: its ending, .glb, .obj or .png, says in which format")
        ->type_name("FILE")
        ->check(name_ending_in({ ".glb", ".obj", ".png" }))
        ->required();
    verb->footer(
        "MODEL may also be a skeleton that another program has drawn as lines (.obj). The\n"
        "same model and seed always give the same file.");
    verb->callback(
        [arguments, &action] { action = [arguments] { return grow_model(*arguments); }; });
}

} // namespace tractus
