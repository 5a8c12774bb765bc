#include "app/methods/construction_lines/touched_sketch.h"

namespace tractus::lines {

Result<ActiveSketch> active_sketch(scene::Scene const& scene)
{
    auto const* const sketch = lines::active_pen_sketch(scene.state);
    if (!sketch)
        return fail(Fault::User,
                    "the plant that takes what is drawn has no construction lines: draw a stem "
                    "under Lines, or choose a plant that has them");
    return ActiveSketch { scene.state.active, *sketch,
                          lines::sheet_of(*scene::active_plant(scene.state), scene.state.scale) };
}

Vec2 touched_mm(ActiveSketch const& active, Stroke const& stroke)
{
    return active.sheet.on_sheet(stroke.tips.back().position_mm.head<2>());
}

} // namespace tractus::lines
