#include "engine/methods/self_organising/beginning.h"

#include "engine/methods/self_organising/given_wood.h"
#include "engine/methods/self_organising/grown_tree.h"
#include "engine/methods/self_organising/tree_plant.h"
#include "engine/scene/scene.h"
#include "engine/scene/scene_shaper.h"
#include "engine/variation/place_nodes.h"

#include <fmt/core.h>
#include <utility>
#include <vector>

namespace tractus::self_organising {

namespace {

bool is_bent(scene::PlantState const& plant)
{
    return !plant.strokes.empty() || !plant.indicators.empty();
}

// True if nothing was grafted onto the plant and no branch of it is hidden.
bool is_whole(scene::PlantState const& plant)
{
    return plant.grafts.empty() && plant.hidden_branches.empty();
}

// A plant built as the only one of a document, with the positions of its nodes after bending by
// strokes, in plant millimetres.
struct BentPlant {
    scene::Scene scene;
    std::vector<Vec3> nodes_mm;
};
Result<BentPlant> build_bent_plant(Beginning const& beginning, scene::LoadOptions const& options)
{
    scene::DocumentState state;
    state.plants = { beginning.plant };
    state.active = beginning.plant->id;
    state.scale = beginning.scale;
    BentPlant result { TRY(scene::SceneBuilder([&] { return options; }).build(std::move(state))),
                       {} };
    auto const& plant = *result.scene.plants[0];
    scene::SceneShaper shaper;
    TRY(shaper.set_plant(plant));
    variation::place_nodes(*plant.base, *plant.rest, shaper.shape(), result.nodes_mm);
    return result;
}

Result<Plant> with_branches(Plant plant, std::string const& name)
{
    if (plant.axes.empty())
        return fail(Fault::User,
                    fmt::format("{} has no branches from which a tree could grow: choose a plant "
                                "that has",
                                name.empty() ? "the plant" : name));
    return plant;
}

} // namespace

Result<SharedBeginning> beginning_from(scene::DocumentState const& state, std::size_t number,
                                       scene::SceneBuilder& builder)
{
    double const scale = state.scale ? *state.scale : TRY(builder.build(state)).placement.scale;
    return std::make_shared<Beginning const>(Beginning { state.plants[number], scale });
}

Result<GrowingTree> wood_of(Beginning const& beginning, Habit const& habit, std::uint64_t seed,
                            scene::LoadOptions const& options)
{
    auto const& drawn = *beginning.plant;
    auto const* const grown = grown_tree_of(drawn.source);
    if (grown && is_whole(drawn)) {
        auto tree = TRY(grow_tree(*grown, options));
        if (is_bent(drawn)) {
            auto const as_plant = plant_of(tree, grown->habit, grown->seed);
            bend_tree(tree, as_plant, TRY(build_bent_plant(beginning, options)).nodes_mm, habit);
        }
        return tree;
    }
    if (!is_bent(drawn) && is_whole(drawn)) {
        auto const built = TRY(drawn.source.build(options));
        auto const plant = TRY(with_branches(built.plant, drawn.name));
        return tree_of_wood({ .plant = plant, .keys = built.axis_keys }, habit, seed);
    }
    auto const shown = TRY(build_bent_plant(beginning, options));
    auto plant = TRY(with_branches(*shown.scene.plants[0]->base, drawn.name));
    plant.node_position_mm = shown.nodes_mm;
    auto const keys = is_whole(drawn) ? TRY(drawn.source.build(options)).axis_keys : AxisKeys {};
    return tree_of_wood({ .plant = plant, .keys = keys }, habit, seed);
}

} // namespace tractus::self_organising
