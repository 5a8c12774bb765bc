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

// A plant's skeleton as shown by the selection view on the tablet, for interpreting strokes over
// it. World frame: x and y of tips are millimetres of the tablet.
class ShownSkeleton {
public:
    // Shows the plant at rest, even if the angle asks for the bent plant.
    explicit ShownSkeleton(Plant const& plant, scene::SelectionAngle const& angle = {});

    // Shows the plant at rest or as bent by its strokes, depending on the angle.
    ShownSkeleton(scene::BuiltPlant const& plant, scene::SelectionAngle const& angle);

    // The paths that a stroke selects. Fails with a user error if it touches no branch.
    Result<variation::Selection> paths_under(Stroke const& stroke) const;

    // The segment under a tip. Fails with a user error if there is none.
    Result<SegmentId> segment_under(TipSample const& tip) const;

    // What an unfinished stroke has selected so far.
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
