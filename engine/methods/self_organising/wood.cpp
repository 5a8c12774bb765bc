#include "engine/methods/self_organising/wood.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace tractus::self_organising {

std::vector<double> pipe_sums(GrowingTree const& tree, Laws const& laws)
{
    double const twig = std::pow(laws.twig_diameter, laws.pipe_exponent);
    std::vector<double> sums(tree.size());
    for (std::size_t i = tree.size(); i-- > 0;) {
        double sum = 0;
        for_each_child(tree, i, [&](std::uint32_t child) { sum += sums[child]; });
        sum += tree.dead_wood[i];
        sums[i] = sum > 0 ? sum : twig;
    }
    return sums;
}

std::vector<double> diameters(GrowingTree const& tree, Laws const& laws)
{
    auto sums = pipe_sums(tree, laws);
    double const twig = std::pow(laws.twig_diameter, laws.pipe_exponent);
    for (auto& sum : sums) // Most internodes are twigs and need no pow() call.
        sum = sum == twig ? laws.twig_diameter : std::pow(sum, 1 / laws.pipe_exponent);
    return sums;
}

namespace {

// Width of a ring on axes of order 1, as a share of that on the trunk.
constexpr double kBranchRing = 0.3;

// Length of the trunk's lowest internode as a share of the habit's, at most 1. The lowest internode
// cannot be pruned, so that this share does not change while the tree lives.
double ring_scale(GrowingTree const& tree, Habit const& habit)
{
    auto const lowest = tree.links[0].main;
    if (lowest == kNone)
        return 1;
    Vec3 const internode = tree.places[lowest].position - tree.places[0].position;
    return std::min(length_of(internode) / habit.internode_mm, 1.0);
}

// Greatest width of the rings at each node: the length of the axis above it, divided by
// Habit::ring_slenderness.
std::vector<double> widest_rings(GrowingTree const& tree, Habit const& habit)
{
    std::vector<double> widths(tree.size());
    for (std::size_t i = tree.size(); i-- > 0;)
        if (auto const above = tree.links[i].main; above != kNone) {
            Vec3 const internode = tree.places[above].position - tree.places[i].position;
            widths[i] = widths[above] + length_of(internode) / habit.ring_slenderness;
        }
    return widths;
}

} // namespace

std::vector<double> shown_diameters(GrowingTree const& tree, Habit const& habit)
{
    auto widths = diameters(tree, growth_laws_in_year(habit, tree.step));
    if (habit.ring_mm <= 0 || tree.size() == 0)
        return widths;
    double const on_trunk = 2 * habit.ring_mm * ring_scale(tree, habit);
    bool const is_bounded = habit.ring_slenderness > 0;
    auto const widest = is_bounded ? widest_rings(tree, habit) : std::vector<double>();
    for (std::size_t i = 0; i < tree.size(); ++i) {
        auto const& node = tree.links[i];
        if (node.order > 1)
            continue;
        auto const years = tree.step - std::max(node.step, tree.given_step);
        double const ring = node.order == 0 ? on_trunk : kBranchRing * on_trunk;
        double const width = habit.twig_mm + ring * years;
        widths[i] = std::max(widths[i], is_bounded ? std::min(width, widest[i]) : width);
    }
    return widths;
}

void shed_branches(GrowingTree& tree, std::vector<double> const& received, Laws const& laws)
{
    if (laws.shed_below <= 0)
        return;
    std::vector<std::uint32_t> internodes(tree.size());
    for (std::size_t i = tree.size(); i-- > 1;) {
        internodes[i] += tree.links[i].step > tree.given_step ? 1U : 0U;
        internodes[tree.links[i].parent] += internodes[i];
    }
    auto const sums = laws.keeps_dead_wood ? pipe_sums(tree, laws) : std::vector<double>();
    std::vector<bool> is_dead(tree.size());
    bool any = false;
    for (std::size_t i = 0; i < tree.size(); ++i) {
        auto const& node = tree.links[i];
        if (node.parent != kNone && is_dead[node.parent])
            is_dead[i] = true;
        if (is_dead[i])
            continue;
        for (auto k = node.first_lateral; k < node.first_lateral + node.lateral_count; ++k) {
            auto& lateral = tree.laterals[k];
            bool const is_old = lateral.node != kNone && lateral.node < received.size();
            if (!is_old || internodes[lateral.node] == 0
                || received[lateral.node] / internodes[lateral.node] >= laws.shed_below)
                continue;
            is_dead[lateral.node] = true;
            if (laws.keeps_dead_wood)
                tree.dead_wood[i] += sums[lateral.node];
            lateral.node = kNone;
            any = true;
        }
    }
    if (any)
        remove_nodes(tree, is_dead);
}

} // namespace tractus::self_organising
