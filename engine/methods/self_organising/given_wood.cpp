#include "engine/methods/self_organising/given_wood.h"

#include "engine/base/check.h"
#include "engine/methods/self_organising/life.h"
#include "engine/methods/self_organising/shoots.h"
#include "engine/methods/self_organising/wood.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace tractus::self_organising {

namespace {

// Minimum distance between nodes that bear buds, in internode lengths.
constexpr double kBudDistance = 0.7;

// Makes a name for an axis without a key, from the name of its parent axis and the axis's own index
// in the plant.
std::uint64_t name_of_given(std::uint64_t parent, std::uint64_t number)
{
    auto mixed = parent * 0x9E3779B97F4A7C15U + number + 0x6769766E;
    mixed = (mixed ^ mixed >> 30) * 0xBF58476D1CE4E5B9U;
    mixed = (mixed ^ mixed >> 27) * 0x94D049BB133111EBU;
    return (mixed ^ mixed >> 31) | 1;
}

class WoodReader {
public:
    WoodReader(GivenWood const& wood, Habit const& habit, std::uint64_t seed)
        : wood_(wood)
        , plant_(wood.plant)
        , habit_(habit)
        , seed_(seed)
        , internode_mm_(wood.internode_mm > 0 ? wood.internode_mm : habit.internode_mm)
        , tree_(plant_seed(Vec3::Zero()))
        , width_mm_ { 0 }
        , has_buds_ { false }
        , children_ { {} }
    {
    }

    GrowingTree run()
    {
        node_at_end_.resize(plant_.segment_count());
        for (auto const& axis : plant_.axes)
            add_axis(axis);
        set_ages();
        add_laterals();
        if (wood_.keeps_width)
            keep_widths();
        set_wood(tree_, diameters(tree_, growth_laws_in_year(habit_, tree_.step)),
                 sag_laws(habit_));
        return std::move(tree_);
    }

private:
    bool is_trunk(Axis const& axis) const
    {
        constexpr double kAtOrigin_mm = 1e-6;
        return axis.parent_segment == kNone && tree_.links[0].main == kNone
            && plant_.node_position_mm[axis.first_node].norm() <= kAtOrigin_mm;
    }

