#include "engine/methods/self_organising/markers.h"

#include "engine/base/parallel.h"
#include "engine/methods/self_organising/cell_index.h"

#include <algorithm>
#include <cmath>

namespace tractus::self_organising {

namespace {

constexpr std::uint32_t kUsedUp = kNone - 1;

// Index of the bud that gets a marker. kNone: no bud perceives it; kUsedUp: a bud is too close.
std::uint32_t owner_of(Vec3 const& marker, CellIndex const& index, std::vector<Vec3> const& places,
                       std::vector<Vec3> const& directions, Laws const& laws)
{
    double const occupied = laws.occupancy_radius * laws.occupancy_radius;
    double const cosine = std::cos(radians(laws.perception_angle_deg) / 2);
    std::uint32_t owner = kNone;
    double nearest = laws.perception_radius;
    bool is_used_up = false;
    index.for_each_near(marker, [&](std::uint32_t bud) {
        Vec3 const way = marker - places[bud];
        double const squared = dot(way, way);
        is_used_up |= squared < occupied;
        double const distance = std::sqrt(squared);
        bool const is_nearer = distance < nearest
            || (distance == nearest && distance < laws.perception_radius && bud < owner);
        if (is_nearer && dot(way, directions[bud]) >= distance * cosine) {
            owner = bud;
            nearest = distance;
        }
    });
    return is_used_up ? kUsedUp : owner;
}

} // namespace

BudPerception compete_for_space(std::vector<Vec3>& markers, GrowingTree const& tree,
                                std::vector<Bud> const& buds, Laws const& laws)
{
    std::vector<Vec3> places(buds.size());
    std::vector<Vec3> directions(buds.size());
    for (std::size_t i = 0; i < buds.size(); ++i) {
        places[i] = tree.places[buds[i].node].position;
        directions[i] = direction_of(tree, buds[i]);
    }
    CellIndex const index(places, std::max(laws.perception_radius, laws.occupancy_radius));
    std::vector<std::uint32_t> owners(markers.size());
    constexpr std::size_t kGrain = 256;
    parallel_for(markers.size(), kGrain, [&](std::size_t begin, std::size_t end) {
        for (auto i = begin; i < end; ++i)
            owners[i] = owner_of(markers[i], index, places, directions, laws);
    });

    BudPerception perceived { std::vector<double>(buds.size()),
                              std::vector<Vec3>(buds.size(), Vec3::Zero()) };
    std::size_t kept = 0;
    for (std::size_t i = 0; i < markers.size(); ++i) {
        if (owners[i] == kUsedUp)
            continue;
        if (auto const bud = owners[i]; bud != kNone) {
            perceived.quality[bud] = 1;
            perceived.direction[bud] += unit_or_zero(markers[i] - places[bud]);
        }
        markers[kept++] = markers[i];
    }
    markers.resize(kept);
    for (auto& direction : perceived.direction)
        direction = unit_or_zero(direction);
    return perceived;
}

} // namespace tractus::self_organising
