#pragma once

#include "engine/base/result.h"
#include "engine/scene/scene.h"
#include "engine/variation/growth_plan.h"
#include "engine/variation/stroke_shaper.h"

#include <memory>
#include <optional>
#include <stop_token>

namespace tractus::scene {

// Maintains the shape that strokes give to a plant while the document changes: only strokes that
// are new since the last call are processed. Not thread-safe.
class SceneShaper {
public:
    // Updates the shape to that of `plant`. If a stroke is invalid, fails: the shape stays as it
    // was, or, if the base plant has changed, becomes the shape without strokes.
    Result<void> set_plant(BuiltPlant const& plant);

    // Returns the shape of the plant that was last passed to set_plant(), which must be called
    // first.
    variation::PredefinedShape const& shape() const { return shaper_->shape(); }

private:
    // Plant that is shaped; immutable, and shared with the scenes.
    std::shared_ptr<Plant const> base_;
    variation::SharedRestShape rest_;
    std::optional<variation::StrokeShaper> shaper_;
};

// Returns the same plan as plan_growth(plant). Faster if the plant last passed to `shaper` was
// similar. Returns early, with a plan without segments, if `stop` is requested.
Result<variation::GrowthPlan> plan_growth(BuiltPlant const& plant, SceneShaper& shaper,
                                          std::stop_token const& stop = {});

} // namespace tractus::scene
