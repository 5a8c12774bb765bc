#include "app/methods/leaves/leaf_sketch_curves.h"

#include "app/methods/leaves/leaf_line_tool.h"
#include "engine/methods/leaves/leaf_sketch_edits.h"
#include "engine/scene/paper.h"

#include <fmt/format.h>
#include <utility>

namespace tractus::leaf {

std::vector<tools::DrawnCurve> leaf_sketch_curves(scene::BuiltPlant const& plant)
{
    std::vector<tools::DrawnCurve> curves;
    auto const* const sketch = leaf_sketch(*plant.drawn);
    auto const drawing = sketch ? drawing_of(*sketch) : fail(Fault::User, "no leaf");
    if (!drawing || !plant.drawn->paper_mm)
        return curves;
    auto const paper = *scene::paper_of(*plant.drawn);
    for (std::size_t i = 0; i < drawing->strokes.size(); ++i) {
        tools::DrawnCurve curve { .edit = scene::edit_of_item(sketch->lines[i].id) };
        curve.name = fmt::format("{}: {}", LeafLineTool::kKind.label,
                                 sketch->seen ? name_of(sketch->seen->lines.roles[i]) : "a line");
        for (auto const& point : drawing->strokes[i]) {
            Vec3 at_mm = paper.world_of_sheet(point.head<2>());
            at_mm.y() -= paper.unit * point.z();
            curve.points_mm.emplace_back(at_mm.cast<float>());
        }
        if (curve.points_mm.size() > 1)
            curves.push_back(std::move(curve));
    }
    return curves;
}

} // namespace tractus::leaf
