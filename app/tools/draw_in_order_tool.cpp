#include "app/tools/draw_in_order_tool.h"

#include "app/tools/branch_previewer.h"
#include "app/tools/draw_tool.h"
#include "app/tools/erase_tool.h"
#include "engine/plant/join_axes.h"
#include "engine/scene/edit.h"

#include <utility>

namespace tractus::tools {

// The branch that the next stroke shapes; empty for a plant without branches. Each stroke adds one
// association, so the number of associations shows which axis is next. After the last axis, drawing
// starts again with the trunk.
static std::vector<SegmentId> next_branch(scene::Scene const& scene)
{
    auto const& order = scene.rest->drawing_order;
    if (order.empty())
        return {};
    return segments_of(scene.base->axes[order[scene.associations.size() % order.size()]]);
}

static Result<std::vector<scene::Edit>> draw_in_order(Tool const& tool, Stroke const& stroke,
                                                      scene::Scene const& scene)
{
    auto const& options = *tool.get<DrawInOrderTool>();
    auto next = next_branch(scene);
    if (next.empty())
        return fail(Fault::User,
                    "the plant has no branches for a stroke to shape: load another model");
    auto [drawn, is_reversed] = from_foot(options.base, stroke, next, scene);
    return std::vector<scene::Edit> {
        scene::select_paths(scene, { std::move(next) }),
        scene::Associate { .stroke = std::move(drawn),
                           .fit = options.fit,
                           .laying = options.laying,
                           .is_drawn_reversed = is_reversed },
    };
}

static void visit(OptionVisitor& visitor, DrawInOrderTool& tool)
{
    visit_laying(visitor, WordOption::Offered::BesideLabel, tool.fit, tool.laying);
    visit_base(visitor, tool.base);
}

constexpr ToolKind DrawInOrderTool::kKind {
    .word = "draw_in_order",
    .label = "Branch by branch",
    .title = "Draw, branch by branch",
    .done = "The stroke shapes the branch",
    .help = "each stroke shapes the next branch, the trunk first; fitted as with draw",
    .group = "Draw",
    .icon = "19354279 7993 9381",
    .key = 'D',
    .min_extent_mm = 6,
    .options = options_type<DrawInOrderTool, visit>(),
    .edits_for = draw_in_order,
    .describe = bent_branch_message,
    .previewer = branch_previewer,
    .aims_at = next_branch,
    .other_end = { &EraseTool::kKind },
};

} // namespace tractus::tools
