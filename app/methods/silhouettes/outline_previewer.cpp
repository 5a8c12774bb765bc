#include "app/methods/silhouettes/outline_previewer.h"

#include "app/methods/silhouettes/outline_meaning.h"
#include "app/methods/silhouettes/outline_tool.h"
#include "app/tools/coming_back.h"
#include "engine/methods/silhouettes/chosen_style.h"
#include "engine/scene/paper.h"

#include <cmath>
#include <span>
#include <utility>

namespace tractus::silhouette {

namespace {

using silhouette::DrawTree;

// The stroke with its first point added at its end, so that an unfinished crown counts as closed.
Stroke closed(std::span<TipSample const> ink)
{
    std::vector tips(ink.begin(), ink.end());
    tips.push_back(ink.front());
    return { std::move(tips) };
}

class OutlinePreviewer final : public tools::StrokePreviewer {
public:
    std::vector<tools::SkeletonLine> show(tools::UnfinishedStroke const& stroke) override
    {
        auto const& scene = *stroke.scene;
        if (stroke.ink.empty() || (stroke.ink.size() < 2 && !scene.state.picture))
            return {};
        auto const what = stroke.tool.get<OutlineTool>()->what;
        if (what == OutlineTool::What::TurnRound)
            return {};
        if (what == OutlineTool::What::Carry)
            return copied(stroke.ink, scene);
        // An open line of the leaf option takes effect only when it ends, so there is nothing to
        // preview.
        if (what == OutlineTool::What::Leaf && !tools::is_coming_back(stroke.ink))
            return {};
        bool const is_touch = what == OutlineTool::What::Split || what == OutlineTool::What::Join;
        auto const ink = !is_touch && tools::is_coming_back(stroke.ink)
            ? closed(stroke.ink)
            : Stroke { std::vector(stroke.ink.begin(), stroke.ink.end()) };
        auto const edit = drawn_tree(*stroke.tool.get<OutlineTool>(), ink, scene);
        if (!edit)
            return {};
        if (may_become_a_branchs(*edit, scene))
            return {};
        auto tree = tree_with(*edit, scene);
        if (!tree)
            return {};
        // Beside a tree, an open line may still become an outline.
        if (edit->part == DrawTree::Part::Trunk && scene.plants.empty())
            return { line_of(points_of(edit->stroke), scene) };
        if (!tree->has_crown())
            return {};
        tree->form.levels = 1;
        auto const skeleton = silhouette::skeleton_of(*tree);
        if (!skeleton)
            return {};
        // Shows the branches inside all outlines, be it the crown's or a branch's. If the outline
        // was taken from the picture, it is shown too, because the pen has not drawn it.
        std::vector<tools::SkeletonLine> lines { line_of(skeleton->systems[0].whole_trunk(),
                                                         scene) };
        for (auto const& system : skeleton->systems)
            for (auto const& branch : system.branches) {
                lines.push_back(line_of(branch.path.curve.points(9), scene));
                if (branch.leaf)
                    lines.push_back(line_of(branch.crown, scene));
            }
        if (edit->stroke.tips.size() > stroke.ink.size() + 1)
            lines.push_back(line_of(points_of(edit->stroke), scene));
        return lines;
    }

private:
    static std::vector<Vec2> points_of(Stroke const& stroke)
    {
        std::vector<Vec2> points;
        for (auto const& tip : stroke.tips)
            points.emplace_back(tip.position_mm.head<2>());
        return points;
    }

    // Lines of the branches that the stroke crosses: the branch whose style is copied, and those
    // that take the style.
    static std::vector<tools::SkeletonLine> copied(std::span<TipSample const> ink,
                                                   scene::Scene const& scene)
    {
        auto const* const tree = silhouette::outlined_tree(*scene.drawn);
        if (!tree)
            return {};
        std::vector<Vec2> points;
        for (auto const& tip : ink)
            points.emplace_back(tip.position_mm.head<2>());
        auto const skeleton = silhouette::skeleton_of(*tree);
        if (!skeleton)
            return {};
        auto const styles = silhouette::copied_by(*skeleton, points);
        if (!styles)
            return {};
        std::vector<tools::SkeletonLine> lines;
        for (auto const& path : silhouette::paths_in(*styles))
            if (auto const at = skeleton->at(path))
                lines.push_back(
                    line_of(skeleton->systems[at->system].branches[at->branch].line(17), scene));
        return lines;
    }

    // True if an outline was drawn over an existing crown and has less than half of the crown's
    // area so far: when finished, it may be the outline of a branch or a new crown.
    static bool may_become_a_branchs(DrawTree const& edit, scene::Scene const& scene)
    {
        auto const* const tree = silhouette::outlined_tree(*scene.drawn);
        if (!tree || edit.plant == 0 || edit.part != DrawTree::Part::Outline)
            return false;
        return 2 * area_of(edit.stroke) < area_of(tree->outline);
    }

    static double area_of(Stroke const& stroke)
    {
        return std::fabs(silhouette::signed_area(points_of(stroke)));
    }

    static tools::SkeletonLine line_of(std::vector<Vec2> const& points, scene::Scene const& scene)
    {
        auto const paper = scene::paper_of(scene.state);
        tools::SkeletonLine line;
        line.state = tools::SkeletonLine::State::Assigned;
        for (auto const& point : points)
            line.points_mm.push_back(
                scene.placement.plant_of_world(paper.world_of_sheet(point)).cast<float>());
        return line;
    }
};

} // namespace

std::unique_ptr<tools::StrokePreviewer> outline_previewer()
{
    return std::make_unique<OutlinePreviewer>();
}

} // namespace tractus::silhouette
