#include "engine/variation/subtree.h"

namespace tractus::variation {

std::vector<AxisRemainder> subtree_of(Plant const& plant, SegmentId segment)
{
    AxisId const first = axis_of(plant, segment);
    std::vector<AxisRemainder> subtree { { first, segment } };
    std::vector<bool> is_borne(plant.axes.size());
    for (AxisId id = first + 1; id < plant.axes.size(); ++id) { // Parents come before laterals.
        auto const& axis = plant.axes[id];
        if (axis.parent_axis == kNone)
            continue;
        is_borne[id] = axis.parent_axis == first ? axis.parent_segment >= segment
                                                 : is_borne[axis.parent_axis];
        if (is_borne[id])
            subtree.push_back({ id, axis.first_segment });
    }
    return subtree;
}

} // namespace tractus::variation
