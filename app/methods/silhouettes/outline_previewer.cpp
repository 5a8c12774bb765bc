#include "app/methods/silhouettes/outline_previewer.h"

#include "app/methods/silhouettes/outline_tool.h"
#include "engine/scene/paper.h"

#include <span>
#include <utility>

namespace tractus {

namespace {

// The stroke drawn back to its beginning, so that a half-drawn crown is one.
Stroke closed(std::span<TipSample const> ink)
{
    std::vector tips(ink.begin(), ink.end());
    tips.push_back(ink.front());
    return { std::move(tips) };
}

// Whether so much of a crown is drawn that branches say something: the pen is on its way back.
bool turns_back(std::span<TipSample const> ink)
{
    Vec2 const begin = ink.front().position_mm.head<2>();
    double farthest = 0;
    for (auto const& tip : ink)
        farthest = std::max(farthest, (tip.position_mm.head<2>() - begin).norm());
    return (ink.back().position_mm.head<2>() - begin).norm() < 0.7 * farthest;
}

class OutlinePreviewer final : public StrokePreviewer {
public:
    std::vector<SkeletonLine> show(UnfinishedStroke const& stroke) override
    {
        if (stroke.ink.size() < 2)
            return {};
        auto const& scene = *stroke.scene;
        auto const ink = turns_back(stroke.ink)
            ? closed(stroke.ink)
            : Stroke { std::vector(stroke.ink.begin(), stroke.ink.end()) };
        auto const edit = drawn_tree(*stroke.tool.get<OutlineTool>(), ink, scene);
        if (!edit)
            return {};
        auto tree = tree_with(*edit, scene);
        if (tree.outline.tips.empty())
            return {};
        tree.form.levels = 1;
        auto const skeleton = silhouette::skeleton_of(tree);
        if (!skeleton)
            return {};
        auto const& system = skeleton->systems[0];
        std::vector<SkeletonLine> lines { line_of(system.whole_trunk(), scene) };
        for (auto const& branch : system.branches)
            lines.push_back(line_of(branch.path.curve.points(9), scene));
        return lines;
    }

private:
    static SkeletonLine line_of(std::vector<Vec2> const& points, Scene const& scene)
    {
        auto const paper = paper_of(scene.state);
        SkeletonLine line;
        line.state = SkeletonLine::State::Assigned;
        for (auto const& point : points)
            line.points_mm.push_back(
                scene.placement.plant_of_world(paper.world_of_sheet(point)).cast<float>());
        return line;
    }
};

} // namespace

std::unique_ptr<StrokePreviewer> outline_previewer()
{
    return std::make_unique<OutlinePreviewer>();
}

} // namespace tractus
