#include "engine/variation/axis_age.h"

namespace tractus::variation {

std::vector<AxisAge> find_axis_ages(Plant const& plant, RestShape const& rest)
{
    std::vector<AxisAge> ages(plant.axes.size());
    auto const base_mm = [&](Axis const& axis) { return rest.end_mm[axis.parent_segment]; };
    for (AxisId id = 0; id < ages.size(); ++id)
        ages[id].reach_mm = rest.axis_length_mm[id];
    // A plant lists parents before laterals, so the reverse order goes from the tips to the ground.
    for (std::size_t id = ages.size(); id-- > 0;) {
        auto const& axis = plant.axes[id];
        if (axis.parent_axis == kNone)
            continue;
        auto& reach_mm = ages[axis.parent_axis].reach_mm;
        reach_mm = std::max(reach_mm, base_mm(axis) + ages[id].reach_mm);
    }
    for (AxisId id = 0; id < ages.size(); ++id) {
        auto const& axis = plant.axes[id];
        if (axis.parent_axis != kNone)
            ages[id].begin = ages[axis.parent_axis].birth_at(base_mm(axis));
    }
    return ages;
}

} // namespace tractus::variation
