#include "app/methods/construction_lines/line_previewer.h"

#include "app/methods/construction_lines/line_tool.h"
#include "engine/scene/scene_builder.h"

#include <algorithm>
#include <utility>

namespace tractus::lines {

namespace {

constexpr int kMostNodesShown = 60; // In a layer.

tools::SkeletonLine line_through(std::vector<Vec3> const& points_mm, double width_mm,
                                 scene::DeskPlacement const& from, scene::DeskPlacement const& to)
{
    tools::SkeletonLine line;
    line.state = tools::SkeletonLine::State::Assigned;
    line.width_mm = static_cast<float>(width_mm * from.scale / to.scale);
    for (auto const& point_mm : points_mm)
        line.points_mm.push_back(to.plant_of_world(from.world_of_plant(point_mm)).cast<float>());
    return line;
}

std::vector<tools::SkeletonLine> skeleton_of(Plant const& plant, scene::DeskPlacement const& from,
                                             scene::DeskPlacement const& to)
{
    std::vector<tools::SkeletonLine> lines;
    for (auto const& axis : plant.axes) {
        auto const nodes_mm = plant.positions(axis);
        lines.push_back(line_through({ nodes_mm.begin(), nodes_mm.end() },
                                     2 * static_cast<double>(plant.node_radius_mm[axis.first_node]),
                                     from, to));
    }
    for (auto const& organ : plant.organs) {
        constexpr double kSlender = 0.02;
        double const length_mm
            = plant.organ_shapes[organ.shape].length_mm * static_cast<double>(organ.scale.y());
        Vec3 const tip_mm = organ.position_mm + organ.orientation * Vec3(0, length_mm, 0);
        lines.push_back(
            line_through({ organ.position_mm, tip_mm }, kSlender * length_mm, from, to));
    }
    return lines;
}

class LinePreviewer final : public tools::StrokePreviewer {
public:
    std::vector<tools::SkeletonLine> show(tools::UnfinishedStroke const& stroke) override
    {
        auto const edit = line_drawn(*stroke.tool.get<LineTool>(),
                                     Stroke { std::vector(stroke.ink.begin(), stroke.ink.end()) },
                                     *stroke.scene);
        auto const state = scene::apply_edit(stroke.scene->state, edit, builder_);
        if (!state)
            return {};
        auto const& plant = *scene::active_plant(*state);
        auto sketch = *lines::pen_sketch(plant);
        for (auto& line : sketch.lines)
            line.nodes = std::min(line.nodes, kMostNodesShown);
        auto const built = lines::build_pen_sketch(sketch, {});
        if (!built)
            return {};
        return skeleton_of(
            built->plant,
            { .scale = state->scale.value_or(edit.scale), .origin_mm = plant.stands_at_mm },
            stroke.scene->placement);
    }

private:
    scene::SceneBuilder builder_;
};

} // namespace

std::unique_ptr<tools::StrokePreviewer> line_previewer()
{
    return std::make_unique<LinePreviewer>();
}

} // namespace tractus::lines
