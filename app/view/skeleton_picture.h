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

// A scene's skeleton as lines of one state each. What it costs to make it anew depends on the
// branches that are shown, and not on how many the plant has: for that something is kept between
// the calls.
class SkeletonPicture {
public:
    // From here on that of this scene.
    void set_scene(std::shared_ptr<scene::Scene const> scene);

    // Twigs of plants with very many would be a blot, and none of them can be chosen: only branches
    // of lower orders than this are shown.
    std::uint32_t orders() const { return orders_; }

    // Of the whole plant.
    Bounds const& box_mm() const { return box_mm_; }

    // The branches as strokes bend them. What is selected or shaped in the scene, directly or by
    // propagation, touched by the pen, or shaped by the next stroke has colours of its own. Where
    // `next` is not empty it is that and not what is selected which strokes shape. Other plants
    // come first.
    std::vector<tools::SkeletonLine> lines(tools::ShownSkeleton::Touched const& touched,
                                           std::span<SegmentId const> next = {});

private:
    void show_others();
    void mark(std::span<SegmentId const> segments, tools::SkeletonLine::State state);
    void mark_propagated();

    std::shared_ptr<scene::Scene const> scene_; // Shared with who shows it; nobody changes it.
    std::uint32_t orders_ = 0;
    Bounds box_mm_;
    std::vector<AxisId> shown_axes_;
    scene::SceneShaper shaper_;
    std::vector<Vec3> nodes_mm_; // Of the plant as bent.
    // Of each segment; between calls all unselected.
    std::vector<tools::SkeletonLine::State> states_;
    std::vector<SegmentId> marked_;
    std::vector<std::shared_ptr<scene::BuiltPlant const>> other_plants_; // Shared with the scene.
    scene::DeskPlacement seen_from_; // Of the plant in whose frame their lines are.
    std::vector<tools::SkeletonLine> others_;
};

} // namespace tractus::view
