#pragma once

#include "engine/base/vectors.h"
#include "engine/plant/plant.h"

#include <vector>

namespace tractus {

// Appends the axes, organs, polygons, materials and shapes of another plant, translated by
// `moved_mm`. The order within both is kept.
void append_plant(Plant& plant, Plant const& other, Vec3 const& moved_mm);

// Placement of a plant that becomes a part of another.
struct PartPlace {
    // Segment of the whole plant to whose end the part is attached; kNone: on the ground.
    SegmentId on = kNone;
    // Transform from the part's frame to the whole's: rotated by `turn`, then translated by
    // `moved_mm`.
    Quat turn = Quat::Identity();
    Vec3 moved_mm = Vec3::Zero();
};

// Appends a plant as a part of another, without the segments marked in `hidden` and their
// descendants; an empty list hides nothing. If the part is attached to a segment, its stems begin
// at that segment's end, wherever their first nodes were; everything else is placed by `place`.
//
// Returns the number of each of the part's segments in the whole, kNone for hidden ones.
std::vector<SegmentId> append_part(Plant& plant, Plant const& part, PartPlace const& place,
                                   std::vector<bool> const& hidden = {});

} // namespace tractus
