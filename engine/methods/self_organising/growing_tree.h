#pragma once

#include "engine/base/vectors.h"
#include "engine/plant/plant.h"

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace tractus::self_organising {

// Where a node is and how its internode, the one below it, runs.
struct NodePlace {
    Vec3 position = Vec3::Zero();
    Vec3 direction = Vec3::UnitZ(); // Unit vector along the internode below.
    Vec3 normal = Vec3::UnitX();    // Across it: reference for the divergence of lateral buds.
};

// How nodes hang together. `lateral_count` lateral positions, each a bud or an axis, follow each
// other from `first_lateral` on in GrowingTree::laterals.
struct NodeLinks {
    std::uint32_t parent = kNone; // The node below; kNone at the base.
    std::uint32_t main = kNone;   // The next node of the same axis.
    std::uint32_t first_lateral = 0;
    std::uint8_t lateral_count = 0;
    bool has_terminal = true; // False once the terminal bud has died. Counts where main is kNone.
    std::uint16_t order = 0;  // Of its axis: 0 for the trunk.
    std::uint16_t step = 0;   // In which it grew; 0 for the base.
    std::uint32_t rank = 0;   // Place on its axis, from 1; 0 for the base.
    std::uint64_t axis = 0;   // Name of its axis: stays the same however long the tree grows.
};

// A lateral position of a node: a bud, an axis, or nothing once either has died.
struct Lateral {
    Vec3 direction = Vec3::UnitZ(); // Of the bud.
    std::uint32_t node = kNone;     // First node of the axis that grew from it; kNone: none has.
    bool has_bud = true;            // False: the bud has grown or died.
};

// A tree while it grows: flat arrays, nodes in the order in which they grew, so that a node comes
// after the node that bears it. Axes branch at nodes, and nodes are one internode apart.
struct GrowingTree {
    std::vector<NodePlace> places;
    std::vector<NodeLinks> links;
    std::vector<Lateral> laterals;
    std::vector<double> dead_wood; // One per node: sum of d^e over the branches shed there.
    std::vector<Vec3> bent_by; // One per node: the moment, kg mm, that its bend is set by (sag.h).
    std::uint16_t step = 0;    // How many steps it has grown.
    bool is_brushed = false; // A brush led its last steps: twigs that found no more space live on.

    std::size_t size() const { return links.size(); }
    std::span<Lateral const> laterals_of(std::size_t node) const
    {
        return std::span(laterals).subspan(links[node].first_lateral, links[node].lateral_count);
    }
};

// A bud that may grow: the terminal one of a node, or one of its laterals.
struct Bud {
    std::uint32_t node = 0;
    std::uint32_t lateral = kNone; // Number in GrowingTree::laterals; kNone: the terminal bud.
};

// A seedling: the base and its terminal bud. `direction` need not be a unit vector, nor zero.
GrowingTree plant_seed(Vec3 const& base, Vec3 const& direction = Vec3::UnitZ());

// The living buds, those of older nodes first; at a node the terminal bud comes before the
// laterals.
std::vector<Bud> living_buds(GrowingTree const& tree);

Vec3 const& direction_of(GrowingTree const& tree, Bud const& bud);

// Takes away the marked nodes: one mark for each node, and with a node all that it bears is marked.
// The order of the others stays.
void remove_nodes(GrowingTree& tree, std::vector<bool> const& is_dead);

// Horton and Strahler's order of each node: 1 at the tips, one more where two of the same order
// meet.
std::vector<int> strahler_orders(GrowingTree const& tree);

// Calls use(child) for what a node bears: the next node of its axis, then the lateral axes' first.
template<typename Use> void for_each_child(GrowingTree const& tree, std::size_t node, Use use)
{
    if (tree.links[node].main != kNone)
        use(tree.links[node].main);
    for (auto const& lateral : tree.laterals_of(node))
        if (lateral.node != kNone)
            use(lateral.node);
}

// Scalar product and length with the sums in the order x, y, z, which decides ties as the reference
// does; Eigen's begin with y and z.
inline double dot(Vec3 const& a, Vec3 const& b)
{
    return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
}
inline double length_of(Vec3 const& vector)
{
    return std::sqrt(dot(vector, vector));
}

// The unit vector of `vector`; zero for zero.
Vec3 unit_or_zero(Vec3 const& vector);

// The horizontal normal to the right of a direction; x where that is vertical.
Vec3 right_of(Vec3 const& direction);

// `vector` turned about a unit axis (Rodrigues' formula).
Vec3 turned(Vec3 const& vector, Vec3 const& axis, double angle_rad);

} // namespace tractus::self_organising
