#include "app/tools/draw_in_order_tool.h"

#include "app/tools/branch_previewer.h"
#include "app/tools/erase_tool.h"
#include "engine/plant/join_axes.h"
#include "engine/scene/edit.h"

namespace tractus {

static Result<std::vector<Edit>> draw_in_order(Tool const&, Stroke const& stroke,
                                               Scene const& scene)
{
    auto const& order = scene.rest->drawing_order;
    if (order.empty())
        return fail(Fault::User,
                    "the plant has no branches for a stroke to shape: load another model");
    // One association per stroke, so their number says whose turn it is; after the last axis the
    // trunk's turn comes again.
    auto const turn = order[scene.associations.size() % order.size()];
    return std::vector<Edit> {
        select_paths(scene, { segments_of(scene.base->axes[turn]) }),
        Associate { stroke, Propagation::Selected },
    };
}

constexpr ToolKind DrawInOrderTool::kKind {
    .word = "draw_in_order",
    .label = "Branch by branch",
    .title = "Draw, branch by branch",
    .done = "The stroke shapes the branch",
    .help = "each stroke shapes the next branch, the trunk first",
    .group = "Draw",
    .icon = "19354279 7993 9381",
    .key = 'D',
    .options = options_type<DrawInOrderTool>(),
    .mean = draw_in_order,
    .previewer = branch_previewer,
    .other_end = { &EraseTool::kKind },
};

} // namespace tractus
