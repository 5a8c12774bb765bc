#include "app/methods/construction_lines/erase_line_tool.h"

#include "app/methods/construction_lines/touched_sketch.h"
#include "engine/methods/construction_lines/drawn_line.h"
#include "engine/methods/construction_lines/erase_line.h"

#include <algorithm>
#include <utility>

namespace tractus::lines {

namespace {

// Path of an eraser on a sketch's sheet, and the eraser's radius in the sheet's millimetres.
struct Eraser {
    DrawnLine way;
    double radius_mm = 0;

    bool runs_over(DrawnLine const& line) const
    {
        auto const is_near = [&](DrawnLine const& one, DrawnLine const& other) {
            return std::any_of(one.points().begin(), one.points().end(), [&](Vec2 const& point) {
                return (other.point(other.nearest_mm(point)) - point).norm() <= radius_mm;
            });
        };
        return is_near(line, way) || is_near(way, line);
    }
};

Eraser eraser_of(ActiveSketch const& active, Stroke const& stroke)
{
    std::vector<Vec2> way_mm;
    for (auto const& tip : stroke.tips)
        way_mm.emplace_back(active.sheet.on_sheet(tip.position_mm.head<2>()));
    way_mm = without_repeats(way_mm);
    if (way_mm.size() == 1) // A single touch becomes a very short line.
        way_mm.emplace_back(way_mm.front() + Vec2(1e-3, 0));
    return { DrawnLine(std::move(way_mm)), active.sheet.size * EraseLineTool::kRadius_mm };
}

Result<bool> runs_over(Eraser const& eraser, SketchLine const& line)
{
    std::vector<Vec2> points;
    for (auto const& point : TRY(points_on_sheet(line)))
        points.emplace_back(point.head<2>());
    return eraser.runs_over(DrawnLine(std::move(points)));
}

// Erases the touched lines. A stem is erased only if the stroke touches no other line: other lines
// cross their stem, and erasing a stem erases all its lines.
Result<std::vector<scene::Edit>> erase(tools::Tool const&, Stroke const& stroke,
                                       scene::Scene const& scene)
{
    auto const active = TRY(active_sketch(scene));
    auto const eraser = eraser_of(active, stroke);
    std::vector<scene::Edit> edits;
    std::vector<scene::Edit> stems;
    auto const look_at
        = [&](SketchLine const& line, std::vector<scene::Edit>& touched) -> Result<void> {
        if (TRY(runs_over(eraser, line)))
            touched.push_back(EraseLine { active.plant, line.id });
        return {};
    };
    for (auto const& line : active.sketch.lines)
        TRY(look_at(line, line.role == Role::Stem ? stems : edits));
    for (auto const& organ : active.sketch.organs)
        for (auto const& line : organ.lines)
            TRY(look_at(line.line, edits));
    if (edits.empty() && !stems.empty())
        edits.push_back(stems.back());
    if (edits.empty())
        return fail(Fault::User,
                    "the eraser touched no construction line: move it over one of the plant that "
                    "takes what is drawn");
    return edits;
}

} // namespace

constexpr tools::ToolKind EraseLineTool::kKind {
    .word = "erase_line",
    .label = "Erase",
    .title = "Erase construction lines",
    .done = "The line is erased",
    .help = "takes away the construction lines that the stroke runs over on paper, and lines of "
            "drawn leaves; a stem, with all that belongs to it, only where it runs over nothing "
            "else",
    .group = "Sketch",
    .method = "From lines",
    .surface = tools::Surface::Paper,
    .ink = { tools::InkStyle::Look::Eraser, 2 * EraseLineTool::kRadius_mm },
    .options = tools::options_type<EraseLineTool>(),
    .edits_for = erase,
    .other_end = { &EraseLineTool::kKind },
};

} // namespace tractus::lines
