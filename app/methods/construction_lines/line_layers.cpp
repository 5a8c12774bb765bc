#include "app/methods/construction_lines/line_layers.h"

#include "engine/methods/construction_lines/line_edits.h"
#include "engine/methods/construction_lines/lines_to_draw.h"
#include "engine/scene/paper.h"

namespace tractus::lines {

namespace {

using Lines = std::vector<std::vector<Vec3f>>;
using enum lines::Role;

// Places a line of the sheet where the plant is now, which may not be where the line was drawn.
std::vector<Vec3f> shown(lines::SketchLine const& line, lines::SheetPlacement const& sheet,
                         scene::Paper const& paper)
{
    constexpr float kApart_mm = 0.5f; // Points closer together than this are left out.
    std::vector<Vec3f> points;
    auto const tips = line.stroke.tips.in_memory();
    if (!tips)
        return points;
    for (auto const& tip : *tips) {
        Vec2 const there_mm = sheet.on_tablet(line.sheet.on_sheet(tip.position_mm.head<2>()));
        Vec3f const at_mm = paper.world_of_sheet(there_mm).cast<float>();
        if (points.empty() || (at_mm - points.back()).norm() >= kApart_mm)
            points.push_back(at_mm);
    }
    return points;
}

Lines to_be_drawn(scene::BuiltPlant const& plant)
{
    Lines result;
    auto const* const sketch = lines::pen_sketch(*plant.drawn);
    auto const drawn = sketch ? lines::line_sketch(*sketch) : fail(Fault::User, "no sketch");
    if (!drawn || !plant.drawn->paper_mm)
        return result;
    auto const sheet = lines::sheet_of(*plant.drawn, plant.placement.scale);
    auto const paper = *scene::paper_of(*plant.drawn);
    for (auto const& line : lines::lines_to_draw(*drawn)) {
        result.emplace_back();
        for (auto const& point : line)
            result.back().push_back(paper.world_of_sheet(sheet.on_tablet(point)).cast<float>());
    }
    return result;
}

// Lines of a plant's sketch, in the world frame. `list` passes each line to be shown to its second
// argument.
template<typename List> Lines lines_on_paper(scene::BuiltPlant const& plant, List const& list)
{
    Lines result;
    auto const* const sketch = lines::pen_sketch(*plant.drawn);
    if (!sketch || !plant.drawn->paper_mm)
        return result;
    auto const sheet = lines::sheet_of(*plant.drawn, plant.placement.scale);
    auto const paper = *scene::paper_of(*plant.drawn);
    list(*sketch, [&](lines::SketchLine const& line) {
        if (auto points = shown(line, sheet, paper); points.size() > 1)
            result.push_back(std::move(points));
    });
    return result;
}

template<typename Condition>
Lines lines_where(scene::BuiltPlant const& plant, Condition const& is_shown)
{
    return lines_on_paper(plant, [&](lines::PenSketch const& sketch, auto const& add) {
        for (auto const& line : sketch.lines)
            if (is_shown(line))
                add(line);
    });
}

// The first, third, fifth stem and so on have one colour, the other stems another.
enum class Turn { First, Second };

template<Turn turn, lines::Role... roles> Lines lines_of(scene::BuiltPlant const& plant)
{
    return lines_where(plant, [](lines::SketchLine const& line) {
        return line.stem % 2 == static_cast<std::size_t>(turn) && ((line.role == roles) || ...);
    });
}

Lines unsure_lines(scene::BuiltPlant const& plant)
{
    return lines_where(plant, [](lines::SketchLine const& line) { return line.role == Unsure; });
}

// The lines of the plant's drawn leaves where they are on the sheet.
Lines organ_lines(scene::BuiltPlant const& plant)
{
    return lines_on_paper(plant, [](lines::PenSketch const& sketch, auto const& add) {
        for (auto const& organ : sketch.organs)
            for (auto const& line : organ.lines)
                add(line.line);
    });
}

} // namespace

constexpr tools::Layer kStemLayer { .label = "drawn stem",
                                    .style = { .color = tools::LayerStyle::Color::Purple },
                                    .lines = lines_of<Turn::First, Stem> };
constexpr tools::Layer kBoundaryLayer { .label = "boundaries",
                                        .style = { .color = tools::LayerStyle::Color::Purple,
                                                   .pattern = tools::LayerStyle::Pattern::Dashed },
                                        .lines = lines_of<Turn::First, Left, Right, Around> };
constexpr tools::Layer kInclinationLayer {
    .label = "inclination lines",
    .style = { .color = tools::LayerStyle::Color::Orange },
    .lines = lines_of<Turn::First, Role::Inclination, HalfInclination>
};
constexpr tools::Layer kOtherStemLayer { .label = "every other stem",
                                         .style = { .color = tools::LayerStyle::Color::Green },
                                         .lines = lines_of<Turn::Second, Stem> };
constexpr tools::Layer kOtherBoundaryLayer { .label = "its boundaries",
                                             .style
                                             = { .color = tools::LayerStyle::Color::Green,
                                                 .pattern = tools::LayerStyle::Pattern::Dashed },
                                             .lines = lines_of<Turn::Second, Left, Right, Around> };
constexpr tools::Layer kOtherInclinationLayer {
    .label = "its inclination lines",
    .style = { .color = tools::LayerStyle::Color::Blue },
    .lines = lines_of<Turn::Second, Role::Inclination, HalfInclination>
};
constexpr tools::Layer kUnsureLayer { .label = "unsure lines",
                                      .style = { .pattern = tools::LayerStyle::Pattern::Dotted },
                                      .lines = unsure_lines };
constexpr tools::Layer kOrganLayer { .label = "leaves in views",
                                     .style
                                     = { .color = tools::LayerStyle::Color::Green, .width_mm = 1 },
                                     .lines = organ_lines };
constexpr tools::Layer kLinesToDrawLayer { .label = "still to be drawn",
                                           .style = { .color = tools::LayerStyle::Color::Blue,
                                                      .pattern = tools::LayerStyle::Pattern::Dotted,
                                                      .width_mm = 1 },
                                           .lines = to_be_drawn };

} // namespace tractus::lines
