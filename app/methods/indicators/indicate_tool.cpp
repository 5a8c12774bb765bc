#include "app/methods/indicators/indicate_tool.h"

#include "app/tools/erase_tool.h"
#include "engine/scene/edit.h"

#include <algorithm>
#include <array>

namespace tractus::indicators {

namespace {

// Option words, in the order of the enumeration Reach.
constexpr std::array<tools::OptionWord, 3> kReachWords { {
    { "everywhere", "Everywhere" },
    { "below", "Selected and above" },
    { "near", "Near it" },
} };

// Option words, in the order of MotionIndicator::Kind.
constexpr std::array<tools::OptionWord, 2> kIndicatorWords { {
    { "push", "Wind" },
    { "light", "Light" },
} };

void visit(tools::OptionVisitor& visitor, IndicateTool& tool)
{
    visitor.choice({ kReachWords }, tool.reach);
    visitor.choice({ kIndicatorWords }, tool.indicator);
}

// Distance over which an indicator with Reach::Near acts: its length, but at least kMin_mm.
double reach_of_mm(variation::MotionIndicator const& indicator)
{
    constexpr double kMin_mm = 20;
    return std::max(kMin_mm, (indicator.end_mm - indicator.start_mm).norm());
}

Result<std::vector<scene::Edit>> indicate(tools::Tool const& tool, Stroke const& stroke,
                                          scene::Scene const& scene)
{
    auto const& options = *tool.get<IndicateTool>();
    auto indicator = TRY(variation::motion_indicator(stroke));
    indicator.kind = options.indicator;
    if (options.reach == IndicateTool::Reach::Near)
        indicator.reach_mm = reach_of_mm(indicator);
    std::vector<SegmentAddress> below;
    if (options.reach == IndicateTool::Reach::Below) {
        if (scene.selection.empty())
            return fail(Fault::User,
                        "nothing is selected for the motion indicator to act on: select a branch "
                        "first");
        for (auto const& path : scene.selection)
            below.push_back(scene.rest->addresses.address_of(*scene.base, path.front()));
    }
    return std::vector<scene::Edit> { scene::Indicate { indicator, below } };
}

} // namespace

constexpr tools::ToolKind IndicateTool::kKind {
    .word = "indicate",
    .label = "Lean",
    .title = "Motion indicator",
    .done = "The plant leans with the indicator",
    .help = "a motion indicator: acts everywhere, on the selected branches and what they bear, or "
            "near it; as wind, or as a lamp at its end",
    .group = "Lean",
    .icon = "1585 8563 8567",
    .key = 'L',
    .min_extent_mm = 5,
    .ink = { tools::InkStyle::Look::Arrow },
    .options = tools::options_type<IndicateTool, visit>(),
    .edits_for = indicate,
    .other_end = { &tools::EraseTool::kKind },
};

} // namespace tractus::indicators
