#include "engine/scene/scene_shaper.h"

#include "engine/variation/place_nodes.h"

#include <utility>
#include <vector>

namespace tractus::scene {

Result<void> SceneShaper::set_plant(BuiltPlant const& plant)
{
    if (base_ != plant.base || rest_ != plant.rest) {
        base_ = plant.base;
        rest_ = plant.rest;
        shaper_.emplace(*base_, *rest_);
    }
    return shaper_->set(shaping_associations(plant));
}

Result<variation::GrowthPlan> plan_growth(BuiltPlant const& plant, SceneShaper& shaper,
                                          std::stop_token const& stop)
{
    TRY(shaper.set_plant(plant));
    if (stop.stop_requested())
        return variation::GrowthPlan {};
    auto const& shape = shaper.shape();
    std::vector<Vec3> nodes_mm;
    variation::place_nodes(*plant.base, *plant.rest, shape, nodes_mm);
    auto indicators = motion_indicators(plant);
    // Moves the indicators to coordinates in which the plant's base is at the origin.
    for (auto& indicator : indicators) {
        indicator.start_mm -= plant.placement.origin_mm;
        indicator.end_mm -= plant.placement.origin_mm;
    }
    auto influence
        = TRY(variation::influence_of(*plant.base, nodes_mm, indicators,
                                      { plant.placement.shown_height_mm, plant.placement.scale }));
    auto const growth
        = TRY(variation::at_variability(plant.growth.parameters, plant.growth.variability));
    if (stop.stop_requested())
        return variation::GrowthPlan {};
    return variation::plan_growth(*plant.in_season, *plant.rest, shape, growth,
                                  std::move(influence), stop);
}

Result<variation::GrowthPlan> plan_growth(BuiltPlant const& plant)
{
    SceneShaper shaper;
    return plan_growth(plant, shaper);
}

} // namespace tractus::scene
