#pragma once

#include "engine/base/result.h"
#include "engine/base/shared_vector.h"
#include "engine/plant/plant.h"
#include "engine/stroke/stroke.h"
#include "engine/variation/rest_shape.h"

#include <span>
#include <vector>

namespace tractus::variation {

// Chooses the branches that take a stroke's shape (Streit 2006 section 4.3).
enum class Propagation {
    Selected,    // The path's own branches.
    Descendants, // Every branch that the path bears, down to the leaf branches, and not the path.
    Both,
};

// How a stroke is laid along a branch. Segment lengths and topology stay in any case, and so does
// the branch's base; the stroke is followed by arc length.
enum class StrokeFit {
    // The stroke is turned (StrokeLaying says how) so that it starts in the direction in which the
    // branch starts in the base plant. Its first twentieth does, since single samples tremble.
    Start,
    // As Start, but so that it leads from its first point to its last in the direction from the
    // branch's base to its tip: the tip stays where it was seen from the base, only nearer or
    // farther.
    Chord,
    // The stroke is not turned at all: each segment points as it was drawn, whatever its parent
    // does.
    World,
};

// How a stroke that is fitted by its start or its chord gets its direction.
enum class StrokeLaying {
    // By the least rotation, and along descendants in the base frames of the branches. What the
    // hand drew hanging may come out rising, so this is only for what was drawn before the other
    // law was there: sessions and logs that do not say how are read so.
    LeastTwist,
    // By heading and pitch (stroke_laying.h): what hangs as it is drawn hangs along each branch. A
    // trunk, and any axis that stands on nothing, takes the stroke as it lies in the world.
    HeadingAndPitch,
};

// A stroke that shapes branches, whichever they are.
struct ShapingStroke {
    Stroke stroke {}; // As in Association, as the next ones.
    Propagation propagation = Propagation::Selected;
    StrokeFit fit = StrokeFit::Start;
    double detail_weight = 1;
    StrokeLaying laying = StrokeLaying::LeastTwist;
};

// "These branches shall have this shape."
struct Association {
    // Segments from root to tip, each the child of the one before. At least one.
    SharedVector<SegmentId> path {};
    Stroke stroke {}; // World frame, at any scale: only its shape counts.
    Propagation propagation = Propagation::Selected;
    StrokeFit fit = StrokeFit::Start;
    double detail_weight = 1; // How much of the hand's tremor stays, 0 to 1: see smooth_hand.
    StrokeLaying laying = StrokeLaying::LeastTwist;

    // The plant has lost the path, so the stroke shapes nothing. Kept, since the branch may come
    // back.
    bool is_orphaned = false;
};

// The shape that strokes give to a plant, before it grows: a frame for every segment as those of
// RestShape are, but that of the axis' base is where what bears it has carried it.
struct PredefinedShape {
    std::vector<Quat> frame {};
};

// Refuses, in a sentence, a path that is empty, not in the plant or not sequential, a stroke that
// has no direction (stroke_points) or, for StrokeFit::Chord, ends where it began, and a
// detail_weight outside of 0 to 1. An orphaned association is fine.
Result<void> check_association(Plant const& plant, Association const& association);

// Refuses of that what is the stroke's, whatever plant it is for.
Result<void> check_shaping_stroke(ShapingStroke const& stroke);

// Bends the branches of `plant`, of which `rest` is the shape, to the strokes. Topology and segment
// lengths stay.
//
// A path takes its stroke by arc length: the points that divide the stroke as the path's joints
// divide the path give the directions. What the path's first segment stands on may itself be bent;
// the path rides on it as it rode in the base plant, unless the stroke is laid as in the world.
//
// By heading and pitch, each descendant axis takes the stroke in the vertical plane of its own
// direction, where what bears it has carried it. By least twist it takes it in its own base frame
// (RestShape), as the path takes it in its own: what bends the path towards its parent bends all
// descendants towards theirs. Either way each branch starts as it did in the base plant. As in the
// world, all of them point as was drawn.
//
// Whatever has no stroke keeps its base shape and is carried along rigidly: axes without
// association, and the rest of an axis after a path's end. Where associations meet on a segment the
// last one wins, and without it the one before; what it does not reach rides on it.
//
// Refuses what check_association refuses.
Result<PredefinedShape> resolve_associations(Plant const& plant, RestShape const& rest,
                                             std::span<Association const> associations);

} // namespace tractus::variation
