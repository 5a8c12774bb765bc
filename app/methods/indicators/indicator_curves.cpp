#include "app/methods/indicators/indicator_curves.h"

#include "app/methods/indicators/indicate_tool.h"

namespace tractus::indicators {

std::vector<tools::DrawnCurve> indicator_curves(scene::BuiltPlant const& plant)
{
    std::vector<tools::DrawnCurve> curves;
    for (auto const& [id, indicator, at] : plant.indicators) {
        std::string name = IndicateTool::kKind.label;
        name += at.empty() ? ": the whole plant" : ": a part of the plant";
        curves.push_back(
            { .edit = scene::edit_of_item(id),
              .name = std::move(name),
              .points_mm = { indicator.start_mm.cast<float>(), indicator.end_mm.cast<float>() },
              .end = tools::DrawnCurve::End::Arrow });
    }
    return curves;
}

} // namespace tractus::indicators
