#include "engine/variation/place_nodes.h"

#include "engine/base/check.h"
#include "engine/stroke/frame_rotation.h"

namespace tractus::variation {

void place_nodes(Plant const& plant, RestShape const& rest, PredefinedShape const& shape,
                 std::vector<Vec3>& nodes_mm)
{
    CHECK(shape.frame.size() == plant.segment_count());
    nodes_mm.resize(plant.node_position_mm.size());
    auto const place = [&](AxisId id) {
        auto const& axis = plant.axes[id];
        Vec3 position_mm = plant.node_position_mm[axis.first_node];
        if (axis.parent_segment != kNone) {
            auto const& parent = plant.axes[axis.parent_axis];
            auto const node = parent.first_node + (axis.parent_segment - parent.first_segment) + 1;
            Vec3 const gap_mm = position_mm - plant.node_position_mm[node];
            position_mm = nodes_mm[node];
            if (!gap_mm.isZero(0))
                position_mm += shape.frame[axis.parent_segment]
                    * (rest.frame[axis.parent_segment].conjugate() * gap_mm);
        }
        nodes_mm[axis.first_node] = position_mm;
        for (std::uint32_t i = 0; i < axis.segment_count; ++i) {
            auto const segment = axis.first_segment + i;
            position_mm += rest.length_mm[segment] * tangent_of(shape.frame[segment]);
            nodes_mm[axis.first_node + i + 1] = position_mm;
        }
    };
    for_each_level(rest.levels, [&](std::span<AxisId const> axes) {
        for (auto const id : axes)
            place(id);
    });
}

} // namespace tractus::variation
