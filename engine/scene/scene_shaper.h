#pragma once

#include "engine/base/result.h"
#include "engine/scene/scene.h"
#include "engine/variation/growth_plan.h"
#include "engine/variation/stroke_shaper.h"

#include <memory>
#include <optional>
#include <stop_token>

namespace tractus::scene {

// Keeps the shape that strokes give to a plant, for states of it that follow each other: of the
// next one only the strokes that are new are looked at and laid. Serves one caller at a time.
class SceneShaper {
public:
    // From here on that of this plant. If one of its strokes is refused the shape stays as it was,
    // or is that without strokes for another plant than before.
    Result<void> set_plant(BuiltPlant const& plant);

    // After set_plant().
    variation::PredefinedShape const& shape() const { return shaper_->shape(); }

private:
    std::shared_ptr<Plant const> base_; // Shared with the scenes; nobody changes it.
    variation::SharedRestShape rest_;
    std::optional<variation::StrokeShaper> shaper_;
};

// The same plan as plan_growth(plant), sooner where the shaper had a plant much like it. Ends early
// when `stop` asks for it; the plan is then without segments.
Result<variation::GrowthPlan> plan_growth(BuiltPlant const& plant, SceneShaper& shaper,
                                          std::stop_token const& stop = {});

} // namespace tractus::scene
