#include "app/batch/plant_to_grow.h"

#include "app/batch/plant_season.h"
#include "app/batch/session_plant.h"
#include "app/files/resources.h"
#include "app/methods/all_habits.h"
#include "app/methods/all_leaves.h"
#include "engine/variation/growth.h"
#include "engine/variation/growth_preset.h"

#include <filesystem>
#include <fmt/format.h>
#include <utility>

namespace tractus::batch {

namespace {

bool has_model_options(PlantToGrow const& what)
{
    return what.steps || !what.companions.view.empty() || !what.companions.colors.empty()
        || !what.companions.environment.empty() || what.companions.dialect != io::kCpfgDialect;
}

// Sets growth "as drawn", which shows a plant as derived, without variation.
Result<scene::Scene> grown_as_drawn(scene::Scene scene, std::uint64_t seed)
{
    return scene::apply_edit(std::move(scene),
                             scene::SetGrowth { TRY(variation::growth_preset("as drawn")), seed });
}

// Loads a session. Its plant is derived as saved in the session; a seed among the arguments only
// selects another variation.
Result<scene::Scene> load_session_to_grow(PlantToGrow const& what,
                                          std::filesystem::path const& path, scene::EditKinds kinds)
{
    if (what.steps)
        return fail(Fault::User,
                    fmt::format("{} is a session, which has its own derivation steps: leave "
                                "--steps out",
                                path.string()));
    auto scene = TRY(load_session_scene(path, kinds, what.cost));
    auto growth = scene.growth;
    growth.seed = what.seed.value_or(growth.seed);
    return scene::apply_edit(std::move(scene), growth);
}

// Loads a model, skeleton or measured plant.
Result<LoadedPlant> load_model_to_grow(PlantToGrow const& what, std::filesystem::path const& path)
{
    auto edit = TRY(io::load_plant_quietly(path, what.companions));
    LoadedPlant loaded { .scene = {}, .name = path.stem().string() };
    if (auto const* const model = edit.get<scene::LoadModel>()) {
        auto with_options = *model;
        with_options.steps = what.steps;
        with_options.seed = what.seed.value_or(1);
        loaded.scene = TRY(scene_of_model(with_options, what.cost));
        loaded.warnings = loaded.scene.model_warnings;
        auto const unused = io::warnings_of_unused_companions(path, what.companions);
        loaded.warnings.insert(loaded.warnings.end(), unused.begin(), unused.end());
        return loaded;
    }
    if (has_model_options(what))
        return fail(Fault::User,
                    fmt::format("{} is no L-system: --steps, --view, --colors and --environment "
                                "are for those",
                                path.string()));
    auto scene = TRY(scene::apply_edit({}, edit, document::make_load_options(what.cost)));
    loaded.warnings = scene.model_warnings;
    loaded.scene = TRY(grown_as_drawn(std::move(scene), what.seed.value_or(1)));
    return loaded;
}

// Grows a self-organising tree, or a stand of such trees.
Result<scene::Scene> load_tree_to_grow(PlantToGrow const& what)
{
    if (has_model_options(what))
        return fail(Fault::User,
                    "a habit is no L-system: --steps, --view, --colors and --environment are for "
                    "those");
    auto const& tree = what.tree;
    auto const seed = what.seed.value_or(1);
    if (tree.stand > 1) {
        auto const edits = TRY(methods::edits_for_stand({ .habit = tree.habit,
                                                          .years = tree.years,
                                                          .seed = seed,
                                                          .count = tree.stand,
                                                          .spacing_m = tree.spacing_m }));
        return scene::apply_edits({}, edits, document::make_load_options(what.cost));
    }
    auto const edit = TRY(methods::tree_of_habit(tree.habit, tree.years, seed));
    auto scene = TRY(scene::apply_edit({}, edit, document::make_load_options(what.cost)));
    return grown_as_drawn(std::move(scene), seed);
}

Result<LoadedPlant> load_from_model(PlantToGrow const& what, std::filesystem::path const& path,
                                    tools::Methods const& methods)
{
    if (!is_session_file(path))
        return load_model_to_grow(what, path);
    return LoadedPlant { .scene = TRY(load_session_to_grow(what, path, methods.edits)),
                         .name = path.stem().string(),
                         .is_session = true };
}

} // namespace

Result<scene::Scene> scene_of_model(scene::LoadModel const& model, document::ModelCost const& cost)
{
    auto scene = TRY(scene::apply_edit({}, model, document::make_load_options(cost)));
    return grown_as_drawn(std::move(scene), model.seed);
}

Result<LoadedPlant> load_plant_to_grow(PlantToGrow const& what, tools::Methods const& methods)
{
    auto const& tree = what.tree;
    if (what.model.empty() && tree.habit.empty())
        return fail(Fault::User,
                    "give a model or, with --habit, the habit of a tree that grows by itself");
    if (tree.stand > 1 && !what.model.empty())
        return fail(Fault::User, "--stand plants trees of a habit: leave the model out");
    if (what.model.empty() && tree.fills)
        return fail(Fault::User,
                    "--fill fills the crown of a tree that was drawn by its outline: "
                    "give the session with that tree, too");
    if (what.model.empty()) {
        auto scene = TRY(load_tree_to_grow(what));
        auto const name = scene.model_name;
        return LoadedPlant { .scene = std::move(scene), .name = name };
    }
    auto const path = TRY(files::find_model(what.model));
    auto loaded = TRY(load_from_model(what, path, methods));
    if (!tree.habit.empty()) {
        auto const edit = TRY(methods::growth_from(loaded.scene,
                                                   { .habit = tree.habit,
                                                     .years = tree.years,
                                                     .seed = what.seed.value_or(1),
                                                     .fills = tree.fills }));
        loaded.scene = TRY(scene::apply_edit(std::move(loaded.scene), edit,
                                             document::make_load_options(what.cost)));
    }
    return loaded;
}

Result<scene::Scene> with_growth(GrowthOptions const& options, scene::Scene scene)
{
    auto growth = scene.growth;
    growth.parameters
        = TRY(options.preset ? variation::growth_preset(*options.preset)
                             : variation::at_variability(growth.parameters, growth.variability));
    growth.variability = options.variability;
    scene = TRY(scene::apply_edit(std::move(scene), growth));
    if (!options.leaves.empty()) {
        auto const edits = TRY(methods::foliage_edits(scene, scene.state.active,
                                                      methods::parse_foliage(options.leaves)));
        scene = TRY(scene::apply_edits(std::move(scene), edits));
    }
    return with_season(std::move(scene), options.season);
}

} // namespace tractus::batch
