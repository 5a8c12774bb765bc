#include "engine/plant/limbs.h"

#include <algorithm>

namespace tractus {

namespace {

// For each axis: the axis that goes on where it ends, and whether it is itself such a continuation.
struct Continuations {
    std::vector<AxisId> next;
    std::vector<bool> continues;
};

SegmentId last_segment(Axis const& axis)
{
    return axis.first_segment + axis.segment_count - 1;
}

Continuations find_continuations(Plant const& plant)
{
    auto const base_radius_mm
        = [&](AxisId id) { return plant.node_radius_mm[plant.axes[id].first_node]; };
    Continuations result { std::vector<AxisId>(plant.axes.size(), kNone),
                           std::vector<bool>(plant.axes.size(), false) };
    for (AxisId id = 0; id < plant.axes.size(); ++id) {
        auto const parent = plant.axes[id].parent_axis;
        if (parent == kNone || plant.axes[id].parent_segment != last_segment(plant.axes[parent]))
            continue;
        auto& next = result.next[parent];
        if (next == kNone || base_radius_mm(id) > base_radius_mm(next))
            next = id;
    }
    for (auto const next : result.next)
        if (next != kNone)
            result.continues[next] = true;
    return result;
}

} // namespace

std::vector<Limb> limbs(Plant const& plant)
{
    auto const continuations = find_continuations(plant);
    std::vector<Limb> result;
    std::vector<std::uint32_t> limb_of_axis(plant.axes.size(), 0);
    for (AxisId id = 0; id < plant.axes.size(); ++id) {
        if (continuations.continues[id])
            continue; // Its limb began further down.
        Limb limb;
        // Parents come before their children, so the bearer's limb is known.
        auto const bearer = plant.axes[id].parent_axis;
        limb.order = bearer == kNone ? 0 : result[limb_of_axis[bearer]].order + 1;
        for (AxisId part = id; part != kNone; part = continuations.next[part]) {
            auto const& axis = plant.axes[part];
            for (std::uint32_t i = 0; i < axis.segment_count; ++i)
                limb.path.push_back(axis.first_segment + i);
            limb.length_mm += axis_length_mm(plant, axis);
            limb_of_axis[part] = static_cast<std::uint32_t>(result.size());
        }
        result.push_back(std::move(limb));
    }
    std::stable_sort(result.begin(), result.end(), [](Limb const& a, Limb const& b) {
        return a.order != b.order ? a.order < b.order : a.length_mm > b.length_mm;
    });
    return result;
}

} // namespace tractus
