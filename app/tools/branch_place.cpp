#include "app/tools/branch_place.h"

#include "app/tools/bent_plant.h"

#include <algorithm>
#include <limits>

namespace tractus {

namespace {

constexpr double kFinger_mm = 10;

// How near to the branch a stroke begins that is meant to begin on it.
constexpr double kJoined_mm = 10;

BuiltPlant const& plant_with(Scene const& scene, ItemId id)
{
    return **std::find_if(scene.plants.begin(), scene.plants.end(),
                          [&](auto const& plant) { return plant->drawn->id == id; });
}

// A segment whose end was touched.
struct TouchedEnd {
    BuiltPlant const* plant = nullptr;
    SegmentId segment = 0;
    Vec3 end_mm = Vec3::Zero();
};

TouchedEnd nearest_to(Scene const& scene, Vec3 const& place_mm, Vec3 const& sight, ItemId except)
{
    TouchedEnd nearest;
    double nearest_mm = std::numeric_limits<double>::infinity();
    for (auto const& plant : scene.plants) {
        if (plant->drawn->is_hidden || plant->drawn->id == except)
            continue;
        BentPlant const bent(*plant);
        for (SegmentId segment = 0; segment < plant->base->segment_count(); ++segment) {
            Vec3 const end_mm = bent.end_of(segment);
            Vec3 const off_mm = end_mm - place_mm;
            bool const is_touched = (off_mm - sight.dot(off_mm) * sight).norm() <= kFinger_mm;
            if (!is_touched || off_mm.norm() >= nearest_mm)
                continue;
            nearest_mm = off_mm.norm();
            nearest = { plant.get(), segment, end_mm };
        }
    }
    return nearest;
}

} // namespace

Result<BranchPlace> branch_at(Scene const& scene, Vec3 const& base_mm, Vec3 const& sight,
                              Grafting grafting, ItemId except)
{
    auto const touched = nearest_to(scene, base_mm, sight, except);
    if (!touched.plant)
        return fail(Fault::User, "there is no branch here: touch one where the pad shows it");
    auto const& plant = *touched.plant;
    BranchPlace place { .plant = plant.drawn->id, .on = touched.segment };
    if (grafting == Grafting::InPlace) {
        auto const& axis = plant.base->axes[axis_of(*plant.base, touched.segment)];
        auto const above = touched.segment + 1;
        if (axis.parent_segment != kNone) {
            place.on = axis.parent_segment;
            place.hidden = axis.first_segment;
        } else if (above < axis.first_segment + axis.segment_count) {
            place.hidden = above;
        }
    }
    Vec3 const end_mm = BentPlant(plant).end_of(place.on);
    place.base_mm = (base_mm - end_mm).norm() <= kJoined_mm ? base_mm : end_mm;
    return place;
}

std::vector<Edit> graft_edits(Scene const& scene, BranchPlace const& place, ItemId plant)
{
    auto const& bearer = plant_with(scene, place.plant);
    auto const address = [&](SegmentId segment) {
        return bearer.rest->addresses.address_of(*bearer.base, segment);
    };
    std::vector<Edit> edits;
    if (!scene.state.scale) // It is the first plant's, which may become a part of another now.
        edits.push_back(SetScale { bearer.placement.scale });
    if (place.hidden)
        edits.push_back(HideBranch { place.plant, address(*place.hidden) });
    BentPlant const bent(bearer);
    Quat const back = bent.turn_of(place.on).conjugate();
    Eigen::AngleAxisd const turn(back);
    Vec3 const off_mm = place.base_mm - bent.end_of(place.on);
    edits.push_back(GraftPlant { plant, place.plant, address(place.on), turn.angle() * turn.axis(),
                                 back * off_mm / bearer.placement.scale });
    return edits;
}

} // namespace tractus
