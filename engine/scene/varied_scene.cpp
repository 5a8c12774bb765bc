#include "engine/scene/varied_scene.h"

#include "engine/scene/scene_builder.h"

#include <algorithm>
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
                ++of_part.stream; // So that identical parts vary differently.
                graft.source = graft.source.varied(of_part);
            }
        });
    SceneBuilder builder(scene, {});
    return builder.build(std::move(state));
}

} // namespace tractus::scene
