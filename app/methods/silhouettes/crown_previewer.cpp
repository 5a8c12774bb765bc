#include "app/methods/silhouettes/crown_tool.h"
#include "app/methods/silhouettes/outline_meaning.h"
#include "app/tools/coming_back.h"
#include "engine/scene/paper.h"

#include <utility>

namespace tractus::silhouette {

namespace {

// Previews the trunk and its branches in space.
class CrownPreviewer final : public tools::StrokePreviewer {
public:
    std::vector<tools::SkeletonLine> show(tools::UnfinishedStroke const& stroke) override
    {
        if (stroke.ink.size() < 4)
            return {};
        auto const& scene = *stroke.scene;
        std::vector tips(stroke.ink.begin(), stroke.ink.end());
        if (tools::is_coming_back(stroke.ink))
            tips.push_back(stroke.ink.front());
        auto const edit
            = drawn_crown(*stroke.tool.get<CrownTool>(), Stroke { std::move(tips) }, scene);
        if (!edit)
            return {};
        auto tree = tree_with(*edit, scene);
        if (!tree)
            return {};
        tree->ground_mm = edit->plant == 0 ? edit->ground_mm : tree->ground_mm;
        tree->form.levels = 1;
        // The cached skeleton is that of the tree without the unfinished stroke.
        tree->inferred.reset();
        auto const built = silhouette::build_tree(*tree);
        if (!built)
            return {};
        Vec3 const world_point_mm
            = edit->plant == 0 ? edit->stands_at_mm : scene.drawn->stands_at_mm;
        return lines_of(built->plant, { .scale = tree->scale, .origin_mm = world_point_mm }, scene);
    }

private:
    static std::vector<tools::SkeletonLine>
    lines_of(Plant const& plant, scene::DeskPlacement const& placement, scene::Scene const& scene)
    {
        std::vector<tools::SkeletonLine> lines;
        for (auto const& axis : plant.axes) {
            tools::SkeletonLine line;
            line.state = tools::SkeletonLine::State::Assigned;
            for (NodeId node = 0; node <= axis.segment_count; ++node) {
                auto const& at_mm = plant.node_position_mm[axis.first_node + node];
                line.points_mm.push_back(
                    scene.placement.plant_of_world(placement.world_of_plant(at_mm)).cast<float>());
            }
            lines.push_back(std::move(line));
        }
        return lines;
    }
};

} // namespace

std::unique_ptr<tools::StrokePreviewer> crown_previewer()
{
    return std::make_unique<CrownPreviewer>();
}

} // namespace tractus::silhouette
