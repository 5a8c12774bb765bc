#include "engine/methods/silhouettes/whole_whorls.h"

#include "engine/base/vectors.h"
#include "engine/methods/silhouettes/styled_places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace tractus::silhouette {

namespace {

using Indices = std::vector<std::size_t>;

// Wraps an angle to the range -180 to 180 degrees: the shorter way around.
double shorter_deg(double angle_deg)
{
    return angle_deg - 360 * std::round(angle_deg / 360);
}

class WhorlSpreader {
public:
    WhorlSpreader(std::vector<DrawnPlace> const& drawn, ArrangementOptions const& options,
                  RandomKey const& key)
        : drawn_(drawn)
        , options_(options)
        , random_(key)
        , count_(std::max(options.count, drawn.size()))
        , whorl_(node_size(options.pattern))
        , gamma_deg_(360.0 / static_cast<double>(whorl_))
        , alpha_(options.alpha.value_or(2.0 * static_cast<double>(count_)))
        , first_u_(std::min(options.first_u, 1.0))
        , node_((1 - first_u_) * node_distance(options.pattern, count_))
    {
    }

    Arrangement run()
    {
        add_nodes();
        limit_rooms();
        move_drawn_to_nodes();
        fill_nodes();
        turn_nodes();
        for (std::size_t k = 0; k < nodes_.size(); ++k)
            stand(k, nodes_[k].turn_deg);
        Arrangement result;
        for (std::size_t k = 0; k < nodes_.size(); ++k)
            result.cost_before += cost(k, Pairs::Once);
        result.cost_after = result.cost_before;
        search(result);
        result.places = std::move(places_);
        return result;
    }

private:
    // A branch of a node and its slot: one of the node's whorl_ equally spaced azimuths.
    struct Member {
        std::size_t branch; // Index of the branch in places_.
        std::size_t slot;
    };

    struct Node {
        double u = 0;
        std::size_t room = 0; // Maximum number of branches of the node.
        std::vector<Member> members {};
        double turn_deg = 0; // Rotation of all of the node's slots relative to the pattern.
    };

    enum class Pairs { All, Once };

    bool keeps_u(std::size_t i) const { return drawn_[i].keeps_u; }

    // Indices of the drawn branches that keep their u, or of those that do not, sorted by u.
    Indices by_u(bool keep) const
    {
        Indices result;
        for (std::size_t i = 0; i < drawn_.size(); ++i)
            if (keeps_u(i) == keep)
                result.push_back(i);
        std::stable_sort(result.begin(), result.end(),
                         [&](std::size_t a, std::size_t b) { return drawn_[a].u < drawn_[b].u; });
        return result;
    }

    // Adds equally spaced nodes. Where a drawn branch keeps its u, the nearest node moves to the
    // branch.
    void add_nodes()
    {
        std::vector<Node> kept;
        for (auto const i : by_u(true)) {
            bool const is_new = kept.empty() || kept.back().members.size() == whorl_
                || drawn_[i].u > kept.back().u + node_ / 2;
            if (is_new)
                kept.push_back({ .u = drawn_[i].u });
            kept.back().members.push_back({ i, 0 });
        }
        auto const count = std::max((count_ + whorl_ - 1) / whorl_, kept.size());
        std::vector<double> equal;
        std::vector<double> at;
        for (std::size_t k = 0; k < count; ++k)
            equal.push_back(std::min(first_u_ + (static_cast<double>(k) + 0.5) * node_, 1.0));
        for (auto const& node : kept)
            at.push_back(node.u);
        for (auto const u : equal)
            nodes_.push_back({ .u = u });
        if (!kept.empty()) {
            auto const nearest = nearest_in_order(at, equal);
            for (std::size_t i = 0; i < kept.size(); ++i)
                nodes_[nearest[i]] = std::move(kept[i]);
        }
        std::stable_sort(nodes_.begin(), nodes_.end(),
                         [](Node const& a, Node const& b) { return a.u < b.u; });
    }

    // Sets the nodes' capacities so that together they hold exactly all branches; the last nodes
    // hold fewer.
    void limit_rooms()
    {
        auto left_over = nodes_.size() * whorl_ - count_;
        for (auto node = nodes_.rbegin(); node != nodes_.rend(); ++node) {
            auto const less = std::min(left_over, whorl_ - node->members.size());
            node->room = whorl_ - less;
            left_over -= less;
        }
    }

