#pragma once

#include "engine/base/vectors.h"
#include "engine/plant/plant.h"

#include <vector>

namespace tractus {

// Adds another plant to a plant, moved: its axes, organs, polygons, materials and shapes behind
// those that are there. Both keep their order.
void append_plant(Plant& plant, Plant const& other, Vec3 const& moved_mm);

// Where a plant stands that becomes a part of another.
struct PartPlace {
    // The segment of the whole on whose end it stands; kNone: on the ground.
    SegmentId on = kNone;
    // Takes the part's frame to the whole's: first turned, then moved.
    Quat turn = Quat::Identity();
    Vec3 moved_mm = Vec3::Zero();
};

// Adds a plant as a part of another, behind what is there, without the segments that `hidden` marks
// and all that they bear; an empty list hides nothing. Where it stands on a segment its stems begin
// at that segment's end, wherever their first nodes were; all else is where the place says.
//
// Returns the number that each segment of the part has in the whole; kNone: it is hidden.
std::vector<SegmentId> append_part(Plant& plant, Plant const& part, PartPlace const& place,
                                   std::vector<bool> const& hidden = {});

} // namespace tractus
