#include "app/tools/oversketch_tool.h"

#include "app/tools/branch_previewer.h"
#include "app/tools/erase_tool.h"
#include "app/tools/selected_strokes.h"

namespace tractus::tools {

static Result<std::vector<scene::Edit>> oversketch(Tool const&, Stroke const& stroke,
                                                   scene::Scene const& scene)
{
    return std::vector<scene::Edit> { scene::Oversketch { TRY(newest_selected_stroke(scene)),
                                                          stroke } };
}

constexpr ToolKind OversketchTool::kKind {
    .word = "oversketch",
    .label = "Redraw",
    .title = "Redraw a part of the branch's stroke",
    .done = "The branch follows its stroke",
    .help = "redraws a part of the selected branch's stroke",
    .group = "Draw",
    .begins_group_of_buttons = true,
    .min_extent_mm = 6,
    .options = options_type<OversketchTool>(),
    .edits_for = oversketch,
    .previewer = branch_previewer,
    .other_end = { &EraseTool::kKind },
};

} // namespace tractus::tools
