#pragma once

#include "app/station/window_model.h"
#include "app/tools/tool.h"
#include "engine/scene/scene.h"
#include "engine/scene/scene_shaper.h"
#include "engine/stroke/tip_sample.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace tractus {

// A stroke under way, and what it is drawn on.
struct WantedPreview {
    std::shared_ptr<Scene const> scene; // Shared with whoever shows it; nobody changes it.
    Tool tool {};
    std::vector<TipSample> ink {};
    std::uint32_t orders = 0; // Only branches of lower orders than this are looked at.
    std::size_t stroke = 0;   // Which it is: of no meaning here.
};

// What a stroke would do to a scene's branches if it ended now, so that they can follow the pen
// while it draws. Only what the stroke touches, and what stands on it, is laid anew each time.
class StrokePreview {
public:
    // The branches that stand elsewhere with the stroke than without it, where they stand then, and
    // the whole branch each time. None for a tool that shapes nothing, and for a stroke that would
    // be refused.
    std::vector<SkeletonLine> moved_by(WantedPreview const& wanted);

private:
    void lay(std::shared_ptr<Scene const> scene);
    Scene const& readable_scene(Tool const& tool);
    std::vector<SkeletonLine> moved_lines(std::uint32_t orders) const;

    std::shared_ptr<Scene const> scene_; // That is laid; as above.
    std::optional<Scene> readable_;      // The same with the tips of strokes that shape in memory.
    SceneShaper shaper_;
    std::vector<Vec3> before_mm_;
    std::vector<Vec3> after_mm_; // Kept for its memory.
};

} // namespace tractus
