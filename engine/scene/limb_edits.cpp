#include "engine/scene/limb_edits.h"

#include "engine/plant/plant_addresses.h"
#include "engine/scene/edit_words.h"
#include "engine/scene/make_edit_kind.h"
#include "engine/stroke/polyline.h"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>
#include <memory>
#include <utility>

namespace tractus::scene {

namespace {

// Minimum length of a limb, and maximum distance of its points from its joint, at the plant's
// natural size.
constexpr double kShortestLimb_mm = 1e-3;
constexpr double kFarthestLimb_mm = 1e7;

// Returns the prefix of the innermost part that contains an address; empty if only the plant itself
// does.
PartPrefix innermost_part(PlantState const& plant, SegmentAddress const& address)
{
    PartPrefix innermost;
    for (auto const& graft : plant.grafts)
        if (graft.prefix.size() > innermost.size() && is_in_part(graft.prefix, address))
            innermost = graft.prefix;
    return innermost;
}

void list(Fields& fields, DrawLimb& edit)
{
    fields.field("plant", &edit.plant);
    fields.field("at", &edit.at);
    fields.field("joint", &edit.joint);
    fields.field("joint_mm", &edit.joint_mm);
    fields.field("turn_rad", &edit.turn_rad);
    fields.field("scale", &edit.scale);
    fields.field("width_mm", &edit.width_mm);
    fields.sparse_field("turned_round", &edit.is_drawn_reversed);
    fields.id(edit.id);
    fields.numbers(edit.stroke);
}

Result<void> check_limb_place(DrawLimb const& edit)
{
    bool const is_on_segment = edit.joint >= 0 && edit.joint <= 1;
    if (edit.at.empty() || !is_on_segment || !edit.joint_mm.allFinite()
        || !edit.turn_rad.allFinite())
        return fail(Fault::User,
                    "the place for the limb is not on a branch: begin the stroke on one again");
    if (!(edit.scale > 0 && std::isfinite(edit.scale)))
        return fail(Fault::User,
                    fmt::format("a limb cannot be drawn at a scale of {}: show the plant larger",
                                edit.scale));
    if (!(edit.width_mm >= 0 && std::isfinite(edit.width_mm)))
        return fail(Fault::User,
                    fmt::format("a limb cannot be {} mm thick: give 0 or more", edit.width_mm));
    return {};
}

Result<DocumentState> applied(DocumentState state, DrawLimb const& edit, SceneBuilder&)
{
    auto const number = TRY(plant_number(state, edit.plant));
    auto limb = std::make_shared<DrawnLimb>();
    limb->joint = edit.joint;
    limb->is_drawn_reversed = edit.is_drawn_reversed;
    limb->points = TRY(limb_points(edit));
    limb->id = take_id(state, edit.id);
    for (auto const& stroke : state.plants[number]->strokes)
        if (stroke.what.propagation != variation::Propagation::Selected)
            limb->older_strokes.push_back(stroke.id);
    change_plant(state, number, [&](PlantState& plant) {
        Graft part;
        part.prefix = in_part(innermost_part(plant, edit.at), part_prefix(limb->id));
        part.name = fmt::format("limb {}", name_of(limb->id));
        part.at = edit.at;
        part.limb = std::move(limb);
        plant.grafts.push_back(std::move(part));
    });
    return state;
}

std::string described(DrawLimb const& edit)
{
    return fmt::format("draws a limb on plant {}: {}", name_of(edit.plant),
                       describe_stroke(edit.stroke));
}

void list(Fields& fields, EraseLimb& edit)
{
    fields.field("plant", &edit.plant);
    fields.field("limb", &edit.limb);
}

// True if all paths lie entirely on the limb. A path that begins below the limb does not.
bool is_on_limb(PartPrefix const& limb, SharedVector<PathAddress> const& at)
{
    return !at.empty() && std::all_of(at.begin(), at.end(), [&](PathAddress const& path) {
        return is_in_part(limb, path.first) && is_in_part(limb, path.last);
    });
}

Result<DocumentState> applied(DocumentState state, EraseLimb const& edit, SceneBuilder&)
{
    auto const number = TRY(plant_number(state, edit.plant));
    auto const& grafts = state.plants[number]->grafts;
    auto const found = std::find_if(grafts.begin(), grafts.end(), [&](Graft const& graft) {
        return graft.limb && graft.limb->id == edit.limb;
    });
    if (found == grafts.end())
        return fail(Fault::User,
                    fmt::format("plant {} has no limb {} any more", name_of(edit.plant),
                                name_of(edit.limb)));
    auto const limb = found->prefix;
    change_plant(state, number, [&](PlantState& plant) {
        std::erase_if(plant.grafts,
                      [&](Graft const& graft) { return is_in_part(limb, graft.prefix); });
        std::vector<std::size_t> gone;
        for (std::size_t i = 0; i < plant.strokes.size(); ++i)
            if (is_on_limb(limb, plant.strokes[i].at))
                gone.push_back(i);
        plant.strokes.erase(gone);
        std::erase_if(plant.indicators,
                      [&](auto const& indicator) { return is_on_limb(limb, indicator.at); });
        std::erase_if(plant.hidden_branches,
                      [&](SegmentAddress const& at) { return is_in_part(limb, at); });
        auto selection = plant.selection.vector();
        std::erase_if(selection,
                      [&](PathAddress const& path) { return is_in_part(limb, path.last); });
        if (selection.size() != plant.selection.size())
            plant.selection = std::move(selection);
    });
    return state;
}

std::string described(EraseLimb const& edit)
{
    return fmt::format("takes limb {} off plant {}", name_of(edit.limb), name_of(edit.plant));
}

} // namespace

Result<std::vector<variation::LimbPoint>> limb_points(DrawLimb const& edit)
{
    TRY(check_limb_place(edit));
    Stroke const stroke { TRY(edit.stroke.tips.in_memory()) };
    TRY(stroke_points(stroke));
    double const angle = edit.turn_rad.norm();
    Quat const turn = angle > 0 ? Quat(Eigen::AngleAxisd(angle, edit.turn_rad / angle))
                                : Quat(Quat::Identity());
    std::vector<variation::LimbPoint> points;
    for (auto const& tip : stroke.tips) {
        double const pressure
            = std::isfinite(tip.pressure) ? std::clamp(tip.pressure, 0.0, 1.0) : 1;
        points.push_back({ turn * (tip.position_mm - edit.joint_mm) / edit.scale,
                           edit.width_mm * ink_width_share(pressure) / edit.scale });
    }
    double length_mm = 0;
    double farthest_mm = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        farthest_mm = std::max({ farthest_mm, points[i].place_mm.norm(), points[i].width_mm });
        if (i > 0)
            length_mm += (points[i].place_mm - points[i - 1].place_mm).norm();
    }
    if (!(length_mm >= kShortestLimb_mm && farthest_mm <= kFarthestLimb_mm))
        return fail(Fault::User,
                    fmt::format("a limb of {:.3g} mm that reaches {:.3g} mm from its branch cannot "
                                "be made: draw it from the branch to its tip",
                                length_mm, farthest_mm));
    return points;
}

ItemId limb_at(PlantState const& plant, SegmentAddress const& address)
{
    auto const part = innermost_part(plant, address);
    for (auto const& graft : plant.grafts)
        if (graft.limb && graft.prefix == part)
            return graft.limb->id;
    return 0;
}

std::vector<std::pair<Graft const*, SegmentId>> limb_segments(BuiltPlant const& plant)
{
    std::vector<std::pair<Graft const*, SegmentId>> limbs;
    for (auto const& graft : plant.drawn->grafts) {
        if (!graft.limb)
            continue;
        auto const first = in_part(graft.prefix, SegmentAddress { 0, 0 });
        if (auto const found = plant.rest->addresses.find_segment(*plant.base, first))
            limbs.emplace_back(&graft, *found);
    }
    return limbs;
}

constexpr EditKind DrawLimb::kKind
    = make_edit_kind<DrawLimb, list, applied, described>("draw_limb");

constexpr EditKind EraseLimb::kKind
    = make_edit_kind<EraseLimb, list, applied, described>("erase_limb");

} // namespace tractus::scene
