#include "app/methods/self_organising/growth_brush_curves.h"

#include "app/methods/self_organising/growth_brush_tool.h"
#include "engine/methods/self_organising/grown_tree.h"

#include <fmt/format.h>
#include <utility>

namespace tractus::self_organising {

std::vector<tools::DrawnCurve> growth_brush_curves(scene::BuiltPlant const& plant)
{
    std::vector<tools::DrawnCurve> curves;
    auto const* const tree = grown_tree_of(plant.drawn->source);
    if (!tree)
        return curves;
    for (auto const& part : tree->life) {
        auto const tips = part.stroke.tips.in_memory();
        if (!tips || tips->size() < 2)
            continue; // In this period the tree grew by itself, without a stroke.
        // The stroke moves with the tree.
        auto const& world_point_mm = plant.placement.origin_mm;
        double const size = plant.placement.scale / part.scale;
        tools::DrawnCurve curve { .edit = scene::edit_of_item(plant.drawn->id),
                                  .name
                                  = fmt::format("{}: {} {}", GrowthBrushTool::kKind.label,
                                                part.years, part.years == 1 ? "year" : "years") };
        for (auto const& tip : *tips)
            curve.points_mm.emplace_back(
                (world_point_mm + size * (tip.position_mm - part.stands_at_mm)).cast<float>());
        curves.push_back(std::move(curve));
    }
    return curves;
}

} // namespace tractus::self_organising
