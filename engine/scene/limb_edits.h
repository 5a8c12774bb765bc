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

// Edits of limbs. A limb is a branch that a stroke adds to a plant, with twigs like those of the
// plant's own branches (limb.h). It is a part of its plant (Graft): it is selected, shaped, varied
// and exported like all other branches.

// A limb of a document's plant.
struct DrawnLimb {
    ItemId id = 0;
    // Position of the joint on its segment (Graft::at): 0 is the segment's base, 1 its end.
    double joint = 1;
    // Points of the limb relative to the joint, in the order of the stroke. Plant frame at rest,
    // millimetres at the plant's natural size; at least two distinct ones.
    std::vector<variation::LimbPoint> points {};
    // Ids of earlier strokes that shape all descendants of a branch. These strokes do not shape the
    // limb, which stays as it was drawn.
    std::vector<ItemId> older_strokes {};
    bool is_drawn_reversed = false; // As in DrawLimb.
};

// Adds a limb to a plant.
struct DrawLimb {
    static EditKind const kKind;

    ItemId plant = 0;
    SegmentAddress at {}; // The segment that the limb is joined to.
    double joint = 1; // Position of the joint on the segment: 0 is the segment's base, 1 its end.
    // Where the joint was displayed when the limb was drawn, and the rotation from the segment as
    // bent by strokes to the segment at rest. World frame; the rotation is a rotation vector (axis
    // times angle, radians).
    Vec3 joint_mm = Vec3::Zero();
    Vec3 turn_rad = Vec3::Zero();
    double scale = 1; // World millimetres per plant millimetre; above 0.
    // Thickness of the limb at full pressure, world frame (ink_width.h).
    double width_mm = kInkWidth_mm;
    Stroke stroke {}; // The stroke that draws the limb, world frame.
    ItemId id = 0;    // Id of the limb; 0 if not assigned yet.
    // True if the limb was drawn from tip to foot, so that `stroke` is its reverse (foot_first.h).
    bool is_drawn_reversed = false;
};

// Removes a limb with everything drawn on it, including further limbs.
struct EraseLimb {
    static EditKind const kKind;

    ItemId plant = 0;
    ItemId limb = 0;
};

// Returns the points of the limb that an edit draws, relative to the limb's joint
// (DrawnLimb::points). Fails, in one sentence, if the stroke has no direction or a value is out of
// range.
Result<std::vector<variation::LimbPoint>> limb_points(DrawLimb const& edit);

// Returns the id of the limb that an address of the plant belongs to, or 0 if the innermost part
// that contains the address is not a limb.
ItemId limb_at(PlantState const& plant, SegmentAddress const& address);

// Returns the limbs of a built plant, each with its first segment. Limbs without segments, because
// they are hidden or their branch is missing, are left out. The pointers are valid as long as the
// plant exists.
std::vector<std::pair<Graft const*, SegmentId>> limb_segments(BuiltPlant const& plant);

} // namespace tractus::scene
