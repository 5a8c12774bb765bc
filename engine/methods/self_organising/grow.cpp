#include "engine/methods/self_organising/grow.h"

#include "engine/base/parallel.h"
#include "engine/methods/self_organising/light.h"
#include "engine/methods/self_organising/markers.h"
#include "engine/methods/self_organising/shoots.h"
#include "engine/methods/self_organising/vigour.h"
#include "engine/methods/self_organising/wood.h"

#include <algorithm>
#include <fmt/core.h>
#include <optional>
#include <utility>

namespace tractus::self_organising {

namespace {

struct Environment {
    // Light or space that each bud perceives. If buds compete for light, the directions are empty
    // here and are computed later, only for the buds that grow.
    BudPerception perceived;
    std::optional<LightGrid> grid;
};

// Lets only the buds inside a region compete for markers; the other buds perceive nothing.
BudPerception compete_in_region(GrowingTree const& tree, std::vector<Bud> const& buds,
                                std::vector<Vec3>& markers, Region const& region, Laws const& laws)
{
    std::vector<Bud> near;
    std::vector<std::size_t> numbers;
    double const within = region.radius * region.radius;
    for (std::size_t i = 0; i < buds.size(); ++i)
        if ((tree.places[buds[i].node].position - region.centre).squaredNorm() <= within) {
            near.push_back(buds[i]);
            numbers.push_back(i);
        }
    double const reach = region.radius + std::max(laws.perception_radius, laws.occupancy_radius);
    auto const is_far = [&](Vec3 const& marker) {
        return (marker - region.centre).squaredNorm() > reach * reach;
    };
    auto const first = std::stable_partition(markers.begin(), markers.end(), is_far);
    std::vector<Vec3> reached(first, markers.end());
    auto const competed = compete_for_space(reached, tree, near, laws);
    markers.erase(first, markers.end());
    markers.insert(markers.end(), reached.begin(), reached.end());
    BudPerception perceived { std::vector<double>(buds.size()),
                              std::vector<Vec3>(buds.size(), Vec3::Zero()) };
    for (std::size_t i = 0; i < near.size(); ++i) {
        perceived.quality[numbers[i]] = competed.quality[i];
        perceived.direction[numbers[i]] = competed.direction[i];
    }
    return perceived;
}

Result<Environment> perceive(GrowingTree const& tree, std::vector<Bud> const& buds,
                             Surroundings& surroundings, Laws const& laws)
{
    if (laws.environment == Laws::Environment::Space && surroundings.region)
        return Environment {
            compete_in_region(tree, buds, surroundings.markers, *surroundings.region, laws), {}
        };
    if (laws.environment == Laws::Environment::Space)
        return Environment { compete_for_space(surroundings.markers, tree, buds, laws), {} };
    auto light = TRY(compete_for_light(tree, buds, surroundings.shading, laws));
    return Environment { { std::move(light.quality), {} }, std::move(light.grid) };
}

// The shoots of the buds that grow in this step.
std::vector<Shoot> shoots_of(GrowingTree const& tree, std::vector<Bud> const& buds,
                             Environment const& environment, std::vector<double> const& vigour,
                             Laws const& laws)
{
    std::vector<Shoot> shoots;
    auto const& perceived = environment.perceived;
    for (std::size_t i = 0; i < buds.size(); ++i) {
        if (perceived.quality[i] <= 0)
            continue;
        auto const order
            = tree.links[buds[i].node].order + std::size_t { buds[i].lateral != kNone };
        auto shoot = shoot_of(buds[i], order, vigour[i], laws);
        if (shoot.internodes == 0)
            continue;
        if (!environment.grid)
            shoot.pull = perceived.direction[i];
        shoots.push_back(shoot);
    }
    if (!environment.grid)
        return shoots;
    constexpr std::size_t kGrain = 64;
    parallel_for(shoots.size(), kGrain, [&](std::size_t begin, std::size_t end) {
        for (auto i = begin; i < end; ++i)
            shoots[i].pull
                = brightest_direction(*environment.grid, tree.places[shoots[i].bud.node].position,
                                      direction_of(tree, shoots[i].bud), laws);
    });
    return shoots;
}

// Removes lateral buds that have been dormant for too long.
void end_old_buds(GrowingTree& tree, Laws const& laws)
{
    if (laws.bud_life == 0)
        return;
    for (auto const& node : tree.links)
        if (tree.step - node.step >= laws.bud_life)
            for (auto k = node.first_lateral; k < node.first_lateral + node.lateral_count; ++k)
                tree.laterals[k].has_bud = false;
}

} // namespace

Result<StepCount> grow_step(GrowingTree& tree, Surroundings& surroundings, Laws const& laws)
{
    auto const buds = living_buds(tree);
    auto const environment = TRY(perceive(tree, buds, surroundings, laws));
    auto const& quality = environment.perceived.quality;
    auto const shares = share_vigour(tree, buds, quality, laws);
    auto const shoots = shoots_of(tree, buds, environment, shares.vigour, laws);
    StepCount count { .buds = buds.size() };
    count.lit = static_cast<std::size_t>(
        std::count_if(quality.begin(), quality.end(), [](double q) { return q > 0; }));
    for (auto const& shoot : shoots)
        count.grown += static_cast<std::size_t>(shoot.internodes);
    if (tree.size() + count.grown > laws.most_nodes)
        return fail(Fault::User,
                    fmt::format("the tree would have more than {} internodes: grow it for fewer "
                                "years, or with less vigour",
                                laws.most_nodes));
    ++tree.step;
    grow_shoots(tree, shoots, laws, surroundings.seed);
    shed_branches(tree, shares.received, laws);
    end_old_buds(tree, laws);
    count.nodes = tree.size();
    count.markers = surroundings.markers.size();
    return count;
}

} // namespace tractus::self_organising
