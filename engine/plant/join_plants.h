#pragma once

#include "engine/base/vectors.h"
#include "engine/plant/plant.h"

#include <optional>
#include <vector>

namespace tractus {

// Appends the axes, organs, polygons, materials and shapes of another plant, translated by
// `moved_mm`. The order within both plants is kept.
void append_plant(Plant& plant, Plant const& other, Vec3 const& moved_mm);

// Numbers in a plant of the first material, organ shape and contour of one of its parts.
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
    // Transform from the part's frame to the whole's: rotated by `turn`, then translated by
    // `moved_mm`.
    Quat turn = Quat::Identity();
    Vec3 moved_mm = Vec3::Zero();
    // False: a part attached to a segment begins at that segment's end, wherever its stems' first
    // nodes were. True: its stems begin where `turn` and `moved_mm` place them.
    bool keeps_base = false;
    // Offsets of an earlier part with the same materials, shapes and contours, which this part then
    // shares. Default: those of this part are appended.
    std::optional<AppearanceOffsets> looks {};
};

// Appends a plant as a part of another, without the segments marked in `hidden` and their
// descendants; an empty list hides nothing.
//
// Returns the number of each of the part's segments in the whole, kNone for hidden ones.
std::vector<SegmentId> append_part(Plant& plant, Plant const& part, PartPlace const& place,
                                   std::vector<bool> const& hidden = {});

} // namespace tractus
