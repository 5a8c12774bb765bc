#include "app/tools/bent_plant.h"

#include "engine/variation/place_nodes.h"

namespace tractus::tools {

BentPlant::BentPlant(scene::BuiltPlant const& plant)
    : plant_(plant)
{
    static_cast<void>(shaper_.set_plant(plant));
    variation::place_nodes(*plant.base, *plant.rest, shaper_.shape(), nodes_mm_);
}

Vec3 BentPlant::begin_of(SegmentId segment) const
{
    return plant_.placement.world_of_plant(nodes_mm_[nodes_of(*plant_.base, segment).base]);
}

Vec3 BentPlant::end_of(SegmentId segment) const
{
    return plant_.placement.world_of_plant(nodes_mm_[nodes_of(*plant_.base, segment).tip]);
}

Quat BentPlant::turn_of(SegmentId segment) const
{
    constexpr double kNothing = 1e-9;
    Quat const turn = shaper_.shape().frame[segment] * plant_.rest->frame[segment].conjugate();
    return turn.angularDistance(Quat::Identity()) < kNothing ? Quat::Identity() : turn;
}

} // namespace tractus::tools
