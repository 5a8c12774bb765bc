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

// A scene's skeleton as lines, each with one state. The cost of an update depends on the branches
// that are shown, not on the size of the plant; for that, results are kept between calls.
class SkeletonPicture {
public:
    // Sets the scene whose skeleton is shown.
    void set_scene(std::shared_ptr<scene::Scene const> scene);

    // Only branches of lower orders than this are shown: the twigs of a very large plant would
    // merge into a blot, and none could be selected.
    std::uint32_t orders() const { return orders_; }

    // Bounding box of the whole plant.
    Bounds const& box_mm() const { return box_mm_; }

    // The branches as strokes bend them, other plants first. Colours mark branches that are
    // selected, shaped by a stroke directly or by propagation, touched by the pen, or about to be
    // shaped by the next stroke. `next` lists the branches that the next stroke would shape; if it
    // is empty, those are the selected ones.
    std::vector<tools::SkeletonLine> lines(tools::ShownSkeleton::Touched const& touched,
                                           std::span<SegmentId const> next = {});

private:
    void show_others();
    void mark(std::span<SegmentId const> segments, tools::SkeletonLine::State state);
    void mark_propagated();

    std::shared_ptr<scene::Scene const> scene_; // Immutable; shared with the window.
    std::uint32_t orders_ = 0;
    Bounds box_mm_;
    std::vector<AxisId> shown_axes_;
    scene::SceneShaper shaper_;
    std::vector<Vec3> nodes_mm_; // Nodes of the bent plant.
    // State of each segment; all Unselected between calls.
    std::vector<tools::SkeletonLine::State> states_;
    std::vector<SegmentId> marked_;
    // Plants that are not active; shared with the scene.
    std::vector<std::shared_ptr<scene::BuiltPlant const>> other_plants_;
    scene::DeskPlacement seen_from_; // Placement of the active plant, whose frame `others_` is in.
    std::vector<tools::SkeletonLine> others_;
};

} // namespace tractus::view
