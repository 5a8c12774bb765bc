#pragma once

#include "engine/scene/scene.h"
#include "engine/scene/scene_shaper.h"

#include <vector>

namespace tractus::tools {

// The nodes and rotations of a document's plant after strokes have bent it. Each stroke was checked
// when it was drawn; if a stroke cannot be read now, the plant stays at rest.
class BentPlant {
public:
    // `plant` must outlive this object.
    explicit BentPlant(scene::BuiltPlant const& plant);

    // Start of a segment of the bent plant, world frame; end_of() gives the segment's end.
    Vec3 begin_of(SegmentId segment) const;
    Vec3 end_of(SegmentId segment) const;

    // Positions of all nodes of the bent plant, in the plant frame and in the base plant's order.
    std::vector<Vec3> const& nodes_mm() const { return nodes_mm_; }

    // Rotation of the segment and its organs from the plant's rest shape to its bent shape; exactly
    // the identity if the segment is not bent.
    Quat turn_of(SegmentId segment) const;

private:
    scene::BuiltPlant const& plant_;
    scene::SceneShaper shaper_;
    std::vector<Vec3> nodes_mm_;
};

} // namespace tractus::tools
