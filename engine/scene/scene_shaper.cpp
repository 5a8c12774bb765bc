#include "engine/scene/scene_shaper.h"

#include "engine/variation/place_nodes.h"

#include <utility>
#include <vector>

namespace tractus {

Result<void> SceneShaper::set_scene(Scene const& scene)
{
    if (base_ != scene.base || rest_ != scene.rest) {
        base_ = scene.base;
        rest_ = scene.rest;
        shaper_.emplace(*base_, *rest_);
    }
    return shaper_->set(shaping_associations(scene));
}

Result<GrowthPlan> plan_growth(Scene const& scene, SceneShaper& shaper, std::stop_token const& stop)
{
    TRY(shaper.set_scene(scene));
    if (stop.stop_requested())
        return GrowthPlan {};
    auto const& shape = shaper.shape();
    std::vector<Vec3> nodes_mm;
    place_nodes(*scene.base, *scene.rest, shape, nodes_mm);
    auto influence = TRY(influence_of(*scene.base, nodes_mm, motion_indicators(scene),
                                      { scene.placement.shown_height_mm, scene.placement.scale }));
    auto const growth = TRY(at_variability(scene.growth.parameters, scene.growth.variability));
    if (stop.stop_requested())
        return GrowthPlan {};
    return plan_growth(*scene.base, *scene.rest, shape, growth, std::move(influence), stop);
}

Result<GrowthPlan> plan_growth(Scene const& scene)
{
    SceneShaper shaper;
    return plan_growth(scene, shaper);
}

} // namespace tractus
