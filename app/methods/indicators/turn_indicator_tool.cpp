#include "app/methods/indicators/turn_indicator_tool.h"

#include "app/methods/indicators/touched_indicator.h"
#include "app/tools/erase_tool.h"
#include "engine/scene/edit.h"

#include <utility>

namespace tractus::indicators {

static Result<std::vector<scene::Edit>> turn_indicator(tools::Tool const&, Stroke const& stroke,
                                                       scene::Scene const& scene)
{
    auto const number = TRY(touched_indicator(stroke, scene)).number;
    auto turned = scene.indicators[number].what;
    // Not needed: the document keeps the addresses of the indicator's branches.
    turned.below.clear();
    std::swap(turned.start_mm, turned.end_mm);
    return std::vector<scene::Edit> { scene::ChangeIndicator { .which = scene.indicators[number].id,
                                                               .indicator = turned } };
}

constexpr tools::ToolKind TurnIndicatorTool::kKind {
    .word = "turn_indicator",
    .label = "Turn round",
    .title = "Turn a motion indicator round",
    .done = "The motion indicator points the other way",
    .help = "turns the motion indicator round where the stroke begins",
    .group = "Lean",
    .options = tools::options_type<TurnIndicatorTool>(),
    .edits_for = turn_indicator,
    .other_end = { &tools::EraseTool::kKind },
};

} // namespace tractus::indicators
