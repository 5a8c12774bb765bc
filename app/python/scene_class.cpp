#include "app/python/scene_class.h"

#include "app/batch/collection_grower.h"
#include "app/batch/drawing.h"
#include "app/batch/plant_group.h"
#include "app/batch/plant_to_grow.h"
#include "app/methods/all_methods.h"
#include "app/python/errors.h"
#include "app/terminal/progress.h"
#include "engine/scene/season.h"
#include "engine/variation/growth.h"
#include "engine/variation/individual.h"

#include <cstddef>
#include <filesystem>
#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>
#include <utility>

namespace tractus::python {

namespace {

namespace py = pybind11;
using namespace pybind11::literals;

// What load() is asked for.
struct LoadRequest {
    batch::PlantToGrow plant {};
    std::filesystem::path drawing {}; // Empty: nothing is drawn on the plant.
    std::optional<std::filesystem::path> rig {};
    std::optional<std::string> height {};
};

// Draws a recorded drawing on the plant of a scene.
Result<void> add_recorded_drawing(LoadRequest const& request, SceneHandle& handle, bool is_session,
                                  scene::Scene& scene)
{
    if (!is_session && scene.base->segment_count() == 0)
        return fail(
            Fault::User,
            fmt::format("{}: the plant has no branch that a stroke could shape", handle.name));
    terminal::Progress progress;
    batch::DrawingReport report;
    batch::DrawingOptions const options { .log = request.drawing,
                                          .methods = methods::all_methods(),
                                          .rig = request.rig,
                                          .height = request.height };
    scene = TRY(batch::read_drawing(options, std::move(scene), progress, report)).scene;
    handle.warnings.insert(handle.warnings.end(), report.notes.begin(), report.notes.end());
    return {};
}

Result<SceneHandle> load_scene(LoadRequest const& request)
{
    auto [scene, name, is_session, warnings]
        = TRY(batch::load_plant_to_grow(request.plant, methods::all_methods()));
    scene = TRY(batch::with_growth(request.plant.growth, std::move(scene)));
    SceneHandle handle { .scene = nullptr,
                         .name = name,
                         .is_varied
                         = request.plant.is_varied() || is_session || !request.drawing.empty(),
                         .is_above_ground = request.plant.growth.along_ground,
                         .warnings = warnings };
    if (!request.drawing.empty())
        TRY(add_recorded_drawing(request, handle, is_session, scene));
    handle.scene = std::make_shared<scene::Scene const>(std::move(scene));
    return handle;
}

std::optional<scene::Season> season_of(py::object const& month, double fallen)
{
    if (month.is_none())
        return std::nullopt;
    check_range("fallen", fallen, 0, 1);
    return scene::Season { value_of(scene::parse_month(py::cast<std::string>(py::str(month)))),
                           fallen };
}

// Loads a scene for load() and grow(), which have these parameters.
SceneHandle load_for_python(std::filesystem::path const& plant, std::optional<int> steps,
                            std::optional<std::uint64_t> seed, std::string habit, int years,
                            int stand, double spacing_m, bool fill,
                            std::optional<std::string> growth, double variability,
                            bool along_ground, std::string leaves, py::object const& season,
                            double fallen, std::filesystem::path const& drawing,
                            std::optional<std::filesystem::path> rig,
                            std::optional<std::string> height)
{
    check_range("steps", steps.value_or(0), 0, kMaxSteps);
    check_range("years", years, 1, 200);
    check_range("stand", stand, 1, 400);
    check_range("spacing_m", spacing_m, 0.1, 1000);
    check_range("variability", variability, 0, 4);
    LoadRequest request { .drawing = drawing, .rig = std::move(rig), .height = std::move(height) };
    request.plant = { .model = plant.string(),
                      .steps = steps,
                      .seed = seed,
                      .cost = interruptible(),
                      .tree = { std::move(habit), years, stand, spacing_m, fill },
                      .growth = { .preset = std::move(growth),
                                  .variability = variability,
                                  .along_ground = along_ground,
                                  .leaves = std::move(leaves),
                                  .season = season_of(season, fallen) } };
    return value_of(without_gil([&] { return load_scene(request); }));
}

Result<std::vector<PlantHandle>> grow_variants(SceneHandle const& handle, std::uint64_t seed,
                                               std::size_t first, std::size_t count,
                                               variation::Individuality const& how)
{
    auto grower = TRY(batch::CollectionGrower::create(*handle.scene, 0));
    if (handle.is_above_ground)
        grower.keep_above_ground();
    grower.reseed(how.seeds);
    grower.make_individuals(how);
    auto const is_stopped = interruptible().is_stopped;
    std::vector<PlantHandle> plants;
    for (auto i = first; i < first + count; ++i) {
        if (is_stopped())
            return fail(Fault::User, "growing variants was stopped");
        variation::PlantKey const key { seed, static_cast<std::uint32_t>(i) };
        auto const age = variation::individual_age(key, how);
        auto const& grown = grower.grow(key, age);
        plants.push_back(
            { std::make_shared<Plant const>(age == 1 ? grown : variation::without_unborn(grown)),
              fmt::format("{} {}", handle.name, i + 1) });
    }
    return plants;
}

std::vector<PlantHandle> variants_of(SceneHandle const& handle, std::size_t count,
                                     std::uint64_t seed, std::size_t first, double branches,
                                     double sizes, double younger, double leaf_size,
                                     double own_seeds)
{
    check_range("first", static_cast<double>(first), 0, 1e9);
    check_range("count", static_cast<double>(count), 0, 1e9);
    check_range("branches", branches, 0, 0.5);
    check_range("sizes", sizes, 0, 0.5);
    check_range("younger", younger, 0, 0.9);
    check_range("leaf_size", leaf_size, 0, 0.5);
    check_range("own_seeds", own_seeds, 0, 1);
    variation::Individuality const how { .branches = branches,
                                         .size = sizes,
                                         .turn = 0,
                                         .age = younger,
                                         .organs = leaf_size,
                                         .seeds = own_seeds };
    return value_of(without_gil([&] { return grow_variants(handle, seed, first, count, how); }));
}

constexpr char const* kLoadDoc = R"(Load a plant, with everything that its variants need.

plant: a model's name (model_names()) or the path of a model, a skeleton, a measured plant or a
session. None: a tree of a habit by itself. All parameters are the options of `tractus grow`:

steps, seed: of the derivation; the seed also of growth.
habit, years, stand, spacing_m, fill: a tree that grows by itself; see habit_names().
growth, variability, along_ground: how growth varies the plant; see growth_names().
leaves: "oak", "oak+spots=0.3" or a .leaf file. season, fallen: "autumn" or a month's number.
drawing, rig, height: a recorded drawing on the plant.

Raises Error as the program does, with its sentence.)";

template<typename Function>
void def_load(py::module_& module, char const* name, Function function, std::string const& doc)
{
    module.def(name, function, "plant"_a = "", py::kw_only(), "steps"_a = py::none(),
               "seed"_a = py::none(), "habit"_a = "", "years"_a = 20, "stand"_a = 1,
               "spacing_m"_a = 4.0, "fill"_a = false, "growth"_a = py::none(),
               "variability"_a = 1.0, "along_ground"_a = false, "leaves"_a = "",
               "season"_a = py::none(), "fallen"_a = 0.25, "drawing"_a = "", "rig"_a = py::none(),
               "height"_a = py::none(), doc.c_str());
}

// Returns a function with the parameters of `load` that returns the plant instead of the scene.
template<typename... Parameters> auto growing(SceneHandle (*load)(Parameters...))
{
    return [load](Parameters... parameters) {
        return plant_of(load(std::forward<Parameters>(parameters)...));
    };
}

} // namespace

