#include "engine/methods/self_organising/prune.h"

#include "engine/methods/self_organising/cell_index.h"
#include "engine/methods/self_organising/shoots.h"
#include "engine/methods/self_organising/wood.h"
#include "engine/stroke/polyline.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace tractus::self_organising {

namespace {

// Number of nodes whose buds wake below a cut, counted from the cut down the axis.
constexpr int kWakingNodes = 4;

// Finds the internodes that a ball touches along its path.
class TouchedWood {
public:
    TouchedWood(GrowingTree const& tree, std::span<BrushBall const> balls)
        : tree_(tree)
        , path_(dense_path(balls))
    {
        for (auto const& ball : path_) {
            centres_.push_back(ball.centre);
            reach_ = std::max(reach_, ball.radius);
        }
        double longest = 0;
        for (std::size_t i = 1; i < tree.size(); ++i)
            longest = std::max(longest, length_of(internode(i)));
        reach_ += longest / 2;
    }

    std::vector<bool> find() const
    {
        CellIndex const index(centres_, reach_);
        std::vector<bool> is_touched(tree_.size());
        for (std::size_t i = 1; i < tree_.size(); ++i) {
            if (is_lowest(i))
                continue;
            Vec3 const& tip = tree_.places[i].position;
            bool is_near = false;
            index.for_each_near(tip - internode(i) / 2, [&](std::uint32_t k) {
                is_near |= is_touching(path_[k], tip - internode(i), tip);
            });
            is_touched[i] = is_near;
        }
        return is_touched;
    }

private:
    // True for the lowest internode of the trunk and of a separate stem, whose foot is a lateral of
    // the base (given_wood.h).
    bool is_lowest(std::size_t node) const
    {
        auto const below = tree_.links[node].parent;
        return below == 0 || (tree_.links[below].parent == 0 && tree_.links[0].main != below);
    }

    Vec3 internode(std::size_t node) const
    {
        return tree_.places[node].position - tree_.places[tree_.links[node].parent].position;
    }

    static bool is_touching(BrushBall const& ball, Vec3 const& base, Vec3 const& tip)
    {
        double const share = nearest_share<Vec3>(ball.centre, base, tip);
        Vec3 const nearest = base + share * (tip - base);
        return (nearest - ball.centre).squaredNorm() <= ball.radius * ball.radius;
    }

    GrowingTree const& tree_;
    std::vector<BrushBall> path_;
    std::vector<Vec3> centres_;
    // Greatest distance from a ball's centre to the middle of an internode that it touches.
    double reach_ = 0;
};

// Detaches the touched nodes from those below them and marks all of their descendants as dead.
// Returns the nodes below the cuts.
std::vector<std::uint32_t> cut(GrowingTree& tree, std::vector<bool>& is_dead, Laws const& laws)
{
    auto const sums = pipe_sums(tree, laws);
    std::vector<std::uint32_t> stumps;
    for (std::uint32_t i = 1; i < tree.size(); ++i) {
        auto const below = tree.links[i].parent;
        if (is_dead[below])
            is_dead[i] = true;
        else if (is_dead[i]) {
            auto& node = tree.links[below];
            if (node.main == i) {
                node.main = kNone;
                node.has_terminal = false;
            }
            for (auto k = node.first_lateral; k < node.first_lateral + node.lateral_count; ++k)
                if (tree.laterals[k].node == i)
                    tree.laterals[k].node = kNone;
            tree.dead_wood[below] += sums[i];
            stumps.push_back(below);
        }
    }
    return stumps;
}

// Marks the nodes whose buds wake: those below the cuts, and the next ones down the same axes.
std::vector<bool> waking_nodes(GrowingTree const& tree, std::vector<std::uint32_t> const& stumps)
{
    std::vector<bool> is_waking(tree.size());
    for (auto node : stumps)
        for (int k = 0; k < kWakingNodes && node != 0; ++k) {
            is_waking[node] = true;
            auto const below = tree.links[node].parent;
            if (tree.links[below].axis != tree.links[node].axis)
                break;
            node = below;
        }
    return is_waking;
}

// Gives the marked nodes a bud at each lateral position without bud or branch. Marked nodes without
// lateral positions get Laws::laterals_at_node of them.
void wake(GrowingTree& tree, std::vector<bool> const& is_waking, Laws const& laws,
          std::uint64_t seed)
{
    auto const before = std::move(tree.laterals);
    tree.laterals.clear();
    for (std::uint32_t i = 0; i < tree.size(); ++i) {
        auto& node = tree.links[i];
        auto const old = std::span(before).subspan(node.first_lateral, node.lateral_count);
        node.first_lateral = static_cast<std::uint32_t>(tree.laterals.size());
        if (is_waking[i] && old.empty())
            node.lateral_count = static_cast<std::uint8_t>(laws.laterals_at_node);
        tree.laterals.resize(tree.laterals.size() + node.lateral_count);
        if (is_waking[i])
            set_lateral_buds(tree, i, laws, seed);
        for (std::size_t k = 0; k < old.size(); ++k)
            if (!is_waking[i] || old[k].node != kNone || old[k].has_bud)
                tree.laterals[node.first_lateral + k] = old[k];
    }
}

} // namespace

Result<std::size_t> prune(GrowingTree& tree, std::span<BrushBall const> balls, Habit const& habit,
                          std::uint64_t seed)
{
    TRY(check_balls(balls));
    if (balls.empty() || tree.size() < 2)
        return 0;
    auto const laws = growth_laws_in_year(habit, tree.step);
    auto is_dead = TouchedWood(tree, balls).find();
    auto const stumps = cut(tree, is_dead, laws);
    if (stumps.empty())
        return 0;
    wake(tree, waking_nodes(tree, stumps), laws, seed);
    auto const count = static_cast<std::size_t>(std::count(is_dead.begin(), is_dead.end(), true));
    remove_nodes(tree, is_dead);
    return count;
}

} // namespace tractus::self_organising