    void add_axis(Axis const& axis)
    {
        auto const number = static_cast<std::size_t>(&axis - plant_.axes.data());
        bool const is_main = is_trunk(axis);
        auto below = axis.parent_segment == kNone ? 0 : node_at_end_[axis.parent_segment];
        NodeLinks links { .order = static_cast<std::uint16_t>(std::min(axis.order, 60'000U)) };
        auto const key = wood_.keys.empty() ? 0 : wood_.keys[number];
        links.axis = key != 0 ? key : name_of_given(tree_.links[below].axis, number);
        if (!is_main)
            children_[below].push_back(static_cast<std::uint32_t>(tree_.size()));
        since_bud_mm_ = 0;
        if (axis.parent_segment == kNone && !is_main)
            below = add_node(below, links, plant_.node_position_mm[axis.first_node], std::nullopt);
        for (std::uint32_t i = 0; i < axis.segment_count; ++i) {
            bool const begins_lateral = i == 0 && axis.parent_segment != kNone;
            below = add_segment(axis, i, below, links, begins_lateral);
            node_at_end_[axis.first_segment + i] = below;
        }
    }

    // Adds a segment. A segment longer than an internode is divided into equal parts of nearly one
    // internode length. Returns the node at the segment's upper end.
    std::uint32_t add_segment(Axis const& axis, std::uint32_t i, std::uint32_t below,
                              NodeLinks& links, bool begins_lateral)
    {
        auto const node = axis.first_node + i;
        Vec3 const from = tree_.places[below].position;
        Vec3 const way = plant_.node_position_mm[node + 1] - from;
        double const parts = std::clamp(std::round(way.norm() / internode_mm_), 1.0, 1000.0);
        double const low = plant_.node_radius_mm[node];
        double const high = plant_.node_radius_mm[node + 1];
        for (double k = 0; k < parts; ++k) {
            auto const width = 2 * (low + (high - low) * k / parts);
            auto const above = add_node(below, links, from + way * ((k + 1) / parts), width);
            if (!begins_lateral || k > 0)
                tree_.links[below].main = above;
            below = above;
        }
        return below;
    }

    // Adds a node above `below` and returns it. `width_mm` is the diameter of the internode between
    // the two; no value: the node is the foot of an additional stem.
    std::uint32_t add_node(std::uint32_t below, NodeLinks& links, Vec3 const& at,
                           std::optional<double> width_mm)
    {
        auto const number = static_cast<std::uint32_t>(tree_.size());
        auto const& last = tree_.places[below];
        double const length = (at - last.position).norm();
        Vec3 direction = unit_or_zero(at - last.position);
        bool const is_foot = !width_mm;
        if (direction.isZero(0) || is_foot)
            direction = is_foot ? Vec3(Vec3::UnitZ()) : last.direction;
        Vec3 normal = links.rank == 0 ? right_of(direction) : last.normal;
        normal = unit_or_zero(normal - direction * dot(normal, direction));
        links.parent = below;
        ++links.rank;
        tree_.places.push_back({ at, direction, normal.isZero(0) ? right_of(direction) : normal });
        tree_.links.push_back(links);
        tree_.dead_wood.push_back(0);
        tree_.bent_by.push_back(Vec3::Zero());
        width_mm_.push_back(width_mm.value_or(0));
        children_.emplace_back();
        since_bud_mm_ += length;
        has_buds_.push_back(!is_foot && since_bud_mm_ >= kBudDistance * internode_mm_);
        if (has_buds_.back())
            since_bud_mm_ = 0;
        return number;
    }

    // Estimates the age of each node: the years that a trunk needs to grow as long as the longest
    // path above the node.
    void set_ages()
    {
        // Average length of annual shoots, as a share of the longest shoot that the habit allows.
        constexpr double kUsualShoot = 0.6;
        constexpr double kOldest = 150;
        double const a_year = std::max(1.0, kUsualShoot * habit_.most_internodes) * internode_mm_;
        std::vector<double> above_mm(tree_.size());
        for (std::size_t i = tree_.size(); i-- > 1;) {
            auto const below = tree_.links[i].parent;
            double const own_mm = (tree_.places[i].position - tree_.places[below].position).norm();
            above_mm[below] = std::max(above_mm[below], above_mm[i] + own_mm);
        }
        auto const years = [&](std::size_t i) { return std::min(above_mm[i] / a_year, kOldest); };
        tree_.step = static_cast<std::uint16_t>(1 + std::floor(years(0)));
        tree_.given_step = tree_.step;
        for (std::size_t i = 1; i < tree_.size(); ++i)
            tree_.links[i].step = static_cast<std::uint16_t>(tree_.step - std::floor(years(i)));
    }

    void add_laterals()
    {
        auto const laws = growth_laws_in_year(habit_, tree_.step);
        for (std::uint32_t i = 0; i < tree_.size(); ++i) {
            auto& node = tree_.links[i];
            bool const is_young = laws.bud_life == 0 || tree_.step - node.step < laws.bud_life;
            bool const has_buds = has_buds_[i] && (wood_.buds == GivenWood::Buds::All || is_young);
            auto const buds = has_buds ? static_cast<std::size_t>(laws.laterals_at_node) : 0;
            constexpr std::size_t kMax = 255;
            auto const count = std::min(children_[i].size() + buds, kMax);
            node.first_lateral = static_cast<std::uint32_t>(tree_.laterals.size());
            node.lateral_count = static_cast<std::uint8_t>(count);
            tree_.laterals.resize(tree_.laterals.size() + count);
            set_lateral_buds(tree_, i, laws, seed_);
            for (std::size_t k = 0; k < std::min(children_[i].size(), kMax); ++k) {
                auto& lateral = tree_.laterals[node.first_lateral + k];
                lateral.node = children_[i][k];
                lateral.direction = tree_.places[lateral.node].direction;
                lateral.has_bud = false;
            }
        }
        tree_.links[0].has_terminal = tree_.links[0].main == kNone && tree_.size() == 1;
    }

    // Wood thicker than the pipe model predicts is taken to have lost branches: the difference
    // becomes dead wood.
    void keep_widths()
    {
        auto const laws = growth_laws_in_year(habit_, tree_.step);
        double const e = laws.pipe_exponent;
        std::vector<double> sums(tree_.size());
        for (std::size_t i = tree_.size(); i-- > 0;) {
            for_each_child(tree_, i, [&](std::uint32_t child) { sums[i] += sums[child]; });
            double const own = std::pow(width_mm_[i], e);
            tree_.dead_wood[i] = std::max(own - sums[i], 0.0);
            sums[i] = std::max({ sums[i], own, std::pow(laws.twig_diameter, e) });
        }
    }

    GivenWood const& wood_;
    Plant const& plant_;
    Habit const& habit_;
    std::uint64_t seed_;
    double internode_mm_;
    GrowingTree tree_;
    std::vector<double> width_mm_;                     // Given diameter of each node's internode.
    std::vector<bool> has_buds_;                       // True for nodes that may bear buds.
    std::vector<std::vector<std::uint32_t>> children_; // First nodes of each node's lateral axes.
    std::vector<std::uint32_t> node_at_end_;           // Node at the upper end of each segment.
    // Distance along the current axis from its last node that may bear buds to its newest node.
    double since_bud_mm_ = 0;
};

} // namespace

GrowingTree tree_from_wood(GivenWood const& wood, Habit const& habit, std::uint64_t seed)
{
    return WoodReader(wood, habit, seed).run();
}

void bend_tree(GrowingTree& tree, TreePlant const& plant, std::span<Vec3 const> nodes_mm,
               Habit const& habit)
{
    CHECK(nodes_mm.size() == plant.tree_nodes.size());
    std::vector<Vec3> before(tree.size());
    for (std::size_t i = 0; i < tree.size(); ++i)
        before[i] = tree.places[i].position;
    Vec3 const base = before[0];
    // A lateral axis begins at a node of its parent axis, so the plant has this node twice. The
    // parent axis comes first; the node gets its position from there.
    std::vector<bool> is_known(tree.size());
    is_known[0] = true;
    for (std::size_t k = 0; k < nodes_mm.size(); ++k) {
        auto const node = plant.tree_nodes[k];
        if (!is_known[node])
            tree.places[node].position = base + nodes_mm[k];
        is_known[node] = true;
    }
    for (std::size_t i = 1; i < tree.size(); ++i) {
        auto const& node = tree.links[i];
        Vec3 const was = before[i] - before[node.parent];
        Vec3 const is = tree.places[i].position - tree.places[node.parent].position;
        if (was.isZero(0) || is.isZero(0))
            continue;
        Quat const turn = Quat::FromTwoVectors(was, is);
        auto& place = tree.places[i];
        place.direction = unit_or_zero(turn * place.direction);
        place.normal = turn * place.normal;
        place.normal
            = unit_or_zero(place.normal - place.direction * dot(place.normal, place.direction));
        for (auto k = node.first_lateral; k < node.first_lateral + node.lateral_count; ++k)
            if (tree.laterals[k].has_bud)
                tree.laterals[k].direction = turn * tree.laterals[k].direction;
    }
    set_wood(tree, diameters(tree, growth_laws_in_year(habit, tree.step)), sag_laws(habit));
}

} // namespace tractus::self_organising
