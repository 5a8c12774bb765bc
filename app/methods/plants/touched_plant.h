#pragma once

#include "engine/base/result.h"
#include "engine/scene/scene.h"
#include "engine/stroke/tip_sample.h"

#include <memory>

namespace tractus::plants {

// The plant, hidden ones apart, of which a node is nearest to a place on the pad, seen from above.
// Fails, as the user's fault, where none is near.
Result<std::shared_ptr<scene::BuiltPlant const>> plant_under(TipSample const& tip,
                                                             scene::Scene const& scene);

// The active plant. Fails, as the user's fault, where there is none.
Result<scene::ItemId> active_plant_of(scene::Scene const& scene);

} // namespace tractus::plants
