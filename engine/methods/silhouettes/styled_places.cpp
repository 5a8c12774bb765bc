#include "engine/methods/silhouettes/styled_places.h"

#include "engine/base/check.h"
#include "engine/base/random.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tractus::silhouette {

namespace {

constexpr std::uint32_t kPhaseStream = 5;
constexpr std::uint32_t kPlaceStream = 6;
// Golden ratio; its multiples modulo 1 are evenly distributed.
constexpr double kGolden = 0.61803398874989485;

double part_of_turn(double turns)
{
    return turns - std::floor(turns);
}

// Quantile function of the standard normal distribution.
double normal_quantile(double share)
{
    double low = -4;
    double high = 4;
    for (int i = 0; i < 40; ++i) {
        double const middle = (low + high) / 2;
        bool const is_below = 0.5 * std::erfc(-middle / std::sqrt(2.0)) < share;
        (is_below ? low : high) = middle;
    }
    return (low + high) / 2;
}

// Positions from 0 to 1 whose distances are log-normal with the normal scores `scores` and the
// logarithmic deviation `spread`.
std::vector<double> shares_of(std::vector<double> const& scores, double spread)
{
    std::vector<double> shares { 0 };
    for (auto const score : scores)
        shares.push_back(shares.back() + std::exp(spread * score));
    for (auto& share : shares)
        share /= std::max(shares.back(), 1e-9);
    return shares;
}

double unevenness_of(std::vector<double> const& shares)
{
    auto const gaps = static_cast<double>(shares.size() - 1);
    double squares = 0;
    for (std::size_t i = 1; i < shares.size(); ++i)
        squares += std::pow((shares[i] - shares[i - 1]) * gaps - 1, 2);
    return std::sqrt(squares / gaps);
}

// The log-normal deviation at which the distances with these scores have the coefficient of
// variation `unevenness`, or the nearest that they can have. The formula for an infinite sample
// would make a small number of distances too even.
double spread_for(std::vector<double> const& scores, double unevenness)
{
    double low = 0;
    double high = 8;
    for (int i = 0; scores.size() > 1 && i < 40; ++i) {
        double const middle = (low + high) / 2;
        (unevenness_of(shares_of(scores, middle)) < unevenness ? low : high) = middle;
    }
    return low;
}

} // namespace

StyledPlaces::StyledPlaces(BranchStyle const& style, Pattern pattern, std::uint64_t seed,
                           std::uint32_t level)
    : style_(style)
    , whorl_(node_size(pattern))
    , seed_(seed)
{
    Random random({ .seed = seed, .stream = kPhaseStream, .substream = level });
    count_phase_ = random.uniform();
    angle_phase_ = random.uniform();
    extent_phase_ = random.uniform();
}

bool StyledPlaces::next_has_children()
{
    bearing_ += 1 - style_.bare;
    if (bearing_ < 0.5)
        return false;
    bearing_ -= 1;
    return true;
}

// Number of children of the next parent: the mean for the first parent, then pairs of numbers
// equally far above and below the mean. So even a small number of parents has the right mean.
std::size_t StyledPlaces::next_count(std::size_t least)
{
    auto const pair = (counted_ + 1) / 2;
    double off = 0;
    if (pair > 0)
        off = normal_quantile(
            0.5 + 0.5 * part_of_turn(count_phase_ + kGolden * static_cast<double>(pair)));
    double const wanted
        = style_.children + (counted_ % 2 == 0 ? -off : off) * style_.children_deviation;
    ++counted_;
    double const count
        = std::max({ 1.0, static_cast<double>(least), std::round(wanted + count_left_) });
    count_left_ += wanted - count;
    return static_cast<std::size_t>(count);
}

double StyledPlaces::next_first(double low)
{
    double const wanted = style_.unbranched + first_left_;
    double const first = std::clamp(wanted, std::min(low, 1.0), 1.0);
    first_left_ = wanted - first;
    return first;
}

// Distance from the next parent's first child to its last, as a share of the parent's length.
double StyledPlaces::next_extent(std::size_t count, double room)
{
    // Limits of the result, as multiples of the style's mean.
    constexpr double kMin = 0.3;
    constexpr double kMax = 3;
    extent_left_ += style_.spacing * static_cast<double>(count - 1) * extent_factor();
    if (count < 2)
        return 0;
    double const usual = style_.spacing * std::max(1.0, style_.children - 1);
    double const extent = std::clamp(std::clamp(extent_left_, kMin * usual, kMax * usual), 0.0,
                                     std::max(room, 0.0));
    extent_left_ -= extent;
    return extent;
}

// Factor on the distances between the next parent's children. It represents the part of the
// variance that is between parents. Like the numbers of children, factors come in pairs around 1;
// large factors go with many and with few children equally often.
double StyledPlaces::extent_factor() const
{
    auto const pair = counted_ / 2; // next_count() has already counted this parent.
    if (pair == 0 || !(style_.spacing > 0) || !(style_.spacing_deviation > 0))
        return 1;
    auto const squared = [](double value) { return value * value; };
    double const all = 1 + squared(style_.spacing_deviation / style_.spacing);
    double const on_one = static_cast<double>(whorl_) * (1 + squared(style_.unevenness));
    double const share
        = 0.5 + 0.5 * part_of_turn(extent_phase_ + kGolden * static_cast<double>(pair));
    double const off = normal_quantile(share) * std::sqrt(std::max(0.0, all / on_one - 1));
    return std::max(0.0, 1 + ((counted_ + pair) % 2 == 0 ? -off : off));
}

