#include "app/tools/shown_skeleton.h"

#include "engine/variation/selection.h"

namespace tractus {

// Millimetres of the tablet: a line as thin as it is shown, and a hand that need not hit it.
static constexpr PickOptions kPick { .line_half_width = 0.4, .finger = 2.5 };

ShownSkeleton::ShownSkeleton(Plant const& plant, SelectionAngle const& angle)
    : skeleton_(plant, skeleton_projection(fit_selection_view(plant, angle)))
    , tree_(build_branch_tree(plant))
{
}

Result<Selection> ShownSkeleton::paths_under(Stroke const& stroke) const
{
    PathSelection selection(tree_);
    SelectionPen pen(skeleton_, tree_, selection, kPick);
    for (auto const& tip : stroke.tips)
        pen.move_to(tip.position_mm.head<2>());
    auto paths = pen.lift();
    if (paths.empty())
        return fail(Fault::User,
                    "the selection touched no branch: draw over the skeleton, from a "
                    "branch's base towards its tip");
    return paths;
}

Result<SegmentId> ShownSkeleton::segment_under(TipSample const& tip) const
{
    auto const segment = skeleton_.pick(tip.position_mm.head<2>(), kPick);
    if (!segment)
        return fail(Fault::User,
                    "an end of the stroke is beside the skeleton: begin and end it on branches");
    return *segment;
}

ShownSkeleton::Touched ShownSkeleton::touched_by(std::span<TipSample const> tips) const
{
    PathSelection selection(tree_);
    SelectionPen pen(skeleton_, tree_, selection, kPick);
    for (auto const& tip : tips)
        pen.move_to(tip.position_mm.head<2>());
    return { selection.selected(), selection.undetermined() };
}

} // namespace tractus
