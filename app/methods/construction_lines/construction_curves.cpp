#include "app/methods/construction_lines/construction_curves.h"

#include "app/methods/construction_lines/line_tool.h"
#include "engine/methods/construction_lines/line_edits.h"
#include "engine/scene/paper.h"

#include <fmt/format.h>
#include <utility>

namespace tractus::lines {

namespace {

std::string curve_name(SketchLine const& line, std::size_t stems)
{
    auto const role = [&]() -> std::string {
        switch (line.role) {
        case Role::Left:
        case Role::Right:
            return name_of(line.role) + " boundary";
        case Role::Around:
            return "boundary in space";
        case Role::Inclination:
        case Role::HalfInclination:
            return name_of(line.role) + " line";
        case Role::Unsure:
            return "not recognised";
        case Role::Stem:
        case Role::Outline:
            break;
        }
        return name_of(line.role);
    };
    auto name = fmt::format("{}: {}", LineTool::kKind.label, role());
    if (stems > 1)
        name += fmt::format("{} {}", line.role == Role::Stem ? "" : " of stem", line.stem + 1);
    return name;
}

char const* view_name(OrganView view)
{
    switch (view) {
    case OrganView::Midrib:
        return "midrib";
    case OrganView::Section:
        return "section";
    case OrganView::Side:
        break;
    }
    return "edge";
}

} // namespace

std::vector<tools::DrawnCurve> construction_curves(scene::BuiltPlant const& plant)
{
    std::vector<tools::DrawnCurve> curves;
    auto const* const sketch = pen_sketch(*plant.drawn);
    if (!sketch || !plant.drawn->paper_mm)
        return curves;
    auto const sheet = sheet_of(*plant.drawn, plant.placement.scale);
    auto const paper = *scene::paper_of(*plant.drawn);
    auto const add = [&](SketchLine const& line, std::string name) {
        auto const points = points_on_sheet(line);
        if (!points)
            return;
        tools::DrawnCurve curve { .edit = scene::edit_of_item(line.id), .name = std::move(name) };
        for (auto const& point : *points) {
            Vec3 at_mm = paper.world_of_sheet(sheet.on_tablet(point.head<2>()));
            at_mm.y() -= paper.unit * point.z() / sheet.size;
            curve.points_mm.emplace_back(at_mm.cast<float>());
        }
        curves.push_back(std::move(curve));
    };
    std::size_t stems = 0;
    for (auto const& line : sketch->lines)
        stems += line.role == Role::Stem;
    for (auto const& line : sketch->lines)
        add(line, curve_name(line, stems));
    for (auto const& organ : sketch->organs)
        for (auto const& line : organ.lines)
            add(line.line, fmt::format("Leaf in three views: {}", view_name(line.view)));
    return curves;
}

} // namespace tractus::lines
