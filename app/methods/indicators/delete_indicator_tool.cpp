#include "app/methods/indicators/delete_indicator_tool.h"

#include "app/methods/indicators/touched_indicator.h"
#include "app/tools/erase_tool.h"
#include "engine/scene/edit.h"

namespace tractus::indicators {

static Result<std::vector<scene::Edit>> delete_indicator(tools::Tool const&, Stroke const& stroke,
                                                         scene::Scene const& scene)
{
    auto const number = TRY(touched_indicator(stroke, scene)).number;
    return std::vector<scene::Edit> { scene::DeleteIndicator { scene.indicators[number].id } };
}

constexpr tools::ToolKind DeleteIndicatorTool::kKind {
    .word = "delete_indicator",
    .label = "Remove",
    .title = "Take a motion indicator away",
    .done = "The motion indicator is gone",
    .help = "takes the motion indicator away where the stroke begins",
    .group = "Lean",
    .options = tools::options_type<DeleteIndicatorTool>(),
    .edits_for = delete_indicator,
    .other_end = { &tools::EraseTool::kKind },
};

} // namespace tractus::indicators
