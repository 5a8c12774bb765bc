#include "engine/scene/derive_anew.h"

#include "engine/scene/lsystem_source.h"
#include "engine/scene/make_edit_kind.h"
#include "engine/scene/varied_scene.h"

#include <algorithm>
#include <fmt/core.h>
#include <utility>

namespace tractus::scene {

namespace {

void list(Fields& fields, DeriveAnew& edit)
{
    fields.field("plant", &edit.plant);
    fields.field("seeds", &edit.seeds);
    fields.field("strokes", &edit.strokes);
    fields.field("at", &edit.at);
}

void derive_by(PlantSource& source, std::uint64_t seed)
{
    if (auto other = with_model_seed(source, seed))
        source = *std::move(other);
}

Result<DocumentState> applied(DocumentState state, DeriveAnew const& edit, SceneBuilder&)
{
    auto const number = TRY(plant_number(state, edit.plant));
    auto const& before = *state.plants[number];
    if (edit.seeds.size() != 1 + before.grafts.size() || edit.strokes.size() != edit.at.size())
        return fail(
            Fault::User,
            fmt::format("plant {} cannot be derived anew: {} seeds for {} plants, {} places "
                        "for {} strokes",
                        name_of(edit.plant), edit.seeds.size(), 1 + before.grafts.size(),
                        edit.at.size(), edit.strokes.size()));
    change_plant(state, number, [&](PlantState& plant) {
        derive_by(plant.source, edit.seeds.front());
        for (std::size_t i = 0; i < plant.grafts.size(); ++i)
            derive_by(plant.grafts[i].source, edit.seeds[i + 1]);
        for (std::size_t i = 0; i < plant.strokes.size(); ++i) {
            auto const found = std::ranges::find(edit.strokes, plant.strokes[i].id);
            if (found == edit.strokes.end())
                continue;
            auto stroke = plant.strokes[i];
            stroke.at = { edit.at[static_cast<std::size_t>(found - edit.strokes.begin())] };
            plant.strokes.replace(i, std::move(stroke));
        }
    });
    return state;
}

std::string described(DeriveAnew const& edit)
{
    return fmt::format("derives plant {} by other seeds", name_of(edit.plant));
}

// Returns the seeds of a plant's model and of those grafted to it; 0 for what is not a model.
std::vector<std::uint64_t> seeds_of(PlantState const& plant)
{
    auto const seed_of = [](PlantSource const& source) {
        auto const* const model = loaded_model(source);
        return model ? model->seed : 0;
    };
    std::vector<std::uint64_t> seeds { seed_of(plant.source) };
    for (auto const& graft : plant.grafts)
        seeds.push_back(seed_of(graft.source));
    return seeds;
}

} // namespace

std::optional<DeriveAnew> derive_anew(Scene const& scene, variation::PlantKey const& key,
                                      double share)
{
    auto const* const before = active_plant(scene.state);
    if (!before)
        return std::nullopt;
    auto const alone = active_plant_alone(scene);
    SeedAssignment const own_seeds(alone, share);
    if (!own_seeds.has(key))
        return std::nullopt;
    auto const own = own_seeds.scene_of(alone, key);
    auto const& after = *active_plant(own.state);
    DeriveAnew edit { .plant = before->id, .seeds = seeds_of(after) };
    for (std::size_t i = 0; i < after.strokes.size(); ++i) {
        auto const& at = after.strokes[i].at;
        if (at.size() != 1 || at.vector() == before->strokes[i].at.vector())
            continue;
        edit.strokes.push_back(after.strokes[i].id);
        edit.at.push_back(at[0]);
    }
    if (edit.strokes.empty() && edit.seeds == seeds_of(*before))
        return std::nullopt; // No other seed keeps all that was drawn.
    return edit;
}

constexpr EditKind DeriveAnew::kKind
    = make_edit_kind<DeriveAnew, list, applied, described>("derive_anew");

} // namespace tractus::scene
