#include "app/methods/indicators/move_indicator_tool.h"

#include "app/methods/indicators/touched_indicator.h"
#include "app/tools/erase_tool.h"
#include "engine/scene/edit.h"

namespace tractus::indicators {

static Result<std::vector<scene::Edit>> move_indicator(tools::Tool const&, Stroke const& stroke,
                                                       scene::Scene const& scene)
{
    auto const touched = TRY(touched_indicator(stroke, scene));
    auto const& [id, indicator, at] = scene.indicators[touched.number];
    auto moved = indicator;
    // Not needed: the document keeps the addresses of the indicator's branches.
    moved.below.clear();
    moved.start_mm += touched.way.end_mm - touched.way.start_mm;
    moved.end_mm += touched.way.end_mm - touched.way.start_mm;
    return std::vector<scene::Edit> { scene::ChangeIndicator { .which = id, .indicator = moved } };
}

constexpr tools::ToolKind MoveIndicatorTool::kKind {
    .word = "move_indicator",
    .label = "Move",
    .title = "Move a motion indicator",
    .done = "The plant leans with the indicator",
    .help = "moves the motion indicator where the stroke begins along with it",
    .group = "Lean",
    .begins_group_of_buttons = true,
    .min_extent_mm = 2,
    .options = tools::options_type<MoveIndicatorTool>(),
    .edits_for = move_indicator,
    .other_end = { &tools::EraseTool::kKind },
};

} // namespace tractus::indicators
