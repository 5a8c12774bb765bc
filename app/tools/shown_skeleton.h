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

// A plant's skeleton as the selection view shows it on the tablet, for interpreting strokes drawn
// over it. Strokes are in the world frame: x and y of a tip are millimetres on the tablet.
class ShownSkeleton {
public:
    // Shows the plant at rest, regardless of `angle.shape`.
    explicit ShownSkeleton(Plant const& plant, scene::SelectionAngle const& angle = {});

    // Shows the plant at rest or as bent by its strokes, as `angle.shape` says.
    ShownSkeleton(scene::BuiltPlant const& plant, scene::SelectionAngle const& angle);

    // The paths of branches that a stroke selects. Fails with a user error if the stroke touches no
    // branch.
    Result<variation::Selection> paths_under(Stroke const& stroke) const;

    // The segment under a tip. Fails with a user error if the tip is beside the skeleton.
    Result<SegmentId> segment_under(TipSample const& tip) const;

    // The segments that an unfinished stroke has touched so far.
    struct Touched {
        std::vector<SegmentId> selected {};
        // Touched segments that the finished stroke may or may not select.
        std::vector<SegmentId> undetermined {};

        bool operator==(Touched const&) const = default;
    };
    Touched touched_by(std::span<TipSample const> tips) const;

    variation::BranchTree const& tree() const { return tree_; }

private:
    variation::ProjectedSkeleton skeleton_;
    variation::BranchTree tree_;
};

} // namespace tractus::tools
