#pragma once

#include "engine/base/vectors.h"
#include "engine/plant/plant.h"
#include "engine/variation/branch_tree.h"
#include "engine/variation/projected_skeleton.h"

#include <optional>
#include <vector>

namespace tractus::variation {

enum class SegmentState : unsigned char {
    Unselected,
    Selected,
    Undetermined, // Touched, but the pen has not yet shown whether it was meant.
};

// Decides what a pen meant that runs over a skeleton from below to the tips (Streit 2006
// section 4.1, figure 5): a sequence of segments, each the child of the one before.
//
// The first segment touched is selected. Children of the last selected one that are touched stay
// undetermined, however many, until one of their descendants is touched too: that shows which of
// them was meant. It is selected, with any segment that was skipped on the way, the others are not,
// and what was touched is undetermined in turn. What is not a descendant of the last selected
// segment is refused: there is no way back down, and no loss in trying. When the pen is lifted,
// what is still undetermined is selected.
class PathSelection {
public:
    // `tree` must outlive the selection.
    explicit PathSelection(BranchTree const& tree);

    // The pen has touched `segment`. True if any state changed.
    bool touch(SegmentId segment);

    // The pen was lifted. The selected segments from root to tip: one path, or, where several
    // segments were undetermined in the end, one for each of them, in the order of touching. None
    // if nothing was touched. The states stay to be seen until clear().
    std::vector<std::vector<SegmentId>> finish();

    // Nothing is selected any more.
    void clear();

    SegmentState state(SegmentId segment) const { return states_[segment]; }

    // The selected path from root to tip, and the segments that are undetermined.
    std::vector<SegmentId> const& selected() const { return path_; }
    std::vector<SegmentId> const& undetermined() const { return undetermined_; }

private:
    void select_down_to(SegmentId segment);

    BranchTree const& tree_;
    std::vector<SegmentState> states_;
    std::vector<SegmentId> path_;
    std::vector<SegmentId> undetermined_;
};

// A pen that draws over a projected skeleton; make one for each stroke. Between two of its samples
// the way is walked in steps of at most one unit of the plane, so that a fast hand misses no thin
// branch.
//
// The nearest segment in front is touched, as a painter's picture shows it, with one exception.
// Once a path has begun, a place where several branches lie over each other says only what they
// have in common: the last segment that all of them stand on is touched, and the pen's further way
// shows which of them was meant. So the trunk can be followed behind branches that grow towards the
// eye.
class SelectionPen {
public:
    // Skeleton, tree and selection must outlive the pen; the tree is the selection's.
    SelectionPen(ProjectedSkeleton const& skeleton, BranchTree const& tree,
                 PathSelection& selection, PickOptions const& options = {});

    // The pen is at `point` now. True if any state changed.
    bool move_to(Vec2 const& point);

    // The pen was lifted: where its last place was ambiguous, the nearest segment in front was
    // meant. Returns what PathSelection::finish() does.
    std::vector<std::vector<SegmentId>> lift();

private:
    bool touch_at(Vec2 const& point);
    std::optional<SegmentId> common() const;
    SegmentId beginning_of(SegmentId segment) const;
    bool begin(SegmentId front);

    ProjectedSkeleton const& skeleton_;
    BranchTree const& tree_;
    PathSelection& selection_;
    PickOptions options_;
    std::optional<Vec2> last_point_;
    std::optional<SegmentId> last_touched_;
    // The segment in front at the last place, if that was ambiguous.
    std::optional<SegmentId> ambiguous_;
    std::vector<SegmentId> beginnings_; // Segments that lay under the pen where it came down.
    std::vector<SegmentId> covering_;   // Segments that could be meant at the present place.
};

} // namespace tractus::variation
