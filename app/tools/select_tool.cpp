#include "app/tools/shown_skeleton.h"
#include "app/tools/tool.h"
#include "engine/base/check.h"

namespace tractus {

namespace {

Result<Selection> selection_of(Tool const& tool, Stroke const& stroke, Scene const& scene)
{
    auto const selecting = tool.selecting;
    using Selecting = Tool::Selecting;
    auto const& plant = *scene.base;
    if (selecting == Selecting::Nothing)
        return Selection {};
    if (selecting == Selecting::Invert)
        return inverted(plant, scene.selection);
    ShownSkeleton const shown(plant, tool.angle);
    switch (selecting) {
    case Selecting::Ends: {
        auto const first = TRY(shown.segment_under(stroke.tips.front()));
        auto const last = TRY(shown.segment_under(stroke.tips.back()));
        return Selection { TRY(path_by_ends(shown.tree(), first, last)) };
    }
    case Selecting::Order: {
        auto const segment = TRY(shown.segment_under(stroke.tips.back()));
        return axes_of_order(plant, plant.axes[axis_of(plant, segment)].order);
    }
    case Selecting::Alike:
        return siblings_alike(plant, TRY(shown.segment_under(stroke.tips.back())));
    case Selecting::Add:
        return added(scene.selection, TRY(shown.paths_under(stroke)));
    case Selecting::Take:
        return taken(scene.selection, TRY(shown.paths_under(stroke)));
    default:
        return shown.paths_under(stroke);
    }
}

} // namespace

Result<std::vector<Edit>> select_edits(Tool const& tool, Stroke const& stroke, Scene const& scene)
{
    CHECK(!stroke.tips.empty() || tool.selecting == Tool::Selecting::Nothing
          || tool.selecting == Tool::Selecting::Invert);
    return std::vector<Edit> { select_paths(scene, TRY(selection_of(tool, stroke, scene))) };
}

} // namespace tractus
