#include "app/tools/smooth_tool.h"

#include "app/tools/erase_tool.h"
#include "app/tools/selected_strokes.h"

namespace tractus::tools {

static Result<std::vector<scene::Edit>> smooth(Tool const&, Stroke const&,
                                               scene::Scene const& scene)
{
    return std::vector<scene::Edit> { scene::SmoothStroke { TRY(selected_strokes(scene)), 0 } };
}

constexpr ToolKind SmoothTool::kKind {
    .word = "smooth",
    .label = "Smooth",
    .title = "Smooth the branch's strokes",
    .done = "The branch follows its stroke",
    .help = "takes the hand out of the selected branch's strokes",
    .group = "Draw",
    .at_once = true,
    .options = options_type<SmoothTool>(),
    .edits_for = smooth,
    .other_end = { &EraseTool::kKind },
};

} // namespace tractus::tools
