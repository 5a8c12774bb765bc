#include "engine/methods/self_organising/beginning.h"

#include "engine/methods/self_organising/given_wood.h"
#include "engine/methods/self_organising/grown_tree.h"
#include "engine/methods/self_organising/tree_plant.h"
#include "engine/scene/scene.h"
#include "engine/scene/scene_shaper.h"
#include "engine/variation/place_nodes.h"

#include <algorithm>
#include <cmath>
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

// A scene with only a beginning's plant, and the positions of the plant's nodes after bending by
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

// Removes all axes except those with the keys `kept` and their ancestors; empty `kept`: all axes
// stay. Fails if the plant has none of these axes.
Result<void> keep_only(std::vector<std::uint32_t> const& kept, Plant& plant, AxisKeys& keys)
{
    if (kept.empty())
        return {};
    std::vector<bool> stays(plant.axes.size());
    for (std::size_t i = plant.axes.size(); i-- > 0;) {
        stays[i] = stays[i]
            || (i < keys.size() && std::find(kept.begin(), kept.end(), keys[i]) != kept.end());
        if (stays[i] && plant.axes[i].parent_axis != kNone)
            stays[plant.axes[i].parent_axis] = true;
    }
    if (std::none_of(stays.begin(), stays.end(), [](bool stay) { return stay; }))
        return fail(Fault::User,
                    "the plant has none of the branches that shall remain: choose "
                    "branches that it has");
    Plant rest;
    AxisKeys rest_keys;
    std::vector<AxisId> new_axis(plant.axes.size(), kNone);
    std::vector<SegmentId> new_segment(plant.segment_count(), kNone);
    for (std::size_t i = 0; i < plant.axes.size(); ++i) {
        if (!stays[i])
            continue;
        auto axis = plant.axes[i];
        new_axis[i] = static_cast<AxisId>(rest.axes.size());
        for (std::uint32_t k = 0; k < axis.segment_count; ++k)
            new_segment[axis.first_segment + k]
                = static_cast<SegmentId>(rest.segment_material.size() + k);
        rest.segment_material.resize(rest.segment_material.size() + axis.segment_count);
        auto const nodes = plant.positions(axis);
        auto const* const widths = plant.node_radius_mm.data() + axis.first_node;
        axis.first_node = static_cast<NodeId>(rest.node_position_mm.size());
        axis.first_segment = new_segment[axis.first_segment];
        rest.node_position_mm.insert(rest.node_position_mm.end(), nodes.begin(), nodes.end());
        rest.node_radius_mm.insert(rest.node_radius_mm.end(), widths, widths + nodes.size());
        if (axis.parent_axis != kNone) {
            axis.parent_axis = new_axis[axis.parent_axis];
            axis.parent_segment = new_segment[axis.parent_segment];
        }
        rest.axes.push_back(axis);
        rest_keys.push_back(keys[i]);
    }
    plant = std::move(rest);
    keys = std::move(rest_keys);
    return {};
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
                                       std::vector<std::uint32_t> kept_axes, bool wakes_buds,
                                       scene::SceneBuilder& builder)
{
    double const scale = state.scale ? *state.scale : TRY(builder.build(state)).placement.scale;
    return std::make_shared<Beginning const>(
        Beginning { state.plants[number], scale, std::move(kept_axes), wakes_buds });
}

Result<GrowingTree> tree_from_beginning(Beginning const& beginning, Habit const& habit,
                                        std::uint64_t seed, scene::LoadOptions const& options)
{
    auto const& drawn = *beginning.plant;
    auto const* const grown = grown_tree_of(drawn.source);
    if (grown && is_whole(drawn) && beginning.kept_axes.empty()) {
        auto tree = TRY(grow_tree(*grown, options));
        if (is_bent(drawn)) {
            auto const as_plant = plant_of(tree, grown->habit, grown->seed);
            bend_tree(tree, as_plant, TRY(build_bent_plant(beginning, options)).nodes_mm, habit);
        }
        return tree;
    }
    Plant plant;
    AxisKeys keys;
    if (is_bent(drawn) || !is_whole(drawn)) {
        auto const shown = TRY(build_bent_plant(beginning, options));
        plant = TRY(with_branches(*shown.scene.plants[0]->base, drawn.name));
        plant.node_position_mm = shown.nodes_mm;
        if (is_whole(drawn))
            keys = TRY(drawn.source.build(options)).axis_keys;
    } else {
        auto built = TRY(drawn.source.build(options));
        plant = TRY(with_branches(std::move(built.plant), drawn.name));
        keys = std::move(built.axis_keys);
    }
    TRY(keep_only(beginning.kept_axes, plant, keys));
    return tree_from_wood(
        { .plant = plant,
          .keys = keys,
          .buds = beginning.wakes_buds ? GivenWood::Buds::All : GivenWood::Buds::Young },
        habit, seed);
}

Result<std::vector<Vec3>> points_on_wood(Beginning const& beginning, double step_mm,
                                         scene::LoadOptions const& options)
{
    // Maximum number of pieces into which an internode is divided.
    constexpr double kMaxPieces = 10'000;
    auto const shown = TRY(build_bent_plant(beginning, options));
    std::vector<Vec3> points;
    for (auto const& axis : shown.scene.plants[0]->base->axes)
        for (auto i = axis.first_node; i < axis.first_node + axis.segment_count; ++i) {
            Vec3 const way = shown.nodes_mm[i + 1] - shown.nodes_mm[i];
            double const pieces = std::clamp(std::ceil(way.norm() / step_mm), 1.0, kMaxPieces);
            for (double k = 1; k <= pieces; ++k)
                points.push_back(shown.nodes_mm[i] + way * (k / pieces));
        }
    return points;
}

} // namespace tractus::self_organising
