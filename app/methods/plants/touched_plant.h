#pragma once

#include "engine/base/result.h"
#include "engine/scene/scene.h"
#include "engine/stroke/tip_sample.h"

#include <memory>

namespace tractus::plants {

// The visible plant whose node is nearest to a place on the tablet, as seen from above. Fails with
// a user error if no node is within 15 mm.
Result<std::shared_ptr<scene::BuiltPlant const>> plant_under(TipSample const& tip,
                                                             scene::Scene const& scene);

// The id of the active plant. Fails with a user error if no plant is active.
Result<scene::ItemId> active_plant_of(scene::Scene const& scene);

} // namespace tractus::plants
