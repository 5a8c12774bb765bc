#include "app/tools/stroke_base.h"

#include "app/tools/bent_plant.h"
#include "app/tools/underground.h"
#include "engine/scene/anchored.h"
#include "engine/stroke/foot_first.h"

#include <array>
#include <vector>

namespace tractus::tools {

namespace {

// Option words, in the order of the enumeration StrokeBase.
constexpr std::array<OptionWord, 2> kBaseWords { {
    { "from_beginning", "From its beginning" },
    { "from_foot", "From its foot" },
} };

bool is_trunk(Plant const& plant, std::span<SegmentId const> branch)
{
    auto const& axis = plant.axes[axis_of(plant, branch.front())];
    return axis.parent_segment == kNone && axis.first_segment == branch.front();
}

// True if a stroke comes down to the ground. One that goes on below it is meant to hang.
bool comes_down(std::vector<Vec3> const& tips_mm, double ground_mm)
{
    // Maximum depth of the stroke's end below the ground, as a share of its descent.
    constexpr double kBelow = 0.3;
    double const end_mm = tips_mm.back().z();
    return is_drawn_to_foot(tips_mm, ground_mm)
        && end_mm > ground_mm - kBelow * (tips_mm.front().z() - end_mm);
}

bool ends_at_foot(Stroke const& stroke, std::span<SegmentId const> branch,
                  scene::Scene const& scene)
{
    std::vector<Vec3> tips_mm;
    for (auto const& tip : stroke.tips)
        tips_mm.push_back(tip.position_mm);
    if (tips_mm.empty())
        return false;
    if (is_trunk(*scene.base, branch) && comes_down(tips_mm, scene.placement.origin_mm.z()))
        return true;
    BentPlant const bent(scene);
    return is_drawn_to_foot_of(tips_mm, bent.begin_of(branch.front()), bent.end_of(branch.back()));
}

} // namespace

void visit_base(OptionVisitor& visitor, StrokeBase& base)
{
    visitor.choice({ kBaseWords, WordOption::Offered::Never }, base);
}

StrokeFromFoot from_foot(StrokeBase base, Stroke const& stroke, std::span<SegmentId const> branch,
                         scene::Scene const& scene)
{
    if (base == StrokeBase::AsDrawn || branch.empty() || !ends_at_foot(stroke, branch, scene))
        return { stroke };
    return { turned_round(stroke), true };
}

std::string bent_branch_message(Tool const& tool, scene::Scene const& after)
{
    auto const& strokes = after.drawn->strokes;
    bool const is_reversed = !strokes.empty() && strokes[strokes.size() - 1].what.is_drawn_reversed
        && scene::edit_of_item(strokes[strokes.size() - 1].id) == after.state.last_edit;
    if (!is_reversed)
        return underground_message(tool, after);
    return "The stroke ran from the branch's tip to its foot and is turned round: \"Turn round\" "
           "turns it back";
}

} // namespace tractus::tools
