#pragma once

#include "engine/base/result.h"
#include "engine/scene/scene.h"
#include "engine/variation/growth_plan.h"
#include "engine/variation/stroke_shaper.h"

#include <memory>
#include <optional>
#include <stop_token>

namespace tractus::scene {

// Maintains the shape that strokes give to a plant, incrementally over successive states: only new
// strokes are processed. Not thread-safe.
class SceneShaper {
public:
    // Updates the shape to that of this plant. If a stroke is invalid the shape stays as it was; if
    // the plant is a different one it becomes the shape without strokes.
    Result<void> set_plant(BuiltPlant const& plant);

    // Call set_plant() first.
    variation::PredefinedShape const& shape() const { return shaper_->shape(); }

private:
    std::shared_ptr<Plant const> base_; // Plant that is shaped; immutable, shared with the scenes.
    variation::SharedRestShape rest_;
    std::optional<variation::StrokeShaper> shaper_;
};

// Returns the same plan as plan_growth(plant), faster if the shaper's previous plant was similar.
// Returns early, with a plan without segments, if `stop` is requested.
Result<variation::GrowthPlan> plan_growth(BuiltPlant const& plant, SceneShaper& shaper,
                                          std::stop_token const& stop = {});

} // namespace tractus::scene
