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

struct Arguments {
    ModelOptions model;
    ModelCost cost;
    std::filesystem::path output;
};

Result<void> write_plant(Mesh const& mesh, std::string const& name,
                         std::filesystem::path const& path)
{
    auto const extension = path.extension();
    if (extension == ".png") {
        auto pictures = TRY(PictureMaker::create());
        auto const picture = pictures.plant(mesh, {});
        return write_file(path, [&](std::ostream& out) { return write_png(out, picture); });
    }
    PlacedMesh const plant { .name = name, .mesh = &mesh };
    if (extension == ".glb")
        return write_file(path, [&](std::ostream& out) -> Result<void> {
            TRY(write_glb(out, { &plant, 1 }));
            return {};
        });
    return write_file(path, [&](std::ostream& out) { return write_obj(out, { &plant, 1 }); });
}

Result<void> grow_model(Arguments const& arguments)
{
    auto const path = TRY(find_model(arguments.model.model));
    auto edit = TRY(load_model_edit(path));
    edit.steps = arguments.model.steps;
    edit.seed = arguments.model.seed;
    auto const scene = TRY(apply_edit({}, edit, load_options(arguments.cost)));
    for (auto const& warning : scene.model_warnings)
        print_error(fmt::format("warning: {}\n", warning));
    auto const mesh = make_mesh(*scene.base);
    TRY(write_plant(mesh, path.stem().string(), arguments.output));
    return print_out(fmt::format("{}: {} segments, {} organs, {} triangles\n",
                                 arguments.output.string(), scene.base->segment_count(),
                                 scene.base->organs.size(), mesh.triangle_count()));
}

} // namespace

void add_grow_verb(CLI::App& root, Action& action)
{
    auto arguments = std::make_shared<Arguments>();
    auto* const verb
        = root.add_subcommand("grow", "Grow a model and write it as glTF, OBJ or a picture");
    add_model_options(*verb, arguments->model);
    add_cost_options(*verb, arguments->cost);
    verb->add_option("-o,--output", arguments->output,
                     "What to write: its ending, .glb, .obj or .png, says in which format")
        ->type_name("FILE")
        ->check(name_ending_in({ ".glb", ".obj", ".png" }))
        ->required();
    verb->footer("The same model and seed always give the same file.");
    verb->callback(
        [arguments, &action] { action = [arguments] { return grow_model(*arguments); }; });
}

} // namespace tractus
