#pragma once

#include "engine/variation/growth.h"

#include <vector>

namespace tractus::variation {

// Returns the result of resolve_associations(), for plants whose rest shape the test does not need.
inline Result<PredefinedShape> shape_of(Plant const& plant,
                                        std::vector<Association> const& associations)
{
    return resolve_associations(plant, find_rest_shape(plant), associations);
}

// Returns a plan for growing `plant` under an influence that is the same everywhere.
inline GrowthPlan plan_of(Plant const& plant, GrowthParameters const& parameters,
                          Vec3 const& influence = Vec3::Zero(),
                          std::vector<Association> const& associations = {})
{
    auto const rest = find_rest_shape(plant);
    auto const shape = resolve_associations(plant, rest, associations).value();
    return plan_growth(plant, rest, shape, parameters, { .everywhere = influence }).value();
}

} // namespace tractus::variation