    // Azimuth of a slot before its node is rotated. The pattern can begin in any phase; shift_
    // advances it by that many nodes.
    double slot_deg(std::size_t k, std::size_t slot) const
    {
        return static_cast<double>(k + shift_) * node_turn_deg(options_.pattern)
            + static_cast<double>(slot) * gamma_deg_;
    }

    double off_deg(std::size_t k, std::size_t slot, std::size_t branch) const
    {
        return std::fabs(shorter_deg(slot_deg(k, slot) - drawn_[branch].theta_deg));
    }

    bool is_taken(Node const& node, std::size_t slot) const
    {
        return std::any_of(node.members.begin(), node.members.end(),
                           [&](Member const& member) { return member.slot == slot; });
    }

    // The free slot of node `k` that is nearest to the side on which a branch was drawn.
    std::size_t nearest_slot(std::size_t k, std::size_t branch) const
    {
        std::size_t best = 0;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t slot = 0; slot < whorl_; ++slot)
            if (!is_taken(nodes_[k], slot) && off_deg(k, slot, branch) < least) {
                least = off_deg(k, slot, branch);
                best = slot;
            }
        return best;
    }

    // Moves drawn branches to nodes, in that of the pattern's two possible phases that suits the
    // branches better.
    void move_drawn_to_nodes()
    {
        auto const as_it_was = nodes_;
        double const cost = move_drawn(0);
        auto const unshifted = nodes_;
        nodes_ = as_it_was;
        if (move_drawn(1) < cost)
            return;
        nodes_ = unshifted;
        shift_ = 0;
    }

    // Moves drawn branches to nodes in one phase of the pattern. Returns the cost: squared
    // displacement of branches along the parent, in nodes, plus cost_of_slot().
    double move_drawn(std::size_t shift)
    {
        shift_ = shift;
        for (std::size_t k = 0; k < nodes_.size(); ++k) {
            auto const kept = std::exchange(nodes_[k].members, {});
            for (auto const& member : kept)
                nodes_[k].members.push_back({ member.branch, nearest_slot(k, member.branch) });
        }
        double sum = 0;
        for (double const side_deg : { 0.0, 180.0 })
            sum += move_side(side_deg);
        return sum;
    }

    double move_side(double side_deg)
    {
        auto branches = by_u(false);
        std::erase_if(branches, [&](std::size_t i) { return drawn_[i].theta_deg != side_deg; });
        if (branches.empty())
            return 0;
        // A free slot of a node, and the cost of moving a branch to it. A node's slots are sorted
        // by cost.
        struct Free {
            std::size_t node;
            double cost;
        };
        std::vector<Free> free;
        for (std::size_t k = 0; k < nodes_.size(); ++k) {
            std::vector<double> costs;
            for (std::size_t slot = 0; slot < whorl_; ++slot)
                if (!is_taken(nodes_[k], slot))
                    costs.push_back(cost_of_slot(off_deg(k, slot, branches.front())));
            std::sort(costs.begin(), costs.end());
            costs.resize(nodes_[k].room - nodes_[k].members.size());
            for (auto const cost : costs)
                free.push_back({ k, cost });
        }
        std::vector<double> at;
        std::vector<double> others;
        std::vector<double> costs;
        for (auto const i : branches)
            at.push_back(drawn_[i].u / node_);
        for (auto const& one : free) {
            others.push_back(nodes_[one.node].u / node_);
            costs.push_back(one.cost);
        }
        auto const nearest = nearest_in_order(at, others, costs);
        double sum = 0;
        for (std::size_t i = 0; i < branches.size(); ++i) {
            auto const k = free[nearest[i]].node;
            nodes_[k].members.push_back({ branches[i], nearest_slot(k, branches[i]) });
            sum += std::pow(at[i] - others[nearest[i]], 2) + costs[nearest[i]];
        }
        return sum;
    }

    // Cost of rotating a branch by an angle, as the square of the equivalent displacement in nodes.
    // Rotations by up to kFree_deg are free.
    static double cost_of_slot(double off_deg)
    {
        constexpr double kFree_deg = 20;
        constexpr double kAsNode_deg = 40;
        return std::pow(std::max(0.0, off_deg - kFree_deg) / kAsNode_deg, 2);
    }

