#pragma once

#include "engine/base/result.h"
#include "engine/scene/scene.h"
#include "engine/stroke/tip_sample.h"

#include <memory>

namespace tractus::plants {

// The visible plant with the node nearest to a place on the tablet, seen from above. Fails with a
// user error if there is none near the place.
Result<std::shared_ptr<scene::BuiltPlant const>> plant_under(TipSample const& tip,
                                                             scene::Scene const& scene);

// The active plant. Fails with a user error if there is none.
Result<scene::ItemId> active_plant_of(scene::Scene const& scene);

} // namespace tractus::plants
