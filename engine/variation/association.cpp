#include "engine/variation/association.h"

#include "engine/variation/stroke_shaper.h"

#include <utility>

namespace tractus::variation {

Result<PredefinedShape> resolve_associations(Plant const& plant, RestShape const& rest,
                                             std::span<Association const> associations)
{
    StrokeShaper shaper(plant, rest);
    TRY(shaper.set(associations));
    return std::move(shaper).take_shape();
}

} // namespace tractus::variation
