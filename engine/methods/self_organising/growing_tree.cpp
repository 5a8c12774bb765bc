#include "engine/methods/self_organising/growing_tree.h"

#include "engine/base/check.h"

#include <algorithm>

namespace tractus::self_organising {

Vec3 unit_or_zero(Vec3 const& vector)
{
    double const length = length_of(vector);
    return length > 0 ? Vec3(vector * (1 / length)) : Vec3(Vec3::Zero());
}

Vec3 right_of(Vec3 const& direction)
{
    constexpr double kVertical = 1e-9;
    Vec3 const normal(direction.y(), -direction.x(), 0); // Cross product of direction and z.
    return length_of(normal) > kVertical ? unit_or_zero(normal) : Vec3(Vec3::UnitX());
}

Vec3 turned(Vec3 const& vector, Vec3 const& axis, double angle_rad)
{
    double const c = std::cos(angle_rad);
    double const s = std::sin(angle_rad);
    return vector * c + axis.cross(vector) * s + axis * (dot(axis, vector) * (1 - c));
}

GrowingTree plant_seed(Vec3 const& base, Vec3 const& direction)
{
    GrowingTree tree;
    Vec3 const up = unit_or_zero(direction);
    tree.places.push_back({ base, up, right_of(up) });
    tree.links.push_back({});
    tree.dead_wood.push_back(0);
    tree.bent_by.push_back(Vec3::Zero());
    return tree;
}

std::vector<Bud> living_buds(GrowingTree const& tree)
{
    std::vector<Bud> buds;
    buds.reserve(tree.size() + 1);
    for (std::uint32_t i = 0; i < tree.size(); ++i) {
        auto const& node = tree.links[i];
        if (node.main == kNone && node.has_terminal)
            buds.push_back({ .node = i });
        for (std::uint32_t k = 0; k < node.lateral_count; ++k)
            if (tree.laterals[node.first_lateral + k].has_bud)
                buds.push_back({ .node = i, .lateral = node.first_lateral + k });
    }
    return buds;
}

Vec3 const& direction_of(GrowingTree const& tree, Bud const& bud)
{
    return bud.lateral == kNone ? tree.places[bud.node].direction
                                : tree.laterals[bud.lateral].direction;
}

void remove_nodes(GrowingTree& tree, std::vector<bool> const& is_dead)
{
    CHECK(is_dead.size() == tree.size());
    std::vector<std::uint32_t> new_number(tree.size(), kNone);
    std::uint32_t kept = 0;
    std::uint32_t kept_laterals = 0;
    for (std::uint32_t i = 0; i < tree.size(); ++i) {
        if (is_dead[i])
            continue;
        new_number[i] = kept;
        auto node = tree.links[i];
        for (std::uint32_t k = 0; k < node.lateral_count; ++k)
            tree.laterals[kept_laterals + k] = tree.laterals[node.first_lateral + k];
        node.first_lateral = kept_laterals;
        kept_laterals += node.lateral_count;
        tree.links[kept] = node;
        tree.places[kept] = tree.places[i];
        tree.dead_wood[kept] = tree.dead_wood[i];
        tree.bent_by[kept] = tree.bent_by[i];
        ++kept;
    }
    tree.links.resize(kept);
    tree.places.resize(kept);
    tree.dead_wood.resize(kept);
    tree.bent_by.resize(kept);
    tree.laterals.resize(kept_laterals);
    auto const renumber = [&](std::uint32_t& node) {
        if (node != kNone)
            node = new_number[node];
    };
    for (auto& node : tree.links) {
        renumber(node.parent);
        renumber(node.main);
    }
    for (auto& lateral : tree.laterals)
        renumber(lateral.node);
}

std::vector<int> strahler_orders(GrowingTree const& tree)
{
    std::vector<int> orders(tree.size());
    for (std::size_t i = tree.size(); i-- > 0;) {
        int highest = 0;
        int count = 0;
        for_each_child(tree, i, [&](std::uint32_t child) {
            int const order = orders[child];
            count = order == highest ? count + 1 : order > highest ? 1 : count;
            highest = std::max(highest, order);
        });
        orders[i] = count == 0 ? 1 : highest + (count > 1 ? 1 : 0);
    }
    return orders;
}

} // namespace tractus::self_organising