// Coefficient of variation of the distances on the next parent, chosen so that the distances on all
// parents together keep the style's standard deviation.
double StyledPlaces::next_unevenness(std::size_t count, std::size_t nodes, double extent)
{
    constexpr double kMaxChanged = 2;
    double const usual = style_.unevenness;
    if (!(style_.spacing_deviation > 0))
        return usual;
    squares_left_ += static_cast<double>(count - 1)
        * (std::pow(style_.spacing, 2) + std::pow(style_.spacing_deviation, 2));
    if (nodes < 2 || !(extent > 0))
        return usual;
    double const if_even = extent * extent / static_cast<double>(nodes - 1);
    double const wanted = std::sqrt(std::max(0.0, squares_left_ / if_even - 1));
    return std::clamp(wanted, usual / kMaxChanged, usual * kMaxChanged);
}

// Normal scores for the distances between a parent's nodes. Wither 2009 uses normally distributed
// distances; here they are log-normal, which gives the required coefficient of variation without
// negative values.
std::vector<double> StyledPlaces::node_scores(std::size_t nodes, std::uint32_t parent) const
{
    Random random({ .seed = seed_, .stream = kPlaceStream, .substream = parent });
    std::vector<double> scores;
    double const phase = random.uniform();
    for (std::size_t i = 1; i < nodes; ++i) {
        // Quantile beyond which none of `nodes` values lies.
        double const edge = 0.5 / static_cast<double>(nodes);
        double const share
            = std::clamp(part_of_turn(phase + kGolden * static_cast<double>(i)), edge, 1 - edge);
        scores.push_back(normal_quantile(share));
    }
    return scores;
}

std::vector<double> StyledPlaces::next(Parent const& parent)
{
    auto const count = next_count(parent.least);
    double const first = next_first(parent.low);
    double const extent = next_extent(count, 1 - first);
    auto const scores = node_scores((count + whorl_ - 1) / whorl_, parent.number);
    double const unevenness = next_unevenness(count, scores.size() + 1, extent);
    double const spread = style_.spacing_deviation > 0
        ? spread_for(scores, unevenness)
        : std::sqrt(std::log1p(unevenness * unevenness));
    auto const nodes = shares_of(scores, spread);
    if (!scores.empty()) {
        double const uneven = unevenness_of(nodes);
        squares_left_
            -= extent * extent / static_cast<double>(scores.size()) * (1 + uneven * uneven);
    }
    std::vector<double> places;
    for (std::size_t i = 0; i < count; ++i)
        places.push_back(first + extent * nodes[i / whorl_]);
    return places;
}

double StyledPlaces::next_angle_deg(double share)
{
    constexpr double kMaxMadeUp_deg = 15;
    double const part = part_of_turn(angle_phase_ + kGolden * static_cast<double>(angled_++));
    double const wanted_deg
        = style_.angle_at_deg(share) + style_.angle_deviation_deg * normal_quantile(part);
    double const made_up_deg = std::clamp(angle_left_deg_, -kMaxMadeUp_deg, kMaxMadeUp_deg);
    double const angle_deg = std::clamp(wanted_deg + made_up_deg, kMinAngle_deg, kMaxAngle_deg);
    angle_left_deg_ += wanted_deg - angle_deg;
    return angle_deg;
}

void StyledPlaces::take_angle(double share, double angle_deg)
{
    angle_left_deg_ += style_.angle_at_deg(share) - angle_deg;
}

std::vector<std::size_t> nearest_in_order(std::vector<double> const& places,
                                          std::vector<double> const& others,
                                          std::vector<double> const& costs)
{
    auto const n = places.size();
    auto const m = others.size();
    CHECK(n <= m);
    // Minimum cost of assigning the first i of `places` to some of the first j of `others`.
    std::vector<std::vector<double>> sums(
        n + 1, std::vector<double>(m + 1, std::numeric_limits<double>::infinity()));
    std::fill(sums[0].begin(), sums[0].end(), 0.0);
    auto const taken = [&](std::size_t i, std::size_t j) {
        double const off = places[i - 1] - others[j - 1];
        return sums[i - 1][j - 1] + off * off + (costs.empty() ? 0 : costs[j - 1]);
    };
    for (std::size_t i = 1; i <= n; ++i)
        for (std::size_t j = i; j <= m; ++j)
            sums[i][j] = std::min(sums[i][j - 1], taken(i, j));
    std::vector<std::size_t> result(n);
    for (std::size_t i = n, j = m; i > 0; --j)
        if (taken(i, j) <= sums[i][j - 1])
            result[--i] = j - 1;
    return result;
}

} // namespace tractus::silhouette
