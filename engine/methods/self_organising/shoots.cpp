#include "engine/methods/self_organising/shoots.h"

#include "engine/base/parallel.h"
#include "engine/base/random.h"

#include <algorithm>
#include <cmath>

namespace tractus::self_organising {

namespace {

constexpr std::uint32_t kTerminalStream = 0x50B0;
constexpr std::uint32_t kSpreadStream = 0x5B8E;
constexpr std::uint64_t kTrunk = 0x7472756E6B; // Axis name of the trunk.

// Derives the name of the axis that grows from a lateral position (finaliser of SplitMix64).
std::uint64_t name_of_lateral(std::uint64_t parent, std::uint32_t rank, std::uint32_t lateral)
{
    auto mixed = parent + 0x9E3779B97F4A7C15U * (std::uint64_t { rank } * 16 + lateral + 1);
    mixed = (mixed ^ mixed >> 30) * 0xBF58476D1CE4E5B9U;
    mixed = (mixed ^ mixed >> 27) * 0x94D049BB133111EBU;
    return mixed ^ mixed >> 31;
}

class ShootGrower {
public:
    ShootGrower(GrowingTree& tree, Laws const& laws, std::uint64_t seed)
        : tree_(tree)
        , laws_(laws)
        , seed_(seed)
        , tropism_(unit_or_zero(laws.tropism_direction))
    {
    }

    // Grows one shoot. `node` and `lateral` are the indices of the first node and the first lateral
    // reserved for the shoot.
    void grow(Shoot const& shoot, std::uint32_t node, std::uint32_t lateral)
    {
        auto const& bud = shoot.bud;
        auto direction = direction_of(tree_, bud);
        auto below = bud.node;
        for (int j = 0; j < shoot.internodes; ++j) {
            bool const begins_axis = j == 0 && bud.lateral != kNone;
            auto links = begins_axis ? first_links(bud) : next_links(below);
            double const tropism = laws_.tropism_weight.at(links.order);
            direction
                = unit_or_zero(direction + shoot.pull * laws_.space_weight + tropism_ * tropism);
            Vec3 normal = begins_axis ? right_of(direction) : tree_.places[below].normal;
            // Parallel transport carries the normal along the axis without twist.
            normal = unit_or_zero(normal - direction * dot(normal, direction));
            if (normal.isZero(0))
                normal = right_of(direction);
            links.first_lateral = lateral;
            links.lateral_count = lateral_count(shoot, j, links.order);
            tree_.links[node] = links;
            tree_.places[node]
                = { tree_.places[below].position + direction * shoot.length, direction, normal };
            set_lateral_buds(tree_, node, laws_, seed_);
            lateral += links.lateral_count;
            attach(bud, begins_axis, below, node);
            below = node++;
        }
        tree_.links[below].has_terminal = keeps_terminal(tree_.links[below]);
    }

    std::uint8_t lateral_count(Shoot const& shoot, int internode, std::size_t order) const
    {
        bool const is_last = internode + 1 == shoot.internodes;
        return static_cast<std::uint8_t>(
            is_last && order == 0 && laws_.whorl > 0 ? laws_.whorl : laws_.laterals_at_node);
    }

    std::size_t lateral_count(Shoot const& shoot) const
    {
        auto const order = order_of(shoot.bud);
        std::size_t count = 0;
        for (int j = 0; j < shoot.internodes; ++j)
            count += lateral_count(shoot, j, order);
        return count;
    }

private:
    std::size_t order_of(Bud const& bud) const
    {
        return tree_.links[bud.node].order + std::size_t { bud.lateral != kNone };
    }

    NodeLinks first_links(Bud const& bud) const
    {
        auto const& parent = tree_.links[bud.node];
        return { .parent = bud.node,
                 .order = static_cast<std::uint16_t>(order_of(bud)),
                 .step = tree_.step,
                 .rank = 1,
                 .axis
                 = name_of_lateral(parent.axis, parent.rank, bud.lateral - parent.first_lateral) };
    }

