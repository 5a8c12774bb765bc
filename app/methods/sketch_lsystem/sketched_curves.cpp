#include "app/methods/sketch_lsystem/sketched_curves.h"

#include "app/methods/sketch_lsystem/sketch_tool.h"
#include "engine/methods/sketch_lsystem/grow_edit.h"

#include <fmt/format.h>
#include <utility>

namespace tractus::sketch {

std::vector<tools::DrawnCurve> sketched_curves(scene::BuiltPlant const& plant)
{
    auto const* const sketch = sketch_of(plant.drawn->source);
    auto const tips = sketch ? sketch->stroke.tips.in_memory() : fail(Fault::User, "no sketch");
    if (!tips || tips->size() < 2)
        return {};
    auto const points_mm = plant_tips(*tips, sketch->surface);
    double const size = plant.placement.scale / sketch->scale;
    tools::DrawnCurve curve { .edit = scene::edit_of_item(plant.drawn->id),
                              .name = fmt::format("{}: the stem", SketchTool::kKind.method) };
    for (auto const& point_mm : points_mm)
        curve.points_mm.emplace_back(
            (plant.placement.origin_mm + size * (point_mm - points_mm.front())).cast<float>());
    return { std::move(curve) };
}

} // namespace tractus::sketch