SceneHandle scene_of_handle(ModelHandle const& model, std::optional<int> steps, std::uint64_t seed)
{
    check_range("steps", steps.value_or(0), 0, kMaxSteps);
    auto edit = model.edit;
    edit.steps = steps;
    edit.seed = seed;
    auto const cost = interruptible();
    auto scene = value_of(without_gil([&] { return batch::scene_of_model(edit, cost); }));
    auto warnings = scene.model_warnings;
    return { .scene = std::make_shared<scene::Scene const>(std::move(scene)),
             .name = model.name,
             .warnings = std::move(warnings) };
}

PlantHandle plant_of(SceneHandle const& handle)
{
    auto const& scene = *handle.scene;
    if (!handle.is_varied && scene.plants.size() == 1)
        return { scene.in_season, handle.name };
    auto plant
        = value_of(without_gil([&] { return batch::shown_plants(scene, handle.is_above_ground); }));
    return { std::make_shared<Plant const>(std::move(plant)), handle.name };
}

void add_scene_class(py::module_& module)
{
    auto const how = variation::kPlantsOfOneBed;
    py::class_<SceneHandle>(module, "Scene",
                            "A loaded plant, with everything that its variants need.")
        .def("plant", &plant_of, "The plant, as `tractus grow` writes it.")
        .def("variants", &variants_of, "count"_a, "seed"_a = 1, py::kw_only(), "first"_a = 0,
             "branches"_a = how.branches, "sizes"_a = how.size, "younger"_a = how.age,
             "leaf_size"_a = how.organs, "own_seeds"_a = how.seeds,
             R"(Plants like this one, no two the same: those of `tractus vary --seed SEED`.

The plants are first to first + count - 1 of the collection. Load the scene with growth="usual" if
their growth is to vary as it does in a collection. The other parameters say how much they differ:

branches: the share of branches that a plant lacks, and of those that it has twice, 0 to 0.5.
sizes: the share by which plants are larger or smaller, 0 to 0.5.
younger: the share of its age by which a plant is younger, 0 to 0.9.
leaf_size: the share by which leaves are larger or smaller, 0 to 0.5.
own_seeds: the share of plants whose model has a seed of its own, 0 to 1.)")
        .def_readonly("name", &SceneHandle::name)
        .def_readonly("warnings", &SceneHandle::warnings, "What the program warns of.")
        .def("__repr__", [](SceneHandle const& scene) {
            return fmt::format("<tractus.Scene {}: {} plants>", scene.name,
                               scene.scene->plants.size());
        });
    def_load(module, "load", &load_for_python, kLoadDoc);
    def_load(module, "grow", growing(&load_for_python),
             "Grow a plant: load(...).plant(), with the same parameters.");
}

} // namespace tractus::python
