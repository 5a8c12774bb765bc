#include "app/tools/turn_stroke_tool.h"

#include "app/tools/erase_tool.h"
#include "app/tools/selected_strokes.h"

namespace tractus::tools {

static Result<std::vector<scene::Edit>> turn_stroke(Tool const&, Stroke const&,
                                                    scene::Scene const& scene)
{
    return std::vector<scene::Edit> { scene::TurnStroke { TRY(newest_selected_stroke(scene)) } };
}

constexpr ToolKind TurnStrokeTool::kKind {
    .word = "turn_stroke",
    .label = "Turn round",
    .title = "Turn the branch's last stroke round",
    .done = "The stroke is turned round",
    .help = "turns the selected branch's last stroke round: its tip and its foot are exchanged",
    .group = "Draw",
    .at_once = true,
    .options = options_type<TurnStrokeTool>(),
    .edits_for = turn_stroke,
    .other_end = { &EraseTool::kKind },
};

} // namespace tractus::tools
