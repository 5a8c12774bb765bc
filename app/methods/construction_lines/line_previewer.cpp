#include "app/methods/construction_lines/line_previewer.h"

#include "app/methods/construction_lines/line_organ_tool.h"
#include "app/tools/tool.h"
#include "engine/methods/construction_lines/line_edits.h"
#include "engine/scene/scene_builder.h"

#include <algorithm>
#include <utility>

namespace tractus::lines {

namespace {

constexpr int kMaxNodesShown = 60; // Maximum number of nodes shown per layer.

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

// Lines that represent an organ, in the organ's frame: both edges and the midrib of a drawn leaf,
// or a line from base to tip for any other organ.
std::vector<std::vector<Vec3>> lines_of(OrganShape const& shape)
{
    if (shape.patches.size() != static_cast<std::size_t>(kAlong * kAcross))
        return { { Vec3::Zero(), Vec3(0, shape.length_mm, 0) } };
    std::vector<std::vector<Vec3>> lines;
    for (int const column : { 0, kAcross / 2, kAcross }) {
        bool const is_last = column == kAcross;
        std::vector<Vec3> line;
        for (int row = 0; row < kAlong; ++row) {
            auto const& patch = shape.patches[static_cast<std::size_t>(
                row * kAcross + (is_last ? column - 1 : column))];
            if (row == 0)
                line.push_back(patch.at(0, is_last ? 1 : 0));
            line.push_back(patch.at(1, is_last ? 1 : 0));
        }
        lines.push_back(std::move(line));
    }
    return lines;
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
        auto const& shape = plant.organ_shapes[organ.shape];
        double const width_mm = kSlender * shape.length_mm * static_cast<double>(organ.scale.y());
        for (auto const& line : lines_of(shape)) {
            std::vector<Vec3> points_mm;
            for (auto const& point_mm : line)
                points_mm.emplace_back(organ.position_mm
                                       + organ.orientation
                                           * organ.scale.cast<double>().cwiseProduct(point_mm));
            lines.push_back(line_through(points_mm, width_mm, from, to));
        }
    }
    return lines;
}

// The tool with a plain colour in place of a texture from the image, which takes time to cut out
// and is not shown in previews.
tools::Tool without_picture(tools::Tool const& tool)
{
    auto const* const organ = tool.get<LineOrganTool>();
    if (!organ || organ->color != OrganColor::Picture)
        return tool;
    return LineOrganTool { organ->what, OrganColor::Leaf };
}

class LinePreviewer final : public tools::StrokePreviewer {
public:
    std::optional<scene::Paper> paper() const override { return paper_; }

    std::vector<tools::SkeletonLine> show(tools::UnfinishedStroke const& stroke) override
    {
        paper_.reset();
        auto const edits
            = without_picture(stroke.tool)
                  .edits_for(Stroke { std::vector(stroke.ink.begin(), stroke.ink.end()) },
                             *stroke.scene);
        if (!edits)
            return {};
        auto const state = scene::apply_edits(stroke.scene->state, *edits, builder_);
        if (!state || !active_pen_sketch(*state))
            return {};
        auto const& plant = *scene::active_plant(*state);
        auto sketch = *lines::pen_sketch(plant);
        for (auto& line : sketch.lines)
            line.nodes = std::min(line.nodes, kMaxNodesShown);
        auto const built = lines::build_pen_sketch(sketch, {});
        if (!built)
            return {};
        paper_ = scene::paper_of(plant);
        return skeleton_of(
            built->plant,
            { .scale = state->scale.value_or(sketch.scale), .origin_mm = plant.stands_at_mm },
            stroke.scene->placement);
    }

private:
    std::optional<scene::Paper> paper_;
    scene::SceneBuilder builder_;
};

} // namespace

std::unique_ptr<tools::StrokePreviewer> line_previewer()
{
    return std::make_unique<LinePreviewer>();
}

} // namespace tractus::lines
