#include "app/methods/plants/hide_branch_tool.h"

#include "app/methods/plants/touched_plant.h"
#include "app/tools/erase_tool.h"
#include "engine/scene/edit.h"

#include <algorithm>
#include <array>
#include <set>

namespace tractus::plants {

namespace {

// Option words, in the order of the enumeration What.
constexpr std::array<tools::OptionWord, 2> kBranchWords { {
    { "selected", "Hide branch", nullptr, true },
    { "none", "Show branches", nullptr, true },
} };

void visit(tools::OptionVisitor& visitor, HideBranchTool& tool)
{
    visitor.choice({ kBranchWords }, tool.what);
}

// First segments of the branches to be hidden. Of each selected path, only the part on its last
// axis is hidden, so that the axes leading to the branch stay visible.
std::set<SegmentId> chosen_branches(scene::BuiltPlant const& plant)
{
    std::set<SegmentId> firsts;
    for (auto const& path : plant.selection) {
        auto const& axis = plant.base->axes[axis_of(*plant.base, path.back())];
        firsts.insert(*std::find_if(path.begin(), path.end(), [&](SegmentId segment) {
            return segment >= axis.first_segment && segment <= path.back();
        }));
    }
    return firsts;
}

Result<std::vector<scene::Edit>> hide_branches(tools::Tool const& tool, Stroke const&,
                                               scene::Scene const& scene)
{
    auto const plant = TRY(active_plant_of(scene));
    std::vector<scene::Edit> edits;
    if (tool.get<HideBranchTool>()->what == HideBranchTool::What::None) {
        for (auto const& at : scene.drawn->hidden_branches)
            edits.push_back(scene::HideBranch { plant, at, false });
        if (edits.empty())
            return fail(Fault::User, "no branch is hidden");
        return edits;
    }
    for (auto const segment : chosen_branches(scene))
        edits.push_back(
            scene::HideBranch { plant, scene.rest->addresses.address_of(*scene.base, segment) });
    if (edits.empty())
        return fail(Fault::User, "no branch is selected: select what is to be hidden");
    return edits;
}

} // namespace

constexpr tools::ToolKind HideBranchTool::kKind {
    .word = "hide_branch",
    .label = "Hide branch",
    .title = "Hide branches",
    .done = "What was drawn on them waits until they are shown",
    .help = "hides the branches that are selected with all that they bear, or shows all that are "
            "hidden on the plant that takes what is drawn",
    .group = "Plants",
    .at_once = true,
    .options = tools::options_type<HideBranchTool, visit>(),
    .edits_for = hide_branches,
    .other_end = { &tools::EraseTool::kKind },
};

} // namespace tractus::plants
