#include "app/methods/silhouettes/outline_curves.h"

#include "app/methods/silhouettes/crown_tool.h"
#include "app/methods/silhouettes/outline_tool.h"
#include "engine/methods/silhouettes/tree_edits.h"
#include "engine/scene/paper.h"

#include <fmt/format.h>
#include <utility>

namespace tractus::silhouette {

namespace {

// Whether a curve is on the sheet or in space. In space, z is the distance behind the sheet.
enum class Lying { OnSheet, InSpace };
enum class Ends { Open, Closed };

// Collects drawn curves, converted from the sheet `paper` to the world frame.
class CurvesOnPaper {
public:
    explicit CurvesOnPaper(scene::Paper const& paper)
        : paper_(paper)
    {
    }

    void add(scene::ItemId id, Stroke const& stroke, char const* label, char const* what,
             Ends ends = Ends::Open, Lying lying = Lying::OnSheet)
    {
        auto const tips = stroke.tips.in_memory();
        if (!tips || tips->size() < 2)
            return;
        tools::DrawnCurve curve { .edit = scene::edit_of_item(id),
                                  .name = fmt::format("{}: {}", label, what) };
        for (auto const& tip : *tips) {
            Vec3 at_mm = paper_.world_of_sheet(tip.position_mm.head<2>());
            if (lying == Lying::InSpace)
                at_mm.y() += paper_.unit * tip.position_mm.z();
            curve.points_mm.emplace_back(at_mm.cast<float>());
        }
        if (ends == Ends::Closed)
            curve.points_mm.push_back(Vec3f(curve.points_mm.front()));
        curves_.push_back(std::move(curve));
    }

    std::vector<tools::DrawnCurve> take() { return std::move(curves_); }

private:
    scene::Paper paper_;
    std::vector<tools::DrawnCurve> curves_;
};

} // namespace

std::vector<tools::DrawnCurve> outline_curves(scene::BuiltPlant const& plant)
{
    auto const* const tree = outlined_tree(*plant.drawn);
    if (!tree || !plant.drawn->paper_mm)
        return {};
    CurvesOnPaper curves(*scene::paper_of(*plant.drawn));
    auto const* const label = OutlineTool::kKind.label;
    // The trunk and the crown's outline have the plant's id, because one of them began the plant.
    auto const plant_id = plant.drawn->id;
    curves.add(plant_id, tree->trunk, label, "trunk");
    curves.add(plant_id, tree->outline, label, tree->is_leaf ? "leaf" : "crown", Ends::Closed);
    for (auto const& branch : tree->branches)
        curves.add(branch.id, branch.stroke, label, "branch of the trunk");
    for (auto const& own : tree->own_outlines)
        if (!own.of_bump) // The outline of a bump was not drawn by the pen.
            curves.add(own.id, own.stroke, label, own.is_leaf ? "leaf" : "crown of a branch",
                       Ends::Closed);
    for (auto const& own : tree->own_branches)
        curves.add(own.id, own.stroke, label, "branch of a branch");
    for (auto const& line : tree->crown_lines)
        curves.add(line.id, line.stroke, CrownTool::kKind.label, "line on the crown", Ends::Open,
                   Lying::InSpace);
    return curves.take();
}

} // namespace tractus::silhouette
