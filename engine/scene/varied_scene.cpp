#include "engine/scene/varied_scene.h"

#include "engine/base/random.h"
#include "engine/scene/lsystem_source.h"
#include "engine/scene/scene_builder.h"
#include "engine/variation/individual.h"
#include "engine/variation/similar_branches.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace tractus::scene {

bool has_sources_that_vary(Scene const& scene)
{
    auto const& plants = scene.state.plants;
    return std::any_of(plants.begin(), plants.end(), [](auto const& plant) {
        return plant->source.can_vary()
            || std::any_of(plant->grafts.begin(), plant->grafts.end(),
                           [](Graft const& graft) { return graft.source.can_vary(); });
    });
}

namespace {

// First random stream for the seeds of models; each attempt uses the next one.
constexpr std::uint32_t kModelSeeds = 0x6D6F6400;
constexpr std::uint32_t kMaxSeeds = 6;
// Branches of two individuals that differ by less than this
// (SimilarBranches::greatest_difference()) are similar enough for the same strokes, so that no
// further seed is tried.
constexpr double kAlike = 0.5;

// Returns the number of a plant's strokes, limbs and grafts whose branch exists. Overridden strokes
// are not counted.
std::size_t items_with_branch(BuiltPlant const& plant)
{
    auto const& grafts = plant.drawn->grafts;
    auto const seated = std::count_if(grafts.begin(), grafts.end(), [&](Graft const& graft) {
        return plant.rest->addresses.find_segment(*plant.base, graft.at).has_value();
    });
    return shaping_numbers(plant).size() + static_cast<std::size_t>(seated);
}

// Returns the total of items_with_branch(plant) over all plants of the scene.
std::size_t items_with_branch(Scene const& scene)
{
    std::size_t count = items_with_branch(static_cast<BuiltPlant const&>(scene));
    for (auto const& plant : scene.plants)
        if (plant->drawn != scene.drawn)
            count += items_with_branch(*plant);
    return count;
}

// Returns the state with new seeds for all models from files, or no value if it has no such model.
std::optional<DocumentState> reseeded(DocumentState state, std::uint64_t seed, std::uint32_t plant,
                                      std::uint32_t attempt)
{
    bool has_models = false;
    std::uint32_t number = 0;
    auto const reseed = [&](PlantSource& source) {
        Random random({ seed, kModelSeeds + attempt, plant + (number++ << 20) });
        if (auto other = with_model_seed(source, random.next_u64())) {
            source = *std::move(other);
            has_models = true;
        }
    };
    for (std::size_t i = 0; i < state.plants.size(); ++i)
        change_plant(state, i, [&](PlantState& changed) {
            reseed(changed.source);
            for (auto& graft : changed.grafts)
                reseed(graft.source);
        });
    return has_models ? std::optional(std::move(state)) : std::nullopt;
}

// Moves the strokes of a plant from the branches of `drawn` to the most similar branches of
// `grown`, another individual. A stroke without a similar branch stays at its address. Returns the
// greatest difference between paired branches (SimilarBranches::greatest_difference()).
double move_strokes(PlantState& state, BuiltPlant const& drawn, BuiltPlant const& grown)
{
    variation::SimilarBranches branches(*drawn.base, *grown.base);
    for (std::size_t i = 0; i < drawn.associations.size(); ++i) {
        auto const& association = drawn.associations[i].what;
        if (association.is_orphaned)
            continue;
        auto const path = branches.like(association.path.vector());
        if (!path)
            continue;
        auto stroke = state.strokes[i];
        stroke.at = { grown.rest->addresses.address_of(*grown.base, *path) };
        state.strokes.replace(i, std::move(stroke));
    }
    return branches.greatest_difference();
}

// Returns the built plant number `i` of a scene; for the active plant, the scene itself as a
// BuiltPlant.
BuiltPlant const& plant_of(Scene const& scene, std::size_t i)
{
    auto const& plant = *scene.plants[i];
    return plant.drawn->id == scene.drawn->id ? static_cast<BuiltPlant const&>(scene) : plant;
}

bool is_like(Plant const& one, Plant const& other)
{
    return one.node_position_mm == other.node_position_mm;
}

// True if all base plants of two scenes of one document have the same shape.
bool has_same_bases(Scene const& one, Scene const& other)
{
    return is_like(*one.base, *other.base)
        && std::equal(one.plants.begin(), one.plants.end(), other.plants.begin(),
                      other.plants.end(),
                      [](auto const& a, auto const& b) { return is_like(*a->base, *b->base); });
}

} // namespace

Scene with_own_seed(Scene const& scene, std::uint64_t seed, std::uint32_t plant)
{
    auto const wanted = items_with_branch(scene);
    SceneBuilder builder(scene, {});
    std::optional<Scene> best;
    double least = std::numeric_limits<double>::infinity();
    for (std::uint32_t attempt = 0; attempt < kMaxSeeds; ++attempt) {
        auto state = reseeded(scene.state, seed, plant, attempt);
        if (!state)
            break;
        auto grown = builder.build(*std::move(state));
        if (!grown)
            continue;
        auto moved = grown->state;
        double differs = 0;
        for (std::size_t i = 0; i < moved.plants.size(); ++i)
            change_plant(moved, i, [&](PlantState& changed) {
                differs = std::max(differs,
                                   move_strokes(changed, plant_of(scene, i), plant_of(*grown, i)));
            });
        auto built = builder.build(std::move(moved));
        if (!built || items_with_branch(*built) < wanted || differs >= least)
            continue;
        least = differs;
        best = *std::move(built);
        if (differs <= kAlike)
            break;
    }
    return best.value_or(scene);
}

bool has_stochastic_models(Scene const& scene)
{
    auto state = reseeded(scene.state, 1, 1, 0);
    if (!state)
        return false;
    auto const built = SceneBuilder(scene, {}).build(*std::move(state));
    return built && !has_same_bases(scene, *built);
}

Scene active_plant_alone(Scene const& scene)
{
    auto state = scene.state;
    if (state.plants.size() < 2)
        return scene;
    std::erase_if(state.plants, [&](auto const& plant) { return plant->id != state.active; });
    auto alone = SceneBuilder(scene, {}).build(std::move(state));
    return alone ? *std::move(alone) : scene;
}

SeedAssignment::SeedAssignment(Scene const& scene, double share)
    : share_(share > 0 && has_stochastic_models(scene) ? share : 0)
{
}

bool SeedAssignment::has(variation::PlantKey const& key) const
{
    return variation::has_own_seed(key, { .seeds = share_ });
}

Scene SeedAssignment::scene_of(Scene const& scene, variation::PlantKey const& key) const
{
    return has(key) ? with_own_seed(scene, key.seed, key.plant_index) : scene;
}

Result<Scene> varied(Scene const& scene, SourceVariation const& variation)
{
    auto state = scene.state;
    for (std::size_t i = 0; i < state.plants.size(); ++i)
        change_plant(state, i, [&](PlantState& plant) {
            plant.source = plant.source.varied(variation);
            auto of_part = variation;
            for (auto& graft : plant.grafts) {
                if (graft.limb)
                    continue;
                ++of_part.stream; // A stream of its own, so that identical parts vary differently.
                graft.source = graft.source.varied(of_part);
            }
        });
    SceneBuilder builder(scene, {});
    return builder.build(std::move(state));
}

} // namespace tractus::scene
