#pragma once

#include "engine/scene/scene.h"
#include "engine/scene/scene_shaper.h"

#include <vector>

namespace tractus::tools {

// Where a plant of the document is, as strokes have bent it. Each stroke was checked when it was
// drawn; one that cannot be read now leaves the plant at rest.
class BentPlant {
public:
    // The plant must outlive it.
    explicit BentPlant(scene::BuiltPlant const& plant);

    // The ends of a segment of the base plant. World frame.
    Vec3 begin_of(SegmentId segment) const;
    Vec3 end_of(SegmentId segment) const;

    // All nodes of the base plant. Plant frame.
    std::vector<Vec3> const& nodes_mm() const { return nodes_mm_; }

    // Turns what rides on the segment from where it is at rest; exactly nothing where the segment
    // is as it was.
    Quat turn_of(SegmentId segment) const;

private:
    scene::BuiltPlant const& plant_;
    scene::SceneShaper shaper_;
    std::vector<Vec3> nodes_mm_;
};

} // namespace tractus::tools
