#include "app/methods/leaves/leaf_layers.h"

#include "engine/methods/leaves/leaf_sketch_edits.h"
#include "engine/scene/paper.h"

#include <optional>
#include <utility>

namespace tractus::leaf {

namespace {

using Lines = std::vector<std::vector<Vec3f>>;
using enum leaf::StrokeRole;

std::vector<Vec3f> shown(std::vector<Vec3> const& line, scene::Paper const& paper)
{
    constexpr float kApart_mm = 0.5f; // Points closer together than this are left out.
    std::vector<Vec3f> points;
    for (auto const& place : line) {
        Vec3 at_mm = paper.world_of_sheet(place.head<2>());
        at_mm.y() -= place.z();
        Vec3f const there_mm = at_mm.cast<float>();
        if (points.empty() || (there_mm - points.back()).norm() >= kApart_mm)
            points.push_back(there_mm);
    }
    return points;
}

// The lines of the drawing whose role `is_wanted` accepts. While the lines do not make a leaf, they
// have no role.
template<typename Wanted> Lines lines_of(scene::BuiltPlant const& plant, Wanted const& is_wanted)
{
    Lines lines;
    auto const* const sketch = leaf::leaf_sketch(*plant.drawn);
    if (!sketch || !plant.drawn->paper_mm)
        return lines;
    auto const drawing = leaf::drawing_of(*sketch);
    if (!drawing)
        return lines;
    auto const paper = *scene::paper_of(*plant.drawn);
    for (std::size_t i = 0; i < drawing->strokes.size(); ++i) {
        auto const role = sketch->seen ? std::optional(sketch->seen->lines.roles[i]) : std::nullopt;
        if (!is_wanted(role))
            continue;
        if (auto points = shown(drawing->strokes[i], paper); points.size() > 1)
            lines.push_back(std::move(points));
    }
    return lines;
}

using Role = std::optional<leaf::StrokeRole>;

Lines outline_of(scene::BuiltPlant const& plant)
{
    return lines_of(plant, [](Role const& role) { return role == Outline; });
}

Lines veins_of(scene::BuiltPlant const& plant)
{
    return lines_of(plant, [](Role const& role) {
        return role == Midrib || role == MainVein || role == SideVein || role == Stalk;
    });
}

Lines others_of(scene::BuiltPlant const& plant)
{
    return lines_of(plant, [](Role const& role) { return !role || role == FinerVein; });
}

} // namespace

constexpr tools::Layer kLeafOutlineLayer { .label = "drawn leaf",
                                           .style = { .color = tools::LayerStyle::Color::Purple },
                                           .lines = outline_of };
constexpr tools::Layer kLeafVeinLayer { .label = "drawn veins",
                                        .style = { .color = tools::LayerStyle::Color::Orange },
                                        .lines = veins_of };
constexpr tools::Layer kLeafOtherLayer { .label = "other lines of the leaf",
                                         .style = { .pattern = tools::LayerStyle::Pattern::Dotted },
                                         .lines = others_of };

} // namespace tractus::leaf
