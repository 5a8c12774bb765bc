#pragma once

#include "app/tools/shown_skeleton.h"
#include "app/view/window_model.h"
#include "engine/plant/plant.h"
#include "engine/scene/scene.h"
#include "engine/scene/scene_shaper.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace tractus::view {

// A scene's skeleton as lines; all segments of a line have the same state. Results are kept between
// calls, so that the cost of an update depends on the branches that are shown and not on the size
// of the plant.
class SkeletonPicture {
public:
    // Sets the scene whose skeleton is shown.
    void set_scene(std::shared_ptr<scene::Scene const> scene);

    // Returns the branching order below which branches are shown. The twigs of a very large plant
    // would merge into a blot, in which none could be selected.
    std::uint32_t orders() const { return orders_; }

    // Returns the bounding box of the whole plant.
    Bounds const& box_mm() const { return box_mm_; }

    // Returns the branches as strokes have bent them; other plants come first. The states of the
    // lines mark branches that are selected, shaped by a stroke directly or by propagation, touched
    // by the pen, or shaped by the next stroke. `next` lists the branches that the next stroke
    // would shape; if it is empty, the next stroke would shape the selected branches.
    std::vector<tools::SkeletonLine> lines(tools::ShownSkeleton::Touched const& touched,
                                           std::span<SegmentId const> next = {});

private:
    void show_others();
    void mark(std::span<SegmentId const> segments, tools::SkeletonLine::State state);
    void mark_propagated();

    // The scene that is shown. Immutable; shared with the window.
    std::shared_ptr<scene::Scene const> scene_;
    std::uint32_t orders_ = 0;
    Bounds box_mm_;
    std::vector<AxisId> shown_axes_;
    scene::SceneShaper shaper_;
    std::vector<Vec3> nodes_mm_; // Positions of the bent plant's nodes.
    // State of each segment. Between calls all states are Unselected.
    std::vector<tools::SkeletonLine::State> states_;
    std::vector<SegmentId> marked_;
    // Plants that are not active. Shared with the scene.
    std::vector<std::shared_ptr<scene::BuiltPlant const>> other_plants_;
    // Placement of the active plant; `others_` is in the frame of this placement.
    scene::DeskPlacement seen_from_;
    std::vector<tools::SkeletonLine> others_;
};

} // namespace tractus::view