    NodeLinks next_links(std::uint32_t below) const
    {
        auto const& parent = tree_.links[below];
        return { .parent = below,
                 .order = parent.order,
                 .step = tree_.step,
                 .rank = parent.rank + 1,
                 .axis = parent.rank == 0 ? kTrunk : parent.axis };
    }

    void attach(Bud const& bud, bool begins_axis, std::uint32_t below, std::uint32_t node)
    {
        if (!begins_axis) {
            tree_.links[below].main = node;
            return;
        }
        tree_.laterals[bud.lateral].node = node;
        tree_.laterals[bud.lateral].has_bud = false;
    }

    bool keeps_terminal(NodeLinks const& node) const
    {
        if (laws_.terminal_loss == 0 || node.order == 0)
            return true;
        Random random({ seed_ ^ node.axis, kTerminalStream, node.rank });
        return random.uniform() >= laws_.terminal_loss;
    }

    GrowingTree& tree_;
    Laws const& laws_;
    std::uint64_t seed_;
    Vec3 tropism_;
};

} // namespace

// Spaces the lateral buds of a node evenly around the node, with random variation.
void set_lateral_buds(GrowingTree& tree, std::uint32_t number, Laws const& laws, std::uint64_t seed)
{
    auto const& node = tree.links[number];
    auto const& place = tree.places[number];
    double const start_deg = laws.divergence_start_deg.at(node.order);
    double const turn = radians(laws.divergence_deg.at(node.order)) * node.rank;
    double const angle = radians(laws.branching_angle_deg.at(node.order));
    Random random({ seed ^ node.axis, kSpreadStream, node.rank });
    auto const stray = [&](double spread_deg) {
        return spread_deg > 0 ? radians(spread_deg * random.normal()) : 0;
    };
    for (std::uint32_t k = 0; k < node.lateral_count; ++k) {
        double const around = turn + radians(start_deg + 360.0 * k / node.lateral_count)
            + stray(laws.divergence_spread_deg);
        Vec3 const axis = turned(place.normal, place.direction, around);
        double const out = std::max(angle + stray(laws.angle_spread_deg), 0.0);
        tree.laterals[node.first_lateral + k]
            = { .direction = unit_or_zero(turned(place.direction, axis, out)) };
    }
}

Shoot shoot_of(Bud const& bud, std::size_t order, double vigour, Laws const& laws)
{
    // Tolerance for rounding: a vigour that sums to almost 3 counts as 3.
    constexpr double kRounding = 1e-9;
    double const whole
        = std::min(std::floor(vigour + kRounding), double(laws.most_internodes.at(order)));
    if (!(whole >= 1))
        return { .bud = bud, .internodes = 0 };
    return { .bud = bud,
             .internodes = static_cast<int>(whole),
             .length = std::min(vigour / whole, laws.longest) * laws.internode };
}

void grow_shoots(GrowingTree& tree, std::vector<Shoot> const& shoots, Laws const& laws,
                 std::uint64_t seed)
{
    struct First {
        std::uint32_t node;
        std::uint32_t lateral;
    };
    ShootGrower grower(tree, laws, seed);
    std::vector<First> firsts;
    firsts.reserve(shoots.size());
    std::size_t nodes = tree.size();
    std::size_t laterals = tree.laterals.size();
    for (auto const& shoot : shoots) {
        firsts.push_back(
            { static_cast<std::uint32_t>(nodes), static_cast<std::uint32_t>(laterals) });
        nodes += static_cast<std::size_t>(shoot.internodes);
        laterals += grower.lateral_count(shoot);
    }
    tree.places.resize(nodes);
    tree.links.resize(nodes);
    tree.dead_wood.resize(nodes);
    tree.bent_by.resize(nodes, Vec3::Zero());
    tree.laterals.resize(laterals);
    constexpr std::size_t kGrain = 64;
    parallel_for(shoots.size(), kGrain, [&](std::size_t begin, std::size_t end) {
        for (auto i = begin; i < end; ++i)
            grower.grow(shoots[i], firsts[i].node, firsts[i].lateral);
    });
}

} // namespace tractus::self_organising
