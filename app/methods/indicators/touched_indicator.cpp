#include "app/methods/indicators/touched_indicator.h"

namespace tractus::indicators {

Result<TouchedIndicator> touched_indicator(Stroke const& stroke, scene::Scene const& scene)
{
    constexpr double kFinger_mm = 25;
    auto const way = TRY(variation::motion_indicator(stroke));
    auto const number
        = variation::nearest_indicator(scene::motion_indicators(scene), way.start_mm, kFinger_mm);
    if (!number)
        return fail(Fault::User,
                    "there is no motion indicator where the stroke begins: begin it on one");
    return TouchedIndicator { *number, way };
}

} // namespace tractus::indicators
