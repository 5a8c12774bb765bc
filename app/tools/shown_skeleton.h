#pragma once

#include "engine/base/result.h"
#include "engine/plant/plant.h"
#include "engine/scene/desk_placement.h"
#include "engine/scene/scene.h"
#include "engine/stroke/stroke.h"
#include "engine/variation/branch_tree.h"
#include "engine/variation/projected_skeleton.h"
#include "engine/variation/select_branches.h"

#include <span>
#include <vector>

namespace tractus::tools {

// A plant's skeleton as the selection view shows it on the tablet, and what a pen means that is
// drawn over it. World frame: tips' x and y are millimetres of the tablet.
class ShownSkeleton {
public:
    // The plant at rest, whatever the angle says.
    explicit ShownSkeleton(Plant const& plant, scene::SelectionAngle const& angle = {});

    // As the angle says: at rest, or as the plant's strokes bend it.
    ShownSkeleton(scene::BuiltPlant const& plant, scene::SelectionAngle const& angle);

    // The paths that a stroke chooses. Fails, as the user's fault, if it touches no branch.
    Result<variation::Selection> paths_under(Stroke const& stroke) const;

    // The segment under a tip. Fails, as the user's fault, if there is none.
    Result<SegmentId> segment_under(TipSample const& tip) const;

    // What a stroke has chosen while it is still being drawn.
    struct Touched {
        std::vector<SegmentId> selected {};
        std::vector<SegmentId> undetermined {}; // The pen has not yet shown whether it meant them.

        bool operator==(Touched const&) const = default;
    };
    Touched touched_by(std::span<TipSample const> tips) const;

    variation::BranchTree const& tree() const { return tree_; }

private:
    variation::ProjectedSkeleton skeleton_;
    variation::BranchTree tree_;
};

} // namespace tractus::tools