    // The free slot farthest from the occupied ones, so that few branches spread all around.
    std::size_t widest_slot(Node const& node) const
    {
        std::size_t best = 0;
        std::size_t widest = 0;
        for (std::size_t slot = 0; slot < whorl_; ++slot) {
            std::size_t free = whorl_;
            for (auto const& member : node.members) {
                auto const away = slot > member.slot ? slot - member.slot : member.slot - slot;
                free = std::min({ free, away, whorl_ - away });
            }
            if (free > widest) {
                widest = free;
                best = slot;
            }
        }
        return best;
    }

    // Adds branches in the remaining slots of all nodes.
    void fill_nodes()
    {
        auto next = drawn_.size();
        for (auto& node : nodes_)
            while (node.members.size() < node.room)
                node.members.push_back({ next++, widest_slot(node) });
        places_.resize(count_);
    }

    bool is_flat() const { return options_.pattern == Pattern::Horizontal; }

    double random_turn_deg()
    {
        return is_flat() ? 0 : random_.uniform(-gamma_deg_ / 2, gamma_deg_ / 2);
    }

    void turn_nodes()
    {
        for (auto& node : nodes_)
            node.turn_deg = random_turn_deg();
    }

    // Places a node's branches with the node rotated by `turn_deg`; drawn branches rotate as far as
    // their limit allows.
    void stand(std::size_t k, double turn_deg)
    {
        auto& node = nodes_[k];
        node.turn_deg = turn_deg;
        for (auto const& [branch, slot] : node.members) {
            double theta_deg = slot_deg(k, slot) + turn_deg;
            if (branch < drawn_.size()) {
                auto const& drawn = drawn_[branch];
                double const most = is_flat() ? 0 : drawn.most_off_deg;
                theta_deg = drawn.theta_deg
                    + std::clamp(shorter_deg(theta_deg - drawn.theta_deg), -most, most);
            }
            bool const keeps = branch < drawn_.size() && keeps_u(branch);
            places_[branch] = { keeps ? drawn_[branch].u : node.u, full_turn(theta_deg) };
        }
    }

    double pair_cost(std::size_t k, std::size_t a, std::size_t l, std::size_t b) const
    {
        // The pattern works on node numbers, regardless of the actual u.
        Place const first { static_cast<double>(k), places_[a].theta_deg };
        Place const second { static_cast<double>(l), places_[b].theta_deg };
        return kClosenessWeight * closeness(alpha_, places_[a], places_[b])
            + kMisfitWeight * misfit(options_.pattern, 1, first, second);
    }

    double cost(std::size_t k, Pairs pairs) const
    {
        double sum = 0;
        auto const& members = nodes_[k].members;
        for (std::size_t m = 0; m < members.size(); ++m) {
            for (std::size_t other = 0; other < m; ++other)
                sum += pair_cost(k, members[m].branch, k, members[other].branch);
            auto const last = pairs == Pairs::Once ? k : nodes_.size();
            for (std::size_t l = 0; l < last; ++l)
                for (auto const& other : nodes_[l].members)
                    if (l != k)
                        sum += pair_cost(k, members[m].branch, l, other.branch);
        }
        return sum;
    }

    // Rotates whole nodes by random search. Each proposal moves all branches of a node, so there
    // are fewer proposals than in arrange().
    void search(Arrangement& result)
    {
        auto const proposals = options_.proposals / static_cast<int>(whorl_);
        for (int p = 0; p < proposals && nodes_.size() > 1 && !is_flat(); ++p) {
            auto const k = static_cast<std::size_t>(random_.next_u64() % nodes_.size());
            double const before_deg = nodes_[k].turn_deg;
            double const before = cost(k, Pairs::All);
            stand(k, random_turn_deg());
            double const change = cost(k, Pairs::All) - before;
            if (change >= 0) {
                stand(k, before_deg);
                continue;
            }
            result.cost_after += change;
            ++result.accepted;
        }
    }

    std::vector<DrawnPlace> const& drawn_;
    ArrangementOptions const& options_;
    Random random_;
    std::size_t count_;
    std::size_t whorl_;
    double gamma_deg_; // Angle between adjacent slots of a node.
    double alpha_;
    double first_u_;
    double node_;
    std::size_t shift_ = 0;
    std::vector<Node> nodes_; // Nodes sorted by u.
    std::vector<Place> places_;
};

} // namespace

Arrangement arrange_whorls(std::vector<DrawnPlace> const& drawn, ArrangementOptions const& options,
                           RandomKey const& key)
{
    return WhorlSpreader(drawn, options, key).run();
}

} // namespace tractus::silhouette
