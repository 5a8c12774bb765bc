#pragma once

#include "engine/base/result.h"
#include "engine/plant/branch_address.h"
#include "engine/scene/anchored.h"
#include "engine/scene/edit_kind.h"
#include "engine/stroke/ink_width.h"
#include "engine/stroke/stroke.h"
#include "engine/variation/limb.h"

#include <utility>
#include <vector>

namespace tractus::scene {

struct BuiltPlant;
struct Graft;
struct PlantState;

// Edits of limbs: branches that a stroke adds to a plant, with twigs like those of the plant's own
// branches (limb.h). A limb is a part of its plant (Graft): it is selected, shaped, varied and
// exported like all other branches.

// A limb of a document's plant.
struct DrawnLimb {
    ItemId id = 0;
    // Position of the joint on its segment (Graft::at): 0 is the segment's base, 1 its end.
    double joint = 1;
    // Points of the limb from where the stroke begins, relative to that place. Plant frame at rest,
    // millimetres at the plant's natural size; at least two distinct ones.
    std::vector<variation::LimbPoint> points {};
    // Strokes that were there when the limb was drawn, and shape all that a branch bears: they
    // leave the limb as it was drawn.
    std::vector<ItemId> older_strokes {};
};

// Adds a limb to a plant.
struct DrawLimb {
    static EditKind const kKind;

    ItemId plant = 0;
    SegmentAddress at {}; // The segment that the limb is joined to.
    double joint = 1;     // Where on that segment, as in DrawnLimb.
    // Where the plant showed that place when the limb was drawn, and how it was turned there: the
    // rotation from the segment as strokes had bent it to the segment at rest, as a rotation vector
    // (axis times angle, radians). World frame.
    Vec3 joint_mm = Vec3::Zero();
    Vec3 turn_rad = Vec3::Zero();
    double scale = 1;               // World millimetres per plant millimetre; above 0.
    double width_mm = kInkWidth_mm; // Thickness at full pressure, world frame; ink_width_share().
    Stroke stroke {};               // World frame.
    ItemId id = 0;                  // 0 if not assigned yet.
};

// Removes a limb with everything drawn on it, and limbs that were drawn on it.
struct EraseLimb {
    static EditKind const kKind;

    ItemId plant = 0;
    ItemId limb = 0;
};

// Returns the points of the limb that an edit draws, as in DrawnLimb. Fails, in one sentence, if
// the stroke has no direction or a value is out of range.
Result<std::vector<variation::LimbPoint>> limb_points(DrawLimb const& edit);

// Returns the id of the limb to which an address of a plant belongs, the innermost if limbs bear
// limbs; 0 if there is none.
ItemId limb_at(PlantState const& plant, SegmentAddress const& address);

// Returns the limbs of a built plant with their first segments, without limbs that are not there at
// present. Valid as long as the plant.
std::vector<std::pair<Graft const*, SegmentId>> limb_segments(BuiltPlant const& plant);

} // namespace tractus::scene
