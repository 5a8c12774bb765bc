#include "app/methods/silhouettes/crown_tool.h"

#include "app/methods/silhouettes/erase_crown_tool.h"
#include "engine/methods/silhouettes/crown_line.h"
#include "engine/scene/paper.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace tractus::silhouette {

namespace {

using silhouette::CrownLine;
using silhouette::DrawTree;
using silhouette::OutlinedTree;

// Option words, in the order of the enumeration What.
constexpr std::array<tools::OptionWord, 2> kCrownWords { {
    { "go_on", "Go on" },
    { "new", "New tree" },
} };

void visit_crown(tools::OptionVisitor& visitor, CrownTool& tool)
{
    visitor.choice(
        { .words = kCrownWords, .offered = tools::WordOption::Offered::InHand, .label = "Crown" },
        tool.what);
    visit_nodes(visitor, tool.nodes);
    visit_fills(visitor, tool.fills);
}

// The active tree if the line goes around its trunk and thus belongs to its crown; otherwise null.
// The line is in coordinates of the active tree's sheet.
Result<OutlinedTree const*> tree_inside(CrownLine const& line, scene::Scene const& scene)
{
    auto const* const tree = silhouette::outlined_tree(*scene.drawn);
    if (!tree || tree->is_leaf)
        return nullptr;
    auto const foot_mm = TRY(silhouette::foot_of(*tree));
    auto const kind = TRY(silhouette::kind_of(line));
    std::vector<Vec2> plan;
    for (auto const& point : line)
        plan.emplace_back(point.x(), point.z());
    Vec2 const trunk(foot_mm.x(), 0);
    if (kind != silhouette::CrownLineKind::Side)
        return silhouette::is_inside(plan, trunk) ? tree : nullptr;
    auto const box = silhouette::box_of(plan);
    bool const is_around = (trunk - box.middle()).norm() < box.diagonal() / 2;
    return is_around ? tree : nullptr;
}

Result<std::vector<scene::Edit>> mean_crown(tools::Tool const& tool, Stroke const& stroke,
                                            scene::Scene const& scene)
{
    auto const& options = *tool.get<CrownTool>();
    return std::vector<scene::Edit> { TRY(drawn_crown(options, stroke, scene)) };
}

std::string counted_lines(std::size_t count, char const* one, char const* many)
{
    return fmt::format("{} {}", count, count == 1 ? one : many);
}

// Message for the user: the lines through which the crown's surface goes now, and the number of
// branches.
std::string describe_crown(tools::Tool const&, scene::Scene const& after)
{
    auto const* const tree = silhouette::outlined_tree(*after.drawn);
    if (!tree)
        return {};
    std::array<std::size_t, 3> counts {};
    for (auto const& drawn : tree->crown_lines) {
        auto const line = silhouette::crown_line_of(drawn.stroke);
        if (auto const kind = line
                ? silhouette::kind_of(*line)
                : Result<silhouette::CrownLineKind>(tl::unexpected(line.error())))
            ++counts[static_cast<std::size_t>(*kind)];
    }
    std::string lines;
    auto const add = [&](std::size_t count, char const* one, char const* many) {
        if (count > 0)
            lines += (lines.empty() ? "" : ", ") + counted_lines(count, one, many);
    };
    add(counts[0], "ring", "rings");
    add(counts[1], "climbing line", "climbing lines");
    add(counts[2] + !tree->outline.tips.empty(), "outline", "outlines");
    auto const& axes = after.base->axes;
    auto const on_trunk
        = std::count_if(axes.begin(), axes.end(), [](Axis const& axis) { return axis.order == 1; });
    return fmt::format("The crown goes through {}: {} branches on the trunk, {} in all", lines,
                       on_trunk, axes.size() - 1);
}

} // namespace

Stroke on_sheet(Stroke stroke, scene::Paper const& paper)
{
    std::vector<TipSample> tips;
    for (auto tip : stroke.tips) {
        Vec3 const world_mm = tip.position_mm;
        tip.position_mm << paper.sheet_of_world(world_mm),
            (world_mm.y() - paper.world_point_mm.y()) / paper.unit;
        tips.push_back(tip);
    }
    stroke.tips = std::move(tips);
    return stroke;
}

Result<DrawTree> drawn_crown(CrownTool const& tool, Stroke const& stroke, scene::Scene const& scene)
{
    DrawTree edit { .part = DrawTree::Part::Surface };
    auto paper = scene::paper_of(scene.state);
    edit.stroke = on_sheet(stroke, paper);
    auto line = TRY(silhouette::crown_line_of(edit.stroke));
    TRY(silhouette::kind_of(line));
    if (tool.what == CrownTool::What::GoOn && TRY(tree_inside(line, scene))) {
        edit.plant = scene.drawn->id;
        return edit;
    }
    edit.form.has_whole_nodes = tool.nodes == NodesOption::Whole;
    if (tool.fills != FillsOption::AsAtFirst)
        edit.form.plane_branches = kUsualPlaneBranches;
    edit.form.leaves_reach_outline = tool.fills >= FillsOption::ToOutline;
    // The new tree's sheet has its centre at the line and is as large as the tablet.
    paper = { paper.sheet_of_world(Vec3(paper.world_point_mm.x(), 0, 0)),
              Vec3(paper.world_point_mm.x(), paper.world_point_mm.y(), 0) };
    edit.stroke = on_sheet(stroke, paper);
    line = TRY(silhouette::crown_line_of(edit.stroke));
    Vec2 const middle = silhouette::plan_middle(line);
    paper.world_point_mm.y() += middle.y();
    edit.stroke = on_sheet(stroke, paper);
    edit.ground_mm = Vec2(middle.x(), paper.sheet_of_world(Vec3::Zero()).y());
    edit.stands_at_mm = paper.world_of_sheet(*edit.ground_mm);
    edit.stands_at_mm.z() = 0;
    if (!scene.plants.empty())
        edit.scale = scene.placement.scale;
    return edit;
}

constexpr tools::ToolKind CrownTool::kKind {
    .word = "crown_line",
    .label = "Crown in space",
    .title = "Rings around the crown, or a line that climbs around it",
    .done = "The crown has the line",
    .help = "draws a tree's crown in space: rings around its trunk at several heights, a line that "
            "winds around it as it climbs, or outlines in upright planes; the branches reach to "
            "the surface through these; of a new tree, or with whole nodes and filled by "
            "spacing, as an outline's tree",
    .group = "Sketch",
    .method = "From an outline",
    .min_extent_mm = 5,
    .options = tools::options_type<CrownTool, visit_crown>(),
    .edits_for = mean_crown,
    .describe = describe_crown,
    .previewer = crown_previewer,
    .other_end = { &EraseCrownTool::kKind },
};

} // namespace tractus::silhouette
