#include "engine/methods/silhouettes/nearest_style.h"

#include "engine/methods/silhouettes/measured_style.h"
#include "engine/methods/silhouettes/tree_edits.h"
#include "engine/scene/scene_builder.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <utility>

namespace tractus::silhouette {

namespace {

bool has_taker(scene::DocumentState const& state)
{
    return std::any_of(state.plants.begin(), state.plants.end(), [](auto const& plant) {
        auto const* const tree = outlined_tree(*plant);
        return tree && takes_style(*tree);
    });
}

// The plant with this id; null if there is none.
std::shared_ptr<scene::PlantState const> plant_of(scene::DocumentState const& state,
                                                  scene::ItemId plant)
{
    auto const number = scene::find_plant(state, plant);
    return number ? state.plants[*number] : nullptr;
}

// True if `taker` must take its style again because `source` has changed, or because it did not
// take the style of `source` before.
bool is_other(scene::DocumentState const& before, scene::DocumentState const& after,
              scene::PlantState const& taker, scene::ItemId source)
{
    auto const was = plant_of(before, taker.id);
    if (!was) // A tree drawn in this step already has its style.
        return false;
    auto const* const tree = outlined_tree(*was);
    bool const took = tree && takes_style(*tree);
    return !took || nearest_with_style(before, was->stands_at_mm, was->id) != source
        || !(plant_of(before, source)->source == plant_of(after, source)->source);
}

} // namespace

bool has_own_style(OutlinedTree const& tree)
{
    bool const has_form = !is_usual(tree.form);
    return tree.has_crown()
        && (tree.is_refined() || !tree.styles.empty() || (has_form && !tree.takes_style));
}

bool takes_style(OutlinedTree const& tree)
{
    return tree.takes_style && !tree.is_refined() && tree.styles.empty();
}

scene::ItemId nearest_with_style(scene::DocumentState const& state, Vec3 const& place_mm,
                                 scene::ItemId except)
{
    double min_mm = std::numeric_limits<double>::infinity();
    scene::ItemId nearest = 0;
    for (auto const& plant : state.plants) {
        auto const* const tree = outlined_tree(*plant);
        if (!tree || plant->id == except || !has_own_style(*tree))
            continue;
        double const away_mm = (plant->stands_at_mm - place_mm).norm();
        if (away_mm < min_mm) {
            min_mm = away_mm;
            nearest = plant->id;
        }
    }
    return nearest;
}

Result<TreeForm> with_style_of(TreeForm form, Plant const& plant)
{
    auto taken = form_of(TRY(measure_style(plant)));
    taken.seed = form.seed;
    taken.has_whole_nodes = form.has_whole_nodes;
    taken.plane_branches = form.plane_branches;
    taken.leaves_reach_outline = form.leaves_reach_outline;
    taken.bases_by_angle = form.bases_by_angle;
    return taken;
}

std::vector<scene::Edit> dependent_style_edits(scene::Scene const& scene,
                                               std::vector<scene::Edit> const& step)
{
    std::vector<scene::Edit> edits;
    if (!has_taker(scene.state))
        return edits;
    scene::SceneBuilder builder(scene, {});
    auto const state = scene::apply_edits(scene.state, step, builder);
    if (!state)
        return edits; // The error is reported by the code that applies the step.
    // Trees that must take a style, with the id of the tree that has it. Mostly there are none, and
    // then no plant is built.
    std::vector<std::pair<std::shared_ptr<scene::PlantState const>, scene::ItemId>> takers;
    for (auto const& plant : state->plants) {
        auto const* const tree = outlined_tree(*plant);
        if (!tree || !takes_style(*tree))
            continue;
        auto const source = nearest_with_style(*state, plant->stands_at_mm, plant->id);
        if (source != 0 && is_other(scene.state, *state, *plant, source))
            takers.emplace_back(plant, source);
    }
    if (takers.empty())
        return edits;
    auto const after = builder.build(*state);
    if (!after)
        return edits;
    for (auto const& [plant, source] : takers) {
        auto const built = std::find_if(
            after->plants.begin(), after->plants.end(),
            [wanted = source](auto const& each) { return each->drawn->id == wanted; });
        auto const& form = outlined_tree(*plant)->form;
        // A plant without branches has no style to take.
        if (auto const taken = with_style_of(form, *(*built)->base); taken && *taken != form)
            edits.emplace_back(FormTree { plant->id, *taken, true });
    }
    return edits;
}

} // namespace tractus::silhouette
