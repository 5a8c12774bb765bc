#include "app/verbs/grow.h"

#include "app/console.h"
#include "app/error_text.h"
#include "app/model_file.h"
#include "app/pictures.h"
#include "app/resources.h"
#include "app/session_plant.h"
#include "app/verbs/checks.h"
#include "app/verbs/model_options.h"
#include "drivers/file.h"
#include "engine/export/glb_writer.h"
#include "engine/export/obj_writer.h"
#include "engine/mesh/make_mesh.h"
#include "engine/mesh/mesh_measures.h"
#include "engine/scene/scene.h"
#include "engine/variation/growth.h"
#include "engine/variation/growth_preset.h"

#include <filesystem>
#include <fmt/core.h>
#include <memory>

namespace tractus {

namespace {

struct GrowArguments {
    ModelOptions model;
    ModelCost cost;
    std::filesystem::path output;
    std::size_t frames = 0; // Of an animation; 0 for the plant alone.
};

// Answers the number of triangles. `frame`: what a picture has to show; empty: the plant.
Result<std::uint64_t> write_plant(Plant const& plant, std::string const& name,
                                  std::filesystem::path const& path, Bounds const& frame = {})
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
        auto const picture = pictures.plant(mesh, {}, frame);
        TRY(write_file(path, [&](std::ostream& out) { return write_png(out, picture); }));
    } else {
        PlacedMesh const placed { .name = name, .mesh = &mesh };
        TRY(write_file(path, [&](std::ostream& out) { return write_obj(out, { &placed, 1 }); }));
    }
    return mesh.triangle_count();
}

// tree.glb becomes tree-01.glb and so on.
std::filesystem::path frame_path(std::filesystem::path const& output, std::size_t frame,
                                 std::size_t frames)
{
    auto const name = fmt::format("{}-{:0{}}{}", output.stem().string(), frame,
                                  std::to_string(frames).size(), output.extension().string());
    return output.parent_path() / name;
}

// The plant at ages evenly apart, the last one full-grown: a file for each, since the number of
// triangles grows with the plant.
Result<void> write_animation(GrowArguments const& arguments, Scene const& scene,
                             std::string const& name)
{
    if (scene.base->segment_count() == 0)
        return fail(Fault::User, fmt::format("{}: the plant has no branch that could grow", name));
    auto const plan = TRY(plan_growth(scene));
    Grower grower(plan);
    PlantKey const key { scene.growth.seed, 0 };
    Bounds frame;
    if (arguments.output.extension() == ".png")
        frame = bounds(make_mesh(grower.grow(key)));
    for (std::size_t i = 1; i <= arguments.frames; ++i) {
        double const age = static_cast<double>(i) / static_cast<double>(arguments.frames);
        auto const plant = without_unborn(grower.grow(key, age));
        auto const path = frame_path(arguments.output, i, arguments.frames);
        auto const triangles = TRY(write_plant(plant, name, path, frame));
        TRY(print_out(fmt::format("{}: age {:.3f}, {} segments, {} organs, {} triangles\n",
                                  path.string(), age, plant.segment_count(), plant.organs.size(),
                                  triangles)));
    }
    return {};
}

Result<void> print_grown(GrowArguments const& arguments, Plant const& plant,
                         std::filesystem::path const& path)
{
    auto const triangles = TRY(write_plant(plant, path.stem().string(), arguments.output));
    return print_out(fmt::format("{}: {} segments, {} organs, {} triangles\n",
                                 arguments.output.string(), plant.segment_count(),
                                 plant.organs.size(), triangles));
}

// A session says itself how its plant is derived; another seed is another variation of it.
Result<void> grow_session(GrowArguments const& arguments, std::filesystem::path const& path)
{
    if (arguments.model.steps)
        return fail(Fault::User,
                    fmt::format("{} is a session, which has its own derivation steps: leave "
                                "--steps out",
                                path.string()));
    auto scene = TRY(load_session_scene(path, arguments.cost));
    scene.growth.seed = arguments.model.seed.value_or(scene.growth.seed);
    if (arguments.frames > 0)
        return write_animation(arguments, scene, path.stem().string());
    auto const plant = TRY(shown_plant(scene));
    return print_grown(arguments, plant, path);
}

Result<void> grow_model(GrowArguments const& arguments)
{
    auto const path = TRY(find_model(arguments.model.model));
    if (is_session_file(path))
        return grow_session(arguments, path);
    auto edit = TRY(load_plant_edit(path));
    if (auto* const model = std::get_if<LoadModel>(&edit)) {
        model->steps = arguments.model.steps;
        model->seed = arguments.model.seed.value_or(1);
    }
    auto const scene = TRY(apply_edit({}, edit, load_options(arguments.cost)));
    for (auto const& warning : scene.model_warnings)
        print_warning(warning);
    if (arguments.frames == 0)
        return print_grown(arguments, *scene.base, path);
    // As the model has it, and not as it might have grown.
    auto const usual = TRY(growth_preset("usual"));
    SetGrowth const growth { TRY(at_liking(usual, 0)), arguments.model.seed.value_or(1) };
    return write_animation(arguments, TRY(apply_edit(scene, growth)), path.stem().string());
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
    verb->add_option("--animation", arguments->frames,
                     "Write the plant N times as it grows, from its youth to its full size: "
                     "FILE-1 to FILE-N, as many digits as N has")
        ->type_name("N")
        ->check(whole_number(1, 10'000));
    verb->footer(
        "MODEL may also be a skeleton that another program has drawn as lines (.obj, .glb), or\n"
        "a session (.tractus): then it is the plant as drawn, as the station's window shows\n"
        "it, or with --seed another variation. The same model and seed always give the same\n"
        "file.");
    verb->callback(
        [arguments, &action] { action = [arguments] { return grow_model(*arguments); }; });
}

} // namespace tractus
