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
    Undetermined, // Touched, but the pen has not yet shown which of the touched segments is meant.
};

// Interprets a pen stroke over a skeleton, from base to tip, as a path: a sequence of segments,
// each a child of the one before (Streit 2006, section 4.1, figure 5).
//
// The first segment touched is selected. Touched children of the last selected segment remain
// undetermined until a descendant of one of them is touched, which shows that this child was meant.
// Then the child and the segments between it and the touched one are selected, the other children
// are unselected, and the touched segment becomes undetermined. Touched segments that are not
// descendants of the last selected one are ignored. When the pen is lifted, all undetermined
// segments are selected.
class PathSelection {
public:
    // `tree` must outlive the selection.
    explicit PathSelection(BranchTree const& tree);

    // Handles a touch of `segment`. Returns true if any state changed.
    bool touch(SegmentId segment);

    // Handles lifting the pen. Returns the selected segments, from root to tip, as one path. If
    // several segments were undetermined at the end, returns one path for each of them, in the
    // order of touching; if nothing was touched, no path. state() keeps its answers until clear().
    std::vector<std::vector<SegmentId>> finish();

    // Unselects all segments.
    void clear();

    SegmentState state(SegmentId segment) const { return states_[segment]; }

    // selected(): the selected path from root to tip. undetermined(): the undetermined segments.
    std::vector<SegmentId> const& selected() const { return path_; }
    std::vector<SegmentId> const& undetermined() const { return undetermined_; }

private:
    void select_down_to(SegmentId segment);

    BranchTree const& tree_;
    std::vector<SegmentState> states_;
    std::vector<SegmentId> path_;
    std::vector<SegmentId> undetermined_;
};

// A pen that draws over a projected skeleton; make one per stroke. The line between two samples is
// walked in steps of at most one unit of the plane, so that a fast movement misses no thin branch.
//
// Normally the pen touches the frontmost segment. Once a path has begun, though, a point where
// several branches overlap is ambiguous: the pen touches their last common ancestor, and the rest
// of the stroke shows which branch was meant. So the trunk can be followed behind branches that
// grow towards the viewer.
class SelectionPen {
public:
    // Skeleton, tree and selection must outlive the pen; `tree` must be that of the selection.
    SelectionPen(ProjectedSkeleton const& skeleton, BranchTree const& tree,
                 PathSelection& selection, PickOptions const& options = {});

    // Moves the pen to `point`. Returns true if any state changed.
    bool move_to(Vec2 const& point);

    // Lifts the pen: if its last position was ambiguous, the frontmost segment there is selected.
    // Returns the result of PathSelection::finish().
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
    // The frontmost segment at the pen's last position, if that position was ambiguous.
    std::optional<SegmentId> ambiguous_;
    std::vector<SegmentId> beginnings_; // Segments under the pen where it came down.
    // Segments under the pen that may continue the path; a buffer of touch_at().
    std::vector<SegmentId> covering_;
};

} // namespace tractus::variation
