#include "engine/methods/self_organising/vigour.h"

#include <utility>

namespace tractus::self_organising {

namespace {

class Sharing {
public:
    Sharing(GrowingTree const& tree, std::vector<Bud> const& buds,
            std::vector<double> const& quality, Laws const& laws)
        : tree_(tree)
        , laws_(laws)
        , terminal_(tree.size())
        , lateral_(tree.laterals.size())
        , given_(tree.size())
    {
        for (std::size_t i = 0; i < buds.size(); ++i)
            slot_of(buds[i]) = quality[i];
        shares_.received.resize(tree.size());
    }

    Shares run(std::vector<Bud> const& buds)
    {
        for (std::size_t i = tree_.size(); i-- > 0;)
            sum(i);
        if (tree_.size() > 0)
            given_[0] = laws_.vigour * shares_.received[0];
        for (std::size_t i = 0; i < tree_.size(); ++i)
            pass_on(i);
        shares_.vigour.resize(buds.size());
        for (std::size_t i = 0; i < buds.size(); ++i)
            shares_.vigour[i] = slot_of(buds[i]);
        return std::move(shares_);
    }

private:
    double& slot_of(Bud const& bud)
    {
        return bud.lateral == kNone ? terminal_[bud.node] : lateral_[bud.lateral];
    }

    void sum(std::size_t i)
    {
        auto const& node = tree_.links[i];
        if (node.main != kNone)
            terminal_[i] = shares_.received[node.main];
        double of_laterals = 0;
        for (auto k = node.first_lateral; k < node.first_lateral + node.lateral_count; ++k) {
            if (auto const first = tree_.laterals[k].node; first != kNone)
                lateral_[k] = shares_.received[first];
            of_laterals += lateral_[k];
        }
        shares_.received[i] = terminal_[i] + of_laterals;
    }

    // Replaces the light or space that each bud or branch of a node received by the vigour that it
    // gets.
    void pass_on(std::size_t i)
    {
        auto const& node = tree_.links[i];
        double const lambda = laws_.apical_control;
        double const of_main = terminal_[i];
        // The laterals' sum is computed anew, because subtracting of_main from the total would lose
        // digits.
        double of_laterals = 0;
        for (auto k = node.first_lateral; k < node.first_lateral + node.lateral_count; ++k)
            of_laterals += lateral_[k];
        double const weight = lambda * of_main + (1 - lambda) * of_laterals;
        auto const share = [&](double part, double received) {
            return weight > 0 ? given_[i] * part * received / weight : 0;
        };
        terminal_[i] = share(lambda, of_main);
        if (node.main != kNone)
            given_[node.main] = terminal_[i];
        for (auto k = node.first_lateral; k < node.first_lateral + node.lateral_count; ++k) {
            lateral_[k] = share(1 - lambda, lateral_[k]);
            if (auto const first = tree_.laterals[k].node; first != kNone)
                given_[first] = lateral_[k];
        }
    }

    GrowingTree const& tree_;
    Laws const& laws_;
    // Light or space received by each node's main axis and by each lateral; later replaced by the
    // vigour of that axis or lateral.
    std::vector<double> terminal_;
    std::vector<double> lateral_;
    std::vector<double> given_; // Vigour that arrives at each node.
    Shares shares_;
};

} // namespace

Shares share_vigour(GrowingTree const& tree, std::vector<Bud> const& buds,
                    std::vector<double> const& quality, Laws const& laws)
{
    return Sharing(tree, buds, quality, laws).run(buds);
}

} // namespace tractus::self_organising
