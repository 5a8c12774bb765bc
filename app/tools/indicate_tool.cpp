#include "app/tools/tool.h"

#include <algorithm>

namespace tractus {

namespace {

// An indicator that falls off reaches as far as it is long, and a little more if it is short.
double reach_of_mm(MotionIndicator const& indicator)
{
    constexpr double kLeast_mm = 20;
    return std::max(kLeast_mm, (indicator.end_mm - indicator.start_mm).norm());
}

} // namespace

Result<std::vector<Edit>> indicate_edits(Tool const& tool, Stroke const& stroke, Scene const& scene)
{
    auto indicator = TRY(motion_indicator(stroke));
    indicator.kind = tool.indicator;
    if (tool.reach == Tool::Reach::Near)
        indicator.reach_mm = reach_of_mm(indicator);
    std::vector<SegmentAddress> below;
    if (tool.reach == Tool::Reach::Below) {
        if (scene.selection.empty())
            return fail(Fault::User,
                        "nothing is selected for the motion indicator to act on: select a branch "
                        "first");
        for (auto const& path : scene.selection)
            below.push_back(scene.rest->addresses.address_of(*scene.base, path.front()));
    }
    return std::vector<Edit> { Indicate { indicator, below } };
}

// The indicator is the one that passes near the place where the stroke begins.
Result<std::vector<Edit>> indicator_edits(Tool::Kind kind, Stroke const& stroke, Scene const& scene)
{
    constexpr double kFinger_mm = 25;
    auto const way = TRY(motion_indicator(stroke));
    auto const number = nearest_indicator(motion_indicators(scene), way.start_mm, kFinger_mm);
    if (!number)
        return fail(Fault::User,
                    "there is no motion indicator where the stroke begins: begin it on one");
    auto const& [id, indicator, at] = scene.indicators[*number];
    if (kind == Tool::Kind::DeleteIndicator)
        return std::vector<Edit> { DeleteIndicator { id } };
    auto moved = indicator;
    moved.below.clear(); // It stays where it is.
    moved.start_mm += way.end_mm - way.start_mm;
    moved.end_mm += way.end_mm - way.start_mm;
    return std::vector<Edit> { ChangeIndicator { .which = id, .indicator = moved } };
}

} // namespace tractus
