#pragma once

#include "engine/plant/plant.h"

namespace tractus {

// Returns a vertical trunk of three segments of 100 mm with a lateral axis of two segments of 50
// mm. The axis leads to the right (+x) from the end of the trunk's first segment, and has a leaf at
// its tip.
inline Plant small_plant()
{
    Plant plant;
    plant.materials = { Material {}, Material { .name = "leaf", .kind = Material::Kind::Leaf } };
    plant.organ_shapes = { OrganShape { .material = 1 } };
    plant.axes = {
        Axis { .first_node = 0, .first_segment = 0, .segment_count = 3 },
        Axis { .first_node = 4,
               .first_segment = 3,
               .segment_count = 2,
               .parent_segment = 0,
               .parent_axis = 0,
               .order = 1 },
    };
    plant.node_position_mm = { { 0, 0, 0 },   { 0, 0, 100 },  { 0, 0, 200 },  { 0, 0, 300 },
                               { 0, 0, 100 }, { 50, 0, 100 }, { 100, 0, 100 } };
    plant.node_radius_mm = { 10, 8, 6, 4, 3, 2, 1 };
    plant.segment_material = { 0, 0, 0, 0, 0 };
    plant.organs = { Organ { .shape = 0, .segment = 4, .position_mm = { 100, 0, 100 } } };
    return plant;
}

} // namespace tractus
