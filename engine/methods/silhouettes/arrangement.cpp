#include "engine/methods/silhouettes/arrangement.h"

#include "engine/base/vectors.h"
#include "engine/methods/silhouettes/whole_whorls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace tractus::silhouette {

namespace {

struct Law {
    Pattern::Kind kind;
    char const* name;
    int whorl;       // Number of branches per node; 0 for Even, which has no nodes.
    double turn_deg; // Rotation from one node to the next.

    double period_deg() const { return 360.0 / whorl; }
};

// Laws of the patterns, indexed by Pattern::Kind.
constexpr std::array<Law, 6> kLaws { { { Pattern::Even, "even", 0, 0 },
                                       { Pattern::Spiral, "spiral", 1, 144 },
                                       { Pattern::Decussate, "decussate", 2, 90 },
                                       { Pattern::Whorls, "whorls", kUsualWhorl, 60 },
                                       { Pattern::TwoRows, "two-rows", 1, 180 },
                                       { Pattern::Horizontal, "horizontal", 2, 0 } } };

Law law_of(Pattern pattern)
{
    auto law = kLaws[pattern.kind];
    if (pattern == Pattern::Whorls) {
        law.whorl = pattern.whorl;
        law.turn_deg = law.period_deg() / 2; // Rotates each node into the gaps of the one below.
    }
    return law;
}

// Wraps a difference, in whole turns, to the range -0.5 to 0.5: the shorter way around.
double wrapped(double difference)
{
    return difference - std::round(difference);
}

class Spreader {
public:
    Spreader(std::vector<DrawnPlace> const& drawn, ArrangementOptions const& options,
             RandomKey const& key)
        : drawn_(drawn)
        , options_(options)
        , random_(key)
        , count_(std::max(options.count, drawn.size()))
        , alpha_(options.alpha.value_or(2.0 * static_cast<double>(count_)))
        , node_(node_distance(options.pattern, count_))
        , is_on_nodes_(options.nodes == ArrangementOptions::Nodes::Snap
                       && options.pattern == Pattern::Whorls
                       && options.pattern.whorl != kUsualWhorl)
    {
        for (std::size_t i = 0; i < count_; ++i)
            places_.push_back(proposal(i));
    }

    Arrangement run()
    {
        Arrangement result;
        for (std::size_t i = 0; i < count_; ++i)
            result.cost_before += cost(i, places_[i]) / 2;
        result.cost_after = result.cost_before;
        for (int p = 0; p < options_.proposals && count_ > 1; ++p) {
            auto const i = static_cast<std::size_t>(random_.next_u64() % count_);
            auto const other = proposal(i);
            double const change = cost(i, other) - cost(i, places_[i]);
            if (change >= 0)
                continue;
            places_[i] = other;
            result.cost_after += change;
            ++result.accepted;
        }
        if (options_.nodes != ArrangementOptions::Nodes::Free && law_of(options_.pattern).whorl > 0)
            snap();
        result.places = std::move(places_);
        return result;
    }

private:
    Place proposal(std::size_t i)
    {
        if (i >= drawn_.size()) {
            double const u = random_.uniform(options_.first_u, 1);
            return { is_on_nodes_ ? node_at(u) : u, added_theta() };
        }
        auto const& drawn = drawn_[i];
        double const most = options_.pattern == Pattern::Horizontal ? 0 : drawn.most_off_deg;
        return { drawn.u, full_turn(drawn.theta_deg + random_.uniform(-most, most)) };
    }

    // A random azimuth for an added branch; in the Horizontal pattern only 0 and 180 degrees are
    // possible.
    double added_theta()
    {
        double const theta_deg = random_.uniform(0, 360);
        return options_.pattern == Pattern::Horizontal ? (theta_deg < 180 ? 0 : 180) : theta_deg;
    }

    double cost(std::size_t i, Place const& place) const
    {
        double closeness = 0;
        double misfits = 0;
        for (std::size_t j = 0; j < count_; ++j) {
            if (j == i)
                continue;
            closeness += silhouette::closeness(alpha_, place, places_[j]);
            if (options_.pattern != Pattern::Even)
                misfits += misfit(options_.pattern, node_, place, places_[j]);
        }
        return options_.pattern == Pattern::Even
            ? closeness
            : kClosenessWeight * closeness + kMisfitWeight * misfits;
    }

    double node_at(double u) const
    {
        double const middle = (std::floor(u / node_) + 0.5) * node_;
        return std::clamp(middle, options_.first_u, 1.0);
    }

    void snap()
    {
        for (std::size_t i = drawn_.size(); i < count_; ++i)
            places_[i].u = node_at(places_[i].u);
    }

    std::vector<DrawnPlace> const& drawn_;
    ArrangementOptions const& options_;
    Random random_;
    std::size_t count_;
    double alpha_;
    double node_;
    // True for whorls of another number than the default: added branches are at nodes throughout
    // the search. Snapping them only at the end could separate the branches of one node. All other
    // patterns still snap at the end, so that plants of earlier versions do not change.
    bool is_on_nodes_;
    std::vector<Place> places_;
};

} // namespace

std::optional<Pattern> pattern_of(std::string_view word)
{
    for (auto const& law : kLaws)
        if (word == law.name)
            return law.kind;
    return std::nullopt;
}

char const* name_of(Pattern pattern)
{
    return law_of(pattern).name;
}

std::string describe(Pattern pattern)
{
    bool const is_usual = pattern != Pattern::Whorls || pattern.whorl == kUsualWhorl;
    return is_usual ? name_of(pattern) : fmt::format("{} of {}", name_of(pattern), pattern.whorl);
}

double closeness(double alpha, Place const& a, Place const& b)
{
    double const x = wrapped(a.u - b.u);
    double const y = wrapped((a.theta_deg - b.theta_deg) / 360);
    return 1 / (1 + alpha * (x * x + y * y));
}

double full_turn(double angle_deg)
{
    double const rest = std::fmod(angle_deg, 360);
    return rest < 0 ? std::fmod(rest + 360, 360) : rest;
}

double node_turn_deg(Pattern pattern)
{
    return law_of(pattern).turn_deg;
}

std::size_t node_size(Pattern pattern)
{
    return static_cast<std::size_t>(std::max(1, law_of(pattern).whorl));
}

double node_distance(Pattern pattern, std::size_t count)
{
    return static_cast<double>(node_size(pattern))
        / static_cast<double>(std::max<std::size_t>(count, 1));
}

double misfit(Pattern pattern, double node, Place const& a, Place const& b)
{
    auto const law = law_of(pattern);
    if (law.whorl == 0)
        return 0;
    auto const& lower = a.u <= b.u ? a : b;
    auto const& upper = a.u <= b.u ? b : a;
    // The number of nodes between the two branches is rounded. Rounding down, as in Wither 2009,
    // would put a perfect pattern exactly on the discontinuities.
    double const nodes = std::round((upper.u - lower.u) / node);
    double const period_deg = law.period_deg();
    double rest = std::fmod(upper.theta_deg - lower.theta_deg - nodes * law.turn_deg, period_deg);
    if (rest < 0)
        rest += period_deg;
    return std::min(rest, period_deg - rest) / period_deg;
}

Arrangement arrange(std::vector<DrawnPlace> const& drawn, ArrangementOptions const& options,
                    RandomKey const& key)
{
    bool const is_whole
        = options.nodes == ArrangementOptions::Nodes::Whole && options.pattern != Pattern::Even;
    return is_whole ? arrange_whorls(drawn, options, key) : Spreader(drawn, options, key).run();
}

} // namespace tractus::silhouette
