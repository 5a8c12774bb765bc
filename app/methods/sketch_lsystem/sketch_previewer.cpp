#include "app/methods/sketch_lsystem/sketch_previewer.h"

#include "app/methods/sketch_lsystem/sketch_tool.h"

#include <algorithm>
#include <optional>

namespace tractus {

namespace {

constexpr double kMostInternodes = 4000;

SkeletonLine line_of(Plant const& plant, Axis const& axis, DeskPlacement const& from,
                     DeskPlacement const& to)
{
    SkeletonLine line;
    line.state = SkeletonLine::State::Assigned;
    line.width_mm
        = 2 * plant.node_radius_mm[axis.first_node] * static_cast<float>(from.scale / to.scale);
    for (auto const& node_mm : plant.positions(axis))
        line.points_mm.push_back(to.plant_of_world(from.world_of_plant(node_mm)).cast<float>());
    return line;
}

class SketchPreviewer final : public StrokePreviewer {
public:
    std::vector<SkeletonLine> show(UnfinishedStroke const& stroke) override
    {
        auto const& tool = *stroke.tool.get<SketchTool>();
        auto edit = grown_along(tool, Stroke { std::vector(stroke.ink.begin(), stroke.ink.end()) },
                                *stroke.scene);
        edit.leaves = sketch::Leaves::Bare;
        edit.rule.most_internodes = std::max<double>(edit.rule.most_segments, kMostInternodes);
        auto const built = sketch::build_sketch(edit, {});
        if (!place_ || place_surface_ != edit.surface) {
            place_ = place_of(tool, edit, *stroke.scene);
            place_surface_ = edit.surface;
        }
        if (!built || !*place_)
            return {};
        auto const& branch = **place_;
        DeskPlacement const placement { .scale = edit.scale,
                                        .origin_mm
                                        = branch ? branch->base_mm : sketch::stands_at_mm(edit) };
        std::vector<SkeletonLine> lines;
        for (auto const& axis : built->plant.axes)
            lines.push_back(line_of(built->plant, axis, placement, stroke.scene->placement));
        return lines;
    }

private:
    // Looked up once a stroke: that goes through all plants.
    std::optional<Result<std::optional<BranchPlace>>> place_;
    StrokeSurface place_surface_ = StrokeSurface::Decided;
};

} // namespace

std::unique_ptr<StrokePreviewer> sketch_previewer()
{
    return std::make_unique<SketchPreviewer>();
}

} // namespace tractus
