#include "app/tools/branch_place.h"

#include "app/tools/bent_plant.h"
#include "engine/stroke/polyline.h"

#include <algorithm>
#include <limits>

namespace tractus::tools {

namespace {

constexpr double kFinger_mm = 10;
// Maximum distance of a touched branch along the line of sight: a hand does not hit the branch's
// height more precisely.
constexpr double kDepth_mm = 30;

// A plant whose base was drawn within this distance of the branch stays there; otherwise the plant
// is moved to the branch.
constexpr double kJoined_mm = 10;

scene::BuiltPlant const& plant_with(scene::Scene const& scene, scene::ItemId id)
{
    return **std::find_if(scene.plants.begin(), scene.plants.end(),
                          [&](auto const& plant) { return plant->drawn->id == id; });
}

struct TouchedBranch {
    scene::BuiltPlant const* plant = nullptr;
    SegmentId segment = 0;
    // True if the touched place is closer to the segment's start than to its end.
    bool is_near_begin = false;
    double distance_mm = std::numeric_limits<double>::infinity();
};

TouchedBranch nearest_to(scene::Scene const& scene, Vec3 const& place_mm, Vec3 const& sight,
                         scene::ItemId except)
{
    TouchedBranch nearest;
    for (auto const& plant : scene.plants) {
        if (plant->drawn->is_hidden || plant->drawn->id == except)
            continue;
        BentPlant const bent(*plant);
        for (SegmentId segment = 0; segment < plant->base->segment_count(); ++segment) {
            Vec3 const from_mm = bent.begin_of(segment);
            Vec3 const to_mm = bent.end_of(segment);
            double const share = nearest_share(place_mm, from_mm, to_mm);
            Vec3 const off_mm = from_mm + share * (to_mm - from_mm) - place_mm;
            double const depth_mm = sight.dot(off_mm);
            bool const is_touched = (off_mm - depth_mm * sight).norm() <= kFinger_mm
                && std::abs(depth_mm) <= kDepth_mm;
            if (!is_touched || off_mm.norm() >= nearest.distance_mm)
                continue;
            nearest = { plant.get(), segment, share < 0.5, off_mm.norm() };
        }
    }
    return nearest;
}

} // namespace

Result<BranchPlace> branch_at(scene::Scene const& scene, Vec3 const& base_mm, Vec3 const& sight,
                              Grafting grafting, scene::ItemId except)
{
    auto const touched = nearest_to(scene, base_mm, sight, except);
    if (!touched.plant)
        return fail(Fault::User, "there is no branch here: touch one where the pad shows it");
    auto const& plant = *touched.plant;
    auto const& base = *plant.base;
    auto const& axis = base.axes[axis_of(base, touched.segment)];
    auto const below = parent_segment(base, touched.segment);
    BranchPlace place { .plant = plant.drawn->id, .touched = touched.segment };
    place.on = touched.is_near_begin && below != kNone ? below : touched.segment;
    if (grafting == Grafting::InPlace && axis.parent_segment != kNone) {
        place.on = axis.parent_segment;
        place.hidden = axis.first_segment;
    } else if (grafting == Grafting::InPlace
               && place.on + 1 < axis.first_segment + axis.segment_count) {
        place.hidden = place.on + 1;
    }
    Vec3 const end_mm = BentPlant(plant).end_of(place.on);
    place.diameter_mm = 2 * plant.placement.scale
        * static_cast<double>(base.node_radius_mm[nodes_of(base, place.on).tip]);
    auto const off_mm
        = grafting == Grafting::InPlace ? (base_mm - end_mm).norm() : touched.distance_mm;
    place.base_mm = off_mm <= kJoined_mm ? base_mm : end_mm;
    return place;
}

std::vector<scene::Edit> graft_edits(scene::Scene const& scene, BranchPlace const& place,
                                     scene::ItemId plant)
{
    auto const& parent = plant_with(scene, place.plant);
    auto const address = [&](SegmentId segment) {
        return parent.rest->addresses.address_of(*parent.base, segment);
    };
    std::vector<scene::Edit> edits;
    // Stores the scale in the document. Until now it was that of the first plant, which may now
    // become a part of another plant.
    if (!scene.state.scale)
        edits.push_back(scene::SetScale { parent.placement.scale });
    if (place.hidden)
        edits.push_back(scene::HideBranch { place.plant, address(*place.hidden) });
    BentPlant const bent(parent);
    Quat const back = bent.turn_of(place.on).conjugate();
    Eigen::AngleAxisd const turn(back);
    Vec3 const off_mm = place.base_mm - bent.end_of(place.on);
    edits.push_back(scene::GraftPlant { plant, place.plant, address(place.on),
                                        turn.angle() * turn.axis(),
                                        back * off_mm / parent.placement.scale });
    return edits;
}

} // namespace tractus::tools
