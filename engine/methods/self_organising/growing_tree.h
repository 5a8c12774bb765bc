#pragma once

#include "engine/base/vectors.h"
#include "engine/plant/plant.h"

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace tractus::self_organising {

// Position of a node and direction of the internode below it.
struct NodePlace {
    Vec3 position = Vec3::Zero();
    Vec3 direction = Vec3::UnitZ(); // Unit vector along the internode below.
    // Unit vector across the internode: reference for the divergence angle of lateral buds.
    Vec3 normal = Vec3::UnitX();
};

// Topology of a node. Its lateral positions, each a bud or an axis, are the `lateral_count` entries
// of GrowingTree::laterals from `first_lateral` on.
struct NodeLinks {
    std::uint32_t parent = kNone; // The next node towards the base; kNone for the base itself.
    std::uint32_t main = kNone;   // The next node of the same axis; kNone for the axis's last node.
    std::uint32_t first_lateral = 0;
    std::uint8_t lateral_count = 0;
    // False once the terminal bud has died. Only meaningful if main is kNone.
    bool has_terminal = true;
    std::uint16_t order = 0; // Branching order of the node's axis: 0 for the trunk.
    std::uint16_t step = 0;  // Growth step in which the node grew; 0 for the base.
    std::uint32_t rank = 0;  // Number of the node along its axis, from 1; 0 for the base.
    std::uint64_t axis = 0;  // Name of the node's axis, which stays the same as the tree grows.
};

// A lateral position of a node. It has a bud, or the axis that grew from the bud, or nothing if
// they have died.
struct Lateral {
    Vec3 direction = Vec3::UnitZ(); // Direction of the bud, a unit vector.
    // First node of the axis that grew from the bud; kNone: no axis has grown.
    std::uint32_t node = kNone;
    bool has_bud = true; // False: the bud has grown or died.
};

// A tree while it grows, as flat arrays. Nodes are in the order in which they grew, so a parent
// comes before its children. Axes branch at nodes, which are one internode apart.
struct GrowingTree {
    std::vector<NodePlace> places;
    std::vector<NodeLinks> links;
    std::vector<Lateral> laterals;
    std::vector<double> dead_wood; // Pipe-model sum d^e of the branches shed at each node.
    // Moment in kg mm that bent each node's internode to its present shape (sag.h).
    std::vector<Vec3> bent_by;
    std::uint16_t step = 0; // Number of growth steps so far.
    // Nodes of this growth step and of earlier ones are given wood (given_wood.h); nodes of later
    // steps have grown. 0: the whole tree has grown. Given internodes do not count when branches
    // are shed for lack of light.
    std::uint16_t given_step = 0;
    // True if the tree grew along a brush in its last steps. Twigs then stay alive even without
    // space to grow.
    bool is_brushed = false;

    std::size_t size() const { return links.size(); }
    std::span<Lateral const> laterals_of(std::size_t node) const
    {
        return std::span(laterals).subspan(links[node].first_lateral, links[node].lateral_count);
    }
};

// A bud that may grow: the terminal bud of a node or one of its lateral buds.
struct Bud {
    std::uint32_t node = 0;
    std::uint32_t lateral = kNone; // Index in GrowingTree::laterals; kNone: the terminal bud.
};

// Makes a seedling: a base with a terminal bud. `direction` may have any length but 0.
GrowingTree plant_seed(Vec3 const& base, Vec3 const& direction = Vec3::UnitZ());

// Lists the living buds in the order of their nodes; at each node the terminal bud comes first.
std::vector<Bud> living_buds(GrowingTree const& tree);

Vec3 const& direction_of(GrowingTree const& tree, Bud const& bud);

// Removes the marked nodes. `is_dead` has one mark per node, and all descendants of a marked node
// must be marked, too. The other nodes keep their order.
void remove_nodes(GrowingTree& tree, std::vector<bool> const& is_dead);

// Horton-Strahler order of each node: 1 at the tips. Any other node has the highest order of its
// children, or one more if two of its children have that order.
std::vector<int> strahler_orders(GrowingTree const& tree);

// Calls use(child) for each child of a node: first the next node of its axis, then the first nodes
// of its lateral axes.
template<typename Use> void for_each_child(GrowingTree const& tree, std::size_t node, Use use)
{
    if (tree.links[node].main != kNone)
        use(tree.links[node].main);
    for (auto const& lateral : tree.laterals_of(node))
        if (lateral.node != kNone)
            use(lateral.node);
}

// Scalar product and length, summed in the order x, y, z. Ties between buds are then decided as in
// the program against which the growth laws were checked; Eigen would add y and z first.
inline double dot(Vec3 const& a, Vec3 const& b)
{
    return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
}
inline double length_of(Vec3 const& vector)
{
    return std::sqrt(dot(vector, vector));
}

// Normalises a vector; a zero vector stays zero.
Vec3 unit_or_zero(Vec3 const& vector);

// The horizontal unit vector to the right of a direction; the x axis for a vertical direction.
Vec3 right_of(Vec3 const& direction);

// Rotates `vector` about a unit axis (Rodrigues' formula).
Vec3 turned(Vec3 const& vector, Vec3 const& axis, double angle_rad);

} // namespace tractus::self_organising
