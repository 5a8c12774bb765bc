#include "app/methods/self_organising/prune_tool.h"

#include "app/methods/self_organising/growth_brush_tool.h"
#include "app/tools/bent_plant.h"
#include "engine/methods/self_organising/brush.h"
#include "engine/methods/self_organising/grown_tree.h"
#include "engine/stroke/polyline.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace tractus::self_organising {

namespace {

// Option words, in the order of PruneTool::What.
constexpr std::array<tools::OptionWord, 2> kPruneWords { {
    { "prune", "Prune", "Prune a tree" },
    { "clear", "Clear space", "Clear space of the growth brush" },
} };

void visit(tools::OptionVisitor& visitor, PruneTool& tool)
{
    visitor.choice({ kPruneWords }, tool.what);
    visitor.number({ "least_radius", "mm", 0.5, 100, 0.5, "Light" }, tool.min_radius_mm);
    visitor.number({ "radius", "mm", 1, 200, 1, "Pressed" }, tool.most_radius_mm);
}

// True if the brush touches an internode of the active plant, as bent by strokes.
Result<bool> touches(LifePeriod const& part, scene::Scene const& scene)
{
    auto balls = TRY(brush_balls(part));
    balls = dense_path(balls);
    Eigen::AlignedBox3d reach;
    for (auto const& ball : balls) {
        reach.extend(ball.centre + Vec3::Constant(ball.radius));
        reach.extend(ball.centre - Vec3::Constant(ball.radius));
    }
    auto const nodes = tools::BentPlant(scene).nodes_mm();
    for (auto const& axis : scene.base->axes)
        for (auto i = axis.first_node; i < axis.first_node + axis.segment_count; ++i) {
            if (!reach.intersects(Eigen::AlignedBox3d(nodes[i]).extend(nodes[i + 1])))
                continue;
            for (auto const& ball : balls) {
                double const share = nearest_share<Vec3>(ball.centre, nodes[i], nodes[i + 1]);
                Vec3 const nearest = nodes[i] + share * (nodes[i + 1] - nodes[i]);
                if ((nearest - ball.centre).squaredNorm() <= ball.radius * ball.radius)
                    return true;
            }
        }
    return false;
}

bool has_brushed(GrownTree const& tree)
{
    return std::any_of(tree.life.begin(), tree.life.end(), [](LifePeriod const& part) {
        return part.kind == LifePeriod::Kind::Grow && !part.stroke.tips.empty();
    });
}

Result<std::vector<scene::Edit>> prune_edits(tools::Tool const& tool, Stroke const& stroke,
                                             scene::Scene const& scene)
{
    auto const& options = *tool.get<PruneTool>();
    bool const clears = options.what == PruneTool::What::Clear;
    auto const* const tree = scene.plants.empty() ? nullptr : grown_tree_of(scene.drawn->source);
    if (!tree)
        return fail(Fault::User,
                    "the plant that takes what is drawn has not grown by itself or under the "
                    "brush, so that no buds of it could wake: choose one that has, or let this one "
                    "grow on first (From any plant)");
    if (clears && !has_brushed(*tree))
        return fail(Fault::User,
                    "no brush has swept space for this tree that could be cleared: "
                    "prune it instead");
    LifePeriod part { .kind = clears ? LifePeriod::Kind::Clear : LifePeriod::Kind::Prune,
                      .stroke = stroke,
                      .min_radius_mm = options.min_radius_mm,
                      .most_radius_mm = options.most_radius_mm,
                      .stands_at_mm = scene.drawn->stands_at_mm,
                      .scale = scene.placement.scale };
    TRY(check_life(part));
    if (clears) // Space can be cleared even if the brush touches no branch.
        return std::vector<scene::Edit> { GrowOn { scene.drawn->id, std::move(part) } };
    if (!TRY(touches(part, scene)))
        return fail(Fault::User, "the brush touched no branch: move it over what shall be cut off");
    return std::vector { TRY(grow_from_active(scene, tree->habit, std::move(part))) };
}

} // namespace

constexpr tools::ToolKind PruneTool::kKind {
    .word = "prune_brush",
    .label = "Prune",
    .title = "Prune a tree",
    .done = "It is pruned",
    .help
    = "cuts off what a ball about the pen's tip touches of a tree that grows by itself, so "
      "that buds below the cuts wake; or takes back space that the growth brush has swept, so "
      "that the tree is as if the brush had not been there. The other end of the growth "
      "brush's pen does it, too",
    .group = "Sketch",
    .method = "Growth brush",
    .ink = { tools::InkStyle::Look::Eraser, 8 },
    .options = tools::options_type<PruneTool, visit>(),
    .edits_for = prune_edits,
    .other_end = { &PruneTool::kKind },
};

} // namespace tractus::self_organising
