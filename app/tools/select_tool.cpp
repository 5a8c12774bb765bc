#include "app/tools/tool.h"
#include "engine/scene/desk_placement.h"
#include "engine/variation/branch_tree.h"
#include "engine/variation/projected_skeleton.h"
#include "engine/variation/selection.h"

namespace tractus {

Result<std::vector<Edit>> select_edits(Stroke const& stroke, Scene const& scene)
{
    // Millimetres of the tablet: a line as thin as it is shown, and a hand that need not hit it.
    constexpr PickOptions kPick { .line_half_width = 0.4, .finger = 2.5 };
    auto const view = skeleton_projection(fit_selection_view(*scene.base));
    ProjectedSkeleton const skeleton(*scene.base, view);
    auto const tree = build_branch_tree(*scene.base);
    PathSelection selection(tree);
    SelectionPen pen(skeleton, tree, selection, kPick);
    for (auto const& tip : stroke.tips)
        pen.move_to(tip.position_mm.head<2>());
    auto paths = pen.lift();
    if (paths.empty())
        return fail(Fault::User,
                    "the selection touched no branch: draw over the skeleton, from a "
                    "branch's base towards its tip");
    return std::vector<Edit> { Select { std::move(paths) } };
}

} // namespace tractus
