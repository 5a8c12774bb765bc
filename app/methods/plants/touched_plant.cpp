#include "app/methods/plants/touched_plant.h"

namespace tractus::plants {

Result<std::shared_ptr<scene::BuiltPlant const>> plant_under(TipSample const& tip,
                                                             scene::Scene const& scene)
{
    constexpr double kFinger_mm = 15;
    std::shared_ptr<scene::BuiltPlant const> nearest;
    double nearest2_mm2 = kFinger_mm * kFinger_mm;
    for (auto const& plant : scene.plants) {
        if (plant->drawn->is_hidden)
            continue;
        for (auto const& node_mm : plant->base->node_position_mm) {
            Vec3 const at_mm = plant->placement.world_of_plant(node_mm);
            double const distance2_mm2 = (at_mm - tip.position_mm).head<2>().squaredNorm();
            if (distance2_mm2 >= nearest2_mm2)
                continue;
            nearest2_mm2 = distance2_mm2;
            nearest = plant;
        }
    }
    if (!nearest)
        return fail(Fault::User, "there is no plant here: touch one where the pad shows it");
    return nearest;
}

Result<scene::ItemId> active_plant_of(scene::Scene const& scene)
{
    if (scene.state.active == 0)
        return fail(Fault::User, "there is no plant: draw one, or load a model");
    return scene.state.active;
}

} // namespace tractus::plants
