#include "engine/methods/self_organising/tree_film.h"

#include "engine/methods/self_organising/wood.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

namespace tractus::self_organising {

namespace {

// Identifies a node in the trees of all years: the name of the node's axis and the node's number
// along that axis.
using NodeName = std::pair<std::uint64_t, std::uint32_t>;

struct HashOfName {
    std::size_t operator()(NodeName const& name) const
    {
        return static_cast<std::size_t>(name.first ^ name.second * 0x9E3779B97F4A7C15U);
    }
};

using NodesByName = std::unordered_map<NodeName, std::uint32_t, HashOfName>;

// For each node of `tree`, its index in the same tree in an earlier year, or kNone if it had not
// grown yet.
std::vector<std::uint32_t> numbers_in(GrowingTree const& earlier, GrowingTree const& tree)
{
    NodesByName known;
    known.reserve(earlier.size());
    for (std::uint32_t i = 0; i < earlier.size(); ++i)
        known.emplace(NodeName { earlier.links[i].axis, earlier.links[i].rank }, i);
    std::vector<std::uint32_t> numbers(tree.size(), kNone);
    for (std::size_t i = 0; i < tree.size(); ++i)
        if (auto const found = known.find({ tree.links[i].axis, tree.links[i].rank });
            found != known.end())
            numbers[i] = found->second;
    // The base cannot be found by its name, which changes when the trunk begins to grow.
    numbers[0] = 0;
    return numbers;
}

Vec3 internode_of(GrowingTree const& tree, std::uint32_t node)
{
    auto const below = tree.links[node].parent;
    return below == kNone ? Vec3(Vec3::Zero())
                          : Vec3(tree.places[node].position - tree.places[below].position);
}

// A moment within a year: the tree at the beginning and at the end of the year, and the share of
// the year that has passed.
struct Moment {
    GrowingTree const& before;
    GrowingTree const& after;
    double share;
};

// The vector of an internode at a moment. `before` and `after` are the indices of its upper node in
// the trees moment.before and moment.after, or kNone. An internode that is in both trees turns
// gradually from its old to its new direction.
Vec3 internode_at(Moment const& moment, std::uint32_t before, std::uint32_t after)
{
    if (after == kNone)
        return Vec3::Zero();
    Vec3 const is = internode_of(moment.after, after);
    if (before == kNone)
        return moment.share * is;
    Vec3 const was = internode_of(moment.before, before);
    double const length = was.norm() + moment.share * (is.norm() - was.norm());
    return length * unit_or_zero(was + moment.share * (is - was));
}

} // namespace

Result<TreeFilm> TreeFilm::make(GrownTree const& tree, scene::LoadOptions const& options)
{
    std::vector<GrowingTree> trees;
    TRY(grow_tree(tree, options, [&](GrowingTree const& grown) { trees.push_back(grown); }));
    if (trees.size() < 2)
        return fail(Fault::User, "the tree has not grown for a year: let it grow first");
    return TreeFilm(tree, std::move(trees));
}

TreeFilm::TreeFilm(GrownTree const& tree, std::vector<GrowingTree> trees)
    : habit_(tree.habit)
    , seed_(tree.seed)
    , trees_(std::move(trees))
{
    auto const& last = trees_.back();
    auto habit = habit_;
    if (!last.is_brushed) // Twigs of a brushed tree keep their leaves.
        habit.leaf_years = habit.leaf_years > 0 ? last.step + 1.0 : 0;
    whole_ = plant_of(last, habit, seed_);
    for (auto const& grown : trees_) {
        number_in_.push_back(numbers_in(grown, last));
        diameters_.push_back(shown_diameters(grown, habit_));
    }
    std::vector<std::uint32_t> node_of_segment(whole_.plant.segment_count());
    for (auto const& axis : whole_.plant.axes)
        for (std::uint32_t k = 0; k < axis.segment_count; ++k)
            node_of_segment[axis.first_segment + k] = whole_.tree_nodes[axis.first_node + k + 1];
    for (auto const& organ : whole_.plant.organs)
        leaf_node_.push_back(node_of_segment[organ.segment]);
}

Plant TreeFilm::plant_at(double age) const
{
    auto const year = static_cast<std::size_t>(std::clamp(std::ceil(age), 0.0, double(years())));
    auto tree = trees_[year];
    double const share = 1 - (static_cast<double>(year) - age);
    if (year == 0 || share >= 1)
        return plant_of(tree, habit_, seed_).plant;
    Moment const moment { trees_[year - 1], trees_[year], std::max(share, 0.0) };
    auto const before = numbers_in(moment.before, moment.after);
    for (std::uint32_t i = 1; i < tree.size(); ++i)
        tree.places[i].position
            = tree.places[tree.links[i].parent].position + internode_at(moment, before[i], i);
    return plant_of(tree, habit_, seed_).plant;
}

void TreeFilm::shape_at(double age, Plant& plant) const
{
    age = std::clamp(age, 0.0, static_cast<double>(years()));
    auto const year = std::min(static_cast<std::size_t>(age), trees_.size() - 2);
    Moment const moment { trees_[year], trees_[year + 1], age - static_cast<double>(year) };
    auto const& before = number_in_[year];
    auto const& after = number_in_[year + 1];
    auto const& last = trees_.back();
    std::vector<Vec3> internodes(last.size(), Vec3::Zero());
    std::vector<Vec3> places(last.size(), Vec3::Zero());
    for (std::uint32_t i = 1; i < last.size(); ++i) {
        internodes[i] = internode_at(moment, before[i], after[i]);
        places[i] = places[last.links[i].parent] + internodes[i];
    }
    auto const diameter = [&](std::size_t tree_year, std::uint32_t node) {
        auto const number = number_in_[tree_year][node];
        return number == kNone ? 0.0 : diameters_[tree_year][number];
    };
    for (auto const& axis : whole_.plant.axes)
        for (std::uint32_t k = 0; k <= axis.segment_count; ++k) {
            auto const node = whole_.tree_nodes[axis.first_node + k];
            // A node is as wide as the internode above it; the axis's last node is as wide as the
            // internode below it.
            auto const above
                = whole_.tree_nodes[axis.first_node + std::min(k + 1, axis.segment_count)];
            auto const radius_in = [&](std::size_t tree_year) {
                double const width = number_in_[tree_year][above] != kNone
                    ? diameter(tree_year, above)
                    : k > 0 ? diameter(tree_year, node)
                            : 0;
                return width / 2
                    * flare_at(habit_, last.links[node], places[node].z(), diameter(tree_year, 0));
            };
            plant.node_position_mm[axis.first_node + k] = places[node];
            double const was = radius_in(year);
            double const is = radius_in(year + 1);
            plant.node_radius_mm[axis.first_node + k]
                = static_cast<float>(was + moment.share * (is - was));
        }
    place_leaves(age, internodes, plant);
}

// Size, 0 to 1, of the leaves on an internode of the last tree. Leaves grow with their internode,
// live for Habit::leaf_years years and shrink to 0 in the year after.
double TreeFilm::leaf_size(std::size_t node, double age) const
{
    auto const born = static_cast<std::size_t>(
        std::find_if(number_in_.begin(), number_in_.end(),
                     [&](auto const& numbers) { return numbers[node] != kNone; })
        - number_in_.begin());
    // Years since the internode began to grow.
    double const since = age - static_cast<double>(born) + 1;
    double const grown = born == 0 ? 1 : std::clamp(since, 0.0, 1.0);
    if (trees_.back().is_brushed)
        return grown;
    double const first = trees_.back().links[node].step - trees_.front().step;
    double const fallen = std::clamp(age - first + 1 - habit_.leaf_years, 0.0, 1.0);
    return std::min(grown, 1 - fallen);
}

void TreeFilm::place_leaves(double age, std::vector<Vec3> const& internodes, Plant& plant) const
{
    auto const& last = trees_.back();
    Vec3 const base = last.places[0].position;
    for (std::size_t k = 0; k < plant.organs.size(); ++k) {
        auto const node = leaf_node_[k];
        auto const& grown = whole_.plant.organs[k];
        auto& leaf = plant.organs[k];
        Vec3 const full = internode_of(last, node);
        double const back = full.isZero(0)
            ? 0
            : (last.places[node].position - base - grown.position_mm).dot(full)
                / full.squaredNorm();
        auto const nodes = nodes_of(plant, grown.segment);
        leaf.position_mm = plant.node_position_mm[nodes.tip] - back * internodes[node];
        leaf.orientation = internodes[node].isZero(0)
            ? grown.orientation
            : Quat(Quat::FromTwoVectors(full, internodes[node]) * grown.orientation);
        leaf.scale = grown.scale * static_cast<float>(leaf_size(node, age));
    }
}

} // namespace tractus::self_organising
