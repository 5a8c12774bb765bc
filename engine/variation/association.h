#pragma once

#include "engine/base/result.h"
#include "engine/base/shared_vector.h"
#include "engine/plant/plant.h"
#include "engine/stroke/stroke.h"
#include "engine/variation/rest_shape.h"

#include <span>
#include <vector>

namespace tractus::variation {

// The branches to which a stroke is applied, given the path that was selected for it (Streit 2006,
// section 4.3).
enum class Propagation {
    Selected, // The segments of the path.
    // All axes that descend from the path, but not the path itself.
    Descendants,
    Both,
};

// How a stroke is aligned with a branch. Segment lengths, topology and the branch's base never
// change; the stroke is followed by arc length.
enum class StrokeFit {
    // The stroke is rotated (see StrokeLaying) so that its start has the direction in which the
    // branch starts in the base plant. The start is the first twentieth of the stroke, since single
    // samples are noisy.
    Start,
    // The chord of the stroke, from its first to its last point, is aligned with the chord of the
    // branch, from base to tip. The tip keeps its direction as seen from the base; only its
    // distance changes.
    Chord,
    // The stroke is not rotated: each segment has the direction in which it was drawn, regardless
    // of its parent.
    World,
};

// How the rotation is chosen for a stroke with StrokeFit::Start or StrokeFit::Chord.
enum class StrokeLaying {
    // The least rotation; on descendants, the least rotation in the base frame of each branch. A
    // branch may rise under a stroke that was drawn drooping. So this law is used only for strokes
    // made before HeadingAndPitch existed: it is the default for sessions and logs that name no
    // law.
    LeastTwist,
    // By heading and pitch (stroke_laying.h): a stroke drawn drooping droops along each branch. A
    // trunk, and any axis without a parent, takes the stroke as drawn in the world.
    HeadingAndPitch,
};

// A stroke that shapes branches, and how it does so, whichever branches they are.
struct ShapingStroke {
    Stroke stroke {}; // This and the following fields have the same meaning as in Association.
    Propagation propagation = Propagation::Selected;
    StrokeFit fit = StrokeFit::Start;
    double detail_weight = 1;
    StrokeLaying laying = StrokeLaying::LeastTwist;
    // True if `stroke` is the reverse of what the pen drew. Has no effect on branches.
    bool is_drawn_reversed = false;
};

// Applies the shape of a stroke to branches.
struct Association {
    // Segments from root to tip, each a child of the one before; at least one.
    SharedVector<SegmentId> path {};
    Stroke stroke {}; // World frame, at any scale: only its shape matters.
    Propagation propagation = Propagation::Selected;
    StrokeFit fit = StrokeFit::Start;
    double detail_weight
        = 1; // Share of the stroke's fine detail that is kept, 0 to 1 (smooth_hand_line()).
    StrokeLaying laying = StrokeLaying::LeastTwist;

    // Descendants of the path that do not take the stroke, in ascending order: limbs that were
    // drawn later. Branches attached to them do take the stroke.
    std::vector<AxisId> spared {};

    // True if the path no longer exists in the plant, so that the stroke has no effect. Such an
    // association is kept, since the branch may come back.
    bool is_orphaned = false;
};

// The shape of a plant bent by its strokes, before growth: a frame for every segment. Frames have
// the same meaning as in RestShape, except that the frame at an axis' base is rotated with the bent
// parent.
struct PredefinedShape {
    std::vector<Quat> frame {};
};

// Fails, in one sentence, if the path is empty, not in the plant or not sequential, the stroke has
// no direction (stroke_points) or, for StrokeFit::Chord, ends where it began, or detail_weight is
// outside 0 to 1. An orphaned association is valid.
Result<void> check_association(Plant const& plant, Association const& association);

// Makes only those checks of check_association() that do not depend on the plant.
Result<void> check_shaping_stroke(ShapingStroke const& stroke);

// Bends the branches of `plant`, whose rest shape is `rest`, according to the strokes. Topology and
// segment lengths are unchanged.
//
// A path follows its stroke by arc length. The stroke is divided in the same proportions as the
// segments divide the path, and each segment gets the direction of the chord of its piece. If the
// parent of the path's first segment is bent, the path moves with the parent rigidly, except with
// StrokeFit::World.
//
// With HeadingAndPitch each descendant axis takes the stroke in the vertical plane of its own
// direction, after its parent has been bent. With LeastTwist it takes the stroke in its own base
// frame (RestShape), as the path does: a stroke that bends the path towards its parent bends each
// descendant towards its own parent. With both laws each branch starts as in the base plant. With
// StrokeFit::World all branches have the directions drawn.
//
// Segments without a stroke keep their base shape and move rigidly: axes without an association,
// and the rest of an axis beyond a path's end. Where several associations apply to a segment, the
// last one shapes it. Segments of the axis that the last one does not cover keep their shape
// relative to those below them.
//
// Fails like check_association().
Result<PredefinedShape> resolve_associations(Plant const& plant, RestShape const& rest,
                                             std::span<Association const> associations);

} // namespace tractus::variation
