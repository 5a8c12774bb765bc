#pragma once

#include "engine/base/vectors.h"
#include "engine/plant/plant.h"

#include <optional>
#include <vector>

namespace tractus {

// Appends the axes, organs, polygons, materials and shapes of another plant, translated by
// `moved_mm`. The axes and organs of each plant keep their order.
void append_plant(Plant& plant, Plant const& other, Vec3 const& moved_mm);

// Where the materials, organ shapes and contours of a part begin in the lists of the whole plant.
struct AppearanceOffsets {
    MaterialId material = 0;
    OrganShapeId shape = 0;
    ContourId contour = 0;
};

// Returns the numbers that the first material, shape and contour of the next part will get.
AppearanceOffsets next_appearance_offsets(Plant const& plant);

// Placement of a plant that becomes a part of another.
struct PartPlace {
    // Segment of the whole plant to whose end the part is attached; kNone: on the ground.
    SegmentId on = kNone;
    // Transform from the part's frame to the whole plant's: a rotation by `turn`, then a
    // translation by `moved_mm`.
    Quat turn = Quat::Identity();
    Vec3 moved_mm = Vec3::Zero();
    // True: the part's stems begin where `turn` and `moved_mm` place them. False: if the part is
    // attached to a segment, its stems begin at the end of that segment instead.
    bool keeps_base = false;
    // Offsets of an earlier part whose materials, shapes and contours this part shares because they
    // are the same. No value: the part's own are appended.
    std::optional<AppearanceOffsets> looks {};
};

// Appends a plant as a part of another, without the segments marked in `hidden` and their
// descendants; an empty list hides nothing.
//
// Returns, for each segment of the part, its number in the whole plant; kNone for hidden segments.
std::vector<SegmentId> append_part(Plant& plant, Plant const& part, PartPlace const& place,
                                   std::vector<bool> const& hidden = {});

} // namespace tractus
