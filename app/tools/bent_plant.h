#pragma once

#include "engine/scene/scene.h"
#include "engine/scene/scene_shaper.h"

#include <vector>

namespace tractus::tools {

// Geometry of a document's plant after strokes have bent it. Strokes were checked when they were
// drawn; if one cannot be read now, the plant stays at rest.
class BentPlant {
public:
    // `plant` must outlive this object.
    explicit BentPlant(scene::BuiltPlant const& plant);

    // Start of a segment of the base plant; end_of() gives its end. World frame.
    Vec3 begin_of(SegmentId segment) const;
    Vec3 end_of(SegmentId segment) const;

    // All nodes of the base plant. Plant frame.
    std::vector<Vec3> const& nodes_mm() const { return nodes_mm_; }

    // Rotation of the segment and its organs relative to the rest shape; exactly the identity if
    // the segment is not bent.
    Quat turn_of(SegmentId segment) const;

private:
    scene::BuiltPlant const& plant_;
    scene::SceneShaper shaper_;
    std::vector<Vec3> nodes_mm_;
};

} // namespace tractus::tools
