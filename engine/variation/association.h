#pragma once

#include "engine/base/result.h"
#include "engine/plant/plant.h"
#include "engine/stroke/frames.h"
#include "engine/stroke/stroke.h"

#include <span>
#include <vector>

namespace tractus {

// Which branches take a stroke's shape (Streit 2006 section 4.3).
enum class Propagation {
    Selected,    // Those of the path.
    Descendants, // Every branch that the path bears, down to the leaf branches, and not the path.
    Both,
};

// "These branches shall have this shape."
struct Association {
    std::vector<SegmentId>
        path {};      // From root to tip, each the child of the one before. At least one.
    Stroke stroke {}; // World frame, at any scale: only its shape counts.
    Propagation propagation = Propagation::Selected;
    double kept_hand = 1; // How much of the hand's tremor stays, 0 to 1: see smooth_hand.
};

// The shape that strokes give to a plant, before it grows: a direction for every segment. Plant
// frame. `frame` has each segment's direction and a normal that turns as little as possible along
// the axis; `rotation` takes the base plant's surroundings of the segment to where they are now, so
// it is what anything that rides on the segment does.
struct PredefinedShape {
    std::vector<Frame> frame {};
    std::vector<Quat> rotation {};
};

// Bends the branches of `plant` to the strokes. Topology and segment lengths stay.
//
// A path takes its stroke by arc length: the points that divide the stroke as the path's joints
// divide the path give the directions. Before that the whole stroke is turned, with least twist, so
// that it starts (its first twentieth does, since single samples tremble) in the direction in which
// the path's first segment points in the base plant. What the path's first segment stands on may
// itself be bent; the path rides on it as it rode in the base plant.
//
// A descendant axis takes the same stroke in its own base frame, as the path takes it in its own.
// The base frame of a branch has the branch's direction, and its normal leans towards the direction
// of what bears it (for the trunk: towards +x). So what bends the path towards its bearer bends all
// descendants towards theirs, and each branch starts as it did in the base plant.
//
// Whatever has no stroke keeps its base shape and is carried along rigidly: axes without
// association, and the rest of an axis after a path's end. Where associations meet on a segment the
// last one wins; what it does not reach rides on it.
//
// Refuses, in a sentence, a path that is empty, not in the plant or not sequential, a stroke that
// has no direction (stroke_points), and a kept_hand outside of 0 to 1.
Result<PredefinedShape> resolve_associations(Plant const& plant,
                                             std::span<Association const> associations);

} // namespace tractus
