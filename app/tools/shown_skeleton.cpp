#include "app/tools/shown_skeleton.h"

#include "engine/scene/scene_shaper.h"
#include "engine/variation/place_nodes.h"
#include "engine/variation/selection.h"

namespace tractus::tools {

// Tolerances in millimetres on the tablet: half the width of a line as shown, and the inaccuracy of
// a hand.
static constexpr variation::PickOptions kPick { .line_half_width = 0.4, .finger = 2.5 };

// The parts of a bent plant that picking needs. Each stroke was checked when it was drawn; if a
// stroke cannot be read now, the plant stays at rest.
static Plant bent_skeleton(scene::BuiltPlant const& plant)
{
    Plant bent;
    bent.axes = plant.base->axes;
    bent.node_radius_mm = plant.base->node_radius_mm;
    bent.segment_material = plant.base->segment_material;
    scene::SceneShaper shaper;
    static_cast<void>(shaper.set_plant(plant));
    variation::place_nodes(*plant.base, *plant.rest, shaper.shape(), bent.node_position_mm);
    return bent;
}

ShownSkeleton::ShownSkeleton(Plant const& plant, scene::SelectionAngle const& angle)
    : skeleton_(plant, scene::skeleton_projection(scene::fit_selection_view(plant, angle)))
    , tree_(variation::build_branch_tree(plant))
{
}

ShownSkeleton::ShownSkeleton(scene::BuiltPlant const& plant, scene::SelectionAngle const& angle)
    : skeleton_(angle.shape == scene::SelectionAngle::Shape::AsBent ? bent_skeleton(plant)
                                                                    : *plant.base,
                scene::skeleton_projection(scene::fit_selection_view(*plant.base, angle)))
    , tree_(variation::build_branch_tree(*plant.base))
{
}

Result<variation::Selection> ShownSkeleton::paths_under(Stroke const& stroke) const
{
    variation::PathSelection selection(tree_);
    variation::SelectionPen pen(skeleton_, tree_, selection, kPick);
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
    variation::PathSelection selection(tree_);
    variation::SelectionPen pen(skeleton_, tree_, selection, kPick);
    for (auto const& tip : tips)
        pen.move_to(tip.position_mm.head<2>());
    return { selection.selected(), selection.undetermined() };
}

} // namespace tractus::tools
