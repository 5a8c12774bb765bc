#include "app/tools/delete_tool.h"

#include "app/tools/erase_tool.h"
#include "app/tools/selected_strokes.h"

namespace tractus::tools {

static Result<std::vector<scene::Edit>> take_stroke_away(Tool const&, Stroke const&,
                                                         scene::Scene const& scene)
{
    return std::vector<scene::Edit> { scene::DeleteStroke { TRY(newest_selected_stroke(scene)) } };
}

constexpr ToolKind DeleteTool::kKind {
    .word = "delete",
    .label = "Take away",
    .title = "Take the branch's last stroke away",
    .done = "The stroke is gone",
    .help = "takes the selected branch's last stroke away",
    .group = "Draw",
    .at_once = true,
    .options = options_type<DeleteTool>(),
    .edits_for = take_stroke_away,
    .other_end = { &EraseTool::kKind },
};

} // namespace tractus::tools
