#include "app/tools/select_tool.h"

#include "app/tools/shown_skeleton.h"
#include "engine/base/check.h"
#include "engine/scene/edit.h"

#include <array>

namespace tractus::tools {

namespace {

using SelectionMode = SelectTool::SelectionMode;

// Option words, in the order of SelectionMode.
constexpr std::array<OptionWord, 8> kSelectingWords { {
    { "path", "Path" },
    { "ends", "By its ends" },
    { "add", "Add" },
    { "take", "Take" },
    { "order", "Whole order" },
    { "alike", "All alike" },
    { .word = "invert", .label = "Invert", .at_once = true },
    { .word = "nothing", .label = "Nothing", .at_once = true },
} };

void visit(OptionVisitor& visitor, SelectTool& tool)
{
    visitor.choice({ kSelectingWords }, tool.selecting);
}

Result<variation::Selection> selection_of(Tool const& tool, Stroke const& stroke,
                                          scene::Scene const& scene)
{
    auto const selecting = tool.get<SelectTool>()->selecting;
    auto const& plant = *scene.base;
    if (selecting == SelectionMode::Nothing)
        return variation::Selection {};
    if (selecting == SelectionMode::Invert)
        return variation::inverted(plant, scene.selection);
    ShownSkeleton const shown(scene, tool.angle());
    switch (selecting) {
    case SelectionMode::Ends: {
        auto const first = TRY(shown.segment_under(stroke.tips.front()));
        auto const last = TRY(shown.segment_under(stroke.tips.back()));
        return variation::Selection { TRY(variation::path_by_ends(shown.tree(), first, last)) };
    }
    case SelectionMode::Order: {
        auto const segment = TRY(shown.segment_under(stroke.tips.back()));
        return variation::axes_of_order(plant, plant.axes[axis_of(plant, segment)].order);
    }
    case SelectionMode::Alike:
        return variation::similar_siblings(plant, TRY(shown.segment_under(stroke.tips.back())));
    case SelectionMode::Add:
        return variation::added(scene.selection, TRY(shown.paths_under(stroke)));
    case SelectionMode::Take:
        return variation::taken(scene.selection, TRY(shown.paths_under(stroke)));
    default:
        return shown.paths_under(stroke);
    }
}

Result<std::vector<scene::Edit>> select(Tool const& tool, Stroke const& stroke,
                                        scene::Scene const& scene)
{
    CHECK(!stroke.tips.empty() || tool.needs_no_stroke());
    return std::vector<scene::Edit> { scene::select_paths(scene,
                                                          TRY(selection_of(tool, stroke, scene))) };
}

bool selects_path(Tool const& tool)
{
    auto const selecting = tool.get<SelectTool>()->selecting;
    return selecting == SelectionMode::Path || selecting == SelectionMode::Add
        || selecting == SelectionMode::Take;
}

// Options of the tool at the pen's other end. The skeleton's picture has nothing to erase, so that
// end deselects.
std::shared_ptr<void> taking()
{
    return std::make_shared<SelectTool>(SelectTool { SelectionMode::Take });
}

} // namespace

constexpr ToolKind SelectTool::kKind {
    .word = "select",
    .label = "Select",
    .title = "Select",
    .done = "A branch is selected",
    .help = "chooses the path under the stroke, or all between two branches; adds the path to what "
            "is chosen, takes it away; all of one order, of one look; the others; none",
    .group = "Select",
    .icon = "1949 4945 454141 4144 44594945",
    .key = 'C',
    .surface = Surface::Skeleton,
    .options = options_type<SelectTool, visit>(),
    .edits_for = select,
    .marks_branches = selects_path,
    .other_end = { &SelectTool::kKind, taking },
};

} // namespace tractus::tools
