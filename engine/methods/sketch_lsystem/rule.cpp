#include "engine/methods/sketch_lsystem/rule.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <limits>
#include <utility>

namespace tractus::sketch {

static Result<void> check_range(char const* letter, char const* meaning, double value, double least,
                                double most)
{
    if (value >= least && value <= most) // The comparison is false for NaN.
        return {};
    return fail(
        Fault::User,
        fmt::format("{}, {}, is {:g}: give {:g} to {:g}", letter, meaning, value, least, most));
}

static Result<void> check_lateral_rule(LateralRule const& rule)
{
    TRY(check_range("laterals.r", "each internode's length by the one before it", rule.length_ratio,
                    0.5, 1.2));
    TRY(check_range("laterals.q", "each internode's width by the one before it", rule.width_ratio,
                    0.3, 1));
    TRY(check_range("laterals.k", "the number of laterals at a node", rule.laterals, 0, 8));
    TRY(check_range("laterals.a", "the laterals' angle in degrees", rule.angle_deg, 0, 150));
    TRY(check_range("laterals.s", "a lateral's length by its parent's", rule.lateral_length, 0.2,
                    1));
    TRY(check_range("laterals.v", "a lateral's width by its parent's", rule.lateral_width, 0.2, 1));
    TRY(check_range("laterals.T", "the twist along them in degrees", rule.twist_deg, -180, 180));
    return check_range("laterals.l_min", "the shortest internode in mm", rule.shortest_mm, 1e-3,
                       1e4);
}

Result<void> check_rule(Rule const& rule)
{
    TRY(check_range("l", "the first internode's length in mm", rule.first_length_mm, 5, 100));
    TRY(check_range("r", "each internode's length by the one before it", rule.length_ratio, 0.5,
                    1.2));
    TRY(check_range("q", "each internode's width by the one before it", rule.width_ratio, 0.3, 1));
    TRY(check_range("w", "the first internode's diameter in mm", rule.first_width_mm,
                    0.02 * rule.first_length_mm, 0.5 * rule.first_length_mm));
    TRY(check_range("k", "the number of laterals at a node", rule.laterals, 0, 8));
    TRY(check_range("a", "the laterals' angle in degrees", rule.angle_deg, 0, 150));
    TRY(check_range("s", "a lateral's length by its parent's", rule.lateral_length, 0.2, 1));
    TRY(check_range("v", "a lateral's width by its parent's", rule.lateral_width, 0.2, 1));
    TRY(check_range("T", "the twist along the drawn axis in degrees", rule.axis_twist_deg, -180,
                    180));
    TRY(check_range("t", "the twist along laterals in degrees", rule.lateral_twist_deg, -180, 180));
    TRY(check_range("l_min", "the shortest internode in mm", rule.shortest_mm, 1e-3,
                    rule.first_length_mm));
    TRY(check_range("o", "the laterals' occupancy radius in mm", rule.occupancy_radius_mm, 0, 100));
    TRY(check_range("n_max", "the most segments of a stroke", rule.most_segments, 1, 10'000));
    if (rule.lateral_rules.size() > kMaxLateralRules)
        return fail(Fault::User,
                    fmt::format("laterals have {} rules: give at most {}",
                                rule.lateral_rules.size(), kMaxLateralRules));
    for (auto const& lateral : rule.lateral_rules) {
        TRY(check_lateral_rule(lateral));
        TRY(check_range("laterals.by", "the number of its laterals' rule", lateral.laterals_by, 0,
                        static_cast<double>(rule.lateral_rules.size())));
    }
    return check_range("limit", "the most internodes of a plant", rule.most_internodes,
                       rule.most_segments, 1e7);
}

double rounded_as_text(double value)
{
    return std::strtod(fmt::format("{:.6g}", value).c_str(), nullptr) + 0.0;
}

Rule rounded_as_text(Rule const& rule)
{
    Rule result = rule;
    for (auto* const value :
         { &result.first_length_mm, &result.length_ratio, &result.width_ratio,
           &result.first_width_mm, &result.angle_deg, &result.lateral_length, &result.lateral_width,
           &result.axis_twist_deg, &result.lateral_twist_deg, &result.shortest_mm,
           &result.occupancy_radius_mm })
        *value = rounded_as_text(*value);
    for (auto& lateral : result.lateral_rules)
        for (auto* const value : { &lateral.length_ratio, &lateral.width_ratio, &lateral.angle_deg,
                                   &lateral.lateral_length, &lateral.lateral_width,
                                   &lateral.twist_deg, &lateral.shortest_mm })
            *value = rounded_as_text(*value);
    result.most_internodes = std::floor(rule.most_internodes);
    return result;
}

std::size_t lateral_rule_after(Rule const& rule, std::size_t place)
{
    auto const by = rule.lateral_rules[place].laterals_by;
    return by > 0 ? static_cast<std::size_t>(by) - 1 : place + 1;
}

namespace {

// Counts the internodes that a rule's model will make. Lengths are multiplied in the model's order,
// so that rounding ends the count and the model at the same internode. Only one lateral of each
// ring is followed, and its count is multiplied by the number of laterals. The count is infinite if
// more internodes must be followed than the plant may have.
class InternodeCounter {
public:
    explicit InternodeCounter(Rule const& rule)
        : rule_(rule)
    {
    }

    double count(int segments, int depth)
    {
        count_ = segments;
        double length_mm = rule_.first_length_mm;
        for (int node = 0; node < segments && !is_too_much(); ++node) {
            add_ring(rule_.laterals, length_mm * rule_.lateral_length, segments - 1 - node, depth,
                     0);
            length_mm *= rule_.length_ratio;
        }
        return is_too_much() ? std::numeric_limits<double>::infinity() : count_;
    }

private:
    bool is_too_much() const { return followed_ > rule_.most_internodes; }

    // Adds the internodes of a ring of equal laterals that grow by the lateral rule with index
    // `level`.
    void add_ring(int laterals, double length_mm, int steps, int depth, std::size_t level)
    {
        if (level == rule_.lateral_rules.size())
            return add_forks(laterals, length_mm, steps, depth);
        double const before = std::exchange(count_, 0);
        auto const& rule = rule_.lateral_rules[level];
        for (int left = std::min(steps, depth);
             left > 0 && laterals > 0 && length_mm >= rule.shortest_mm && !is_too_much(); --left) {
            ++count_;
            ++followed_;
            add_ring(rule.laterals, length_mm * rule.lateral_length, left - 1, left - 1,
                     lateral_rule_after(rule_, level));
            length_mm *= rule.length_ratio;
        }
        count_ = before + laterals * count_;
    }

    // Adds the internodes of laterals that fork as in Ijiri et al. 2006: each ends in a ring of
    // further laterals.
    void add_forks(int laterals, double length_mm, int steps, int depth)
    {
        auto const& last = rule_.lateral_rules;
        int const of_each = last.empty() ? rule_.laterals : last.back().laterals;
        double const ratio = last.empty() ? rule_.lateral_length : last.back().lateral_length;
        double const shortest_mm = last.empty() ? rule_.shortest_mm : last.back().shortest_mm;
        double generation = laterals;
        for (int left = std::min(steps, depth); left > 0 && length_mm >= shortest_mm; --left) {
            count_ += generation;
            generation *= of_each;
            length_mm *= ratio;
        }
    }

    Rule const& rule_;
    double count_ = 0;
    double followed_ = 0;
};

} // namespace

double count_internodes(Rule const& rule, int segments, int depth)
{
    return InternodeCounter(rule).count(segments, depth);
}

int depth_within_limit(Rule const& rule, int segments)
{
    int depth = 0;
    int too_deep = kUncutDepth + 1;
    while (too_deep - depth > 1) {
        int const middle = (depth + too_deep) / 2;
        bool const fits = count_internodes(rule, segments, middle) <= rule.most_internodes;
        (fits ? depth : too_deep) = middle;
    }
    return depth;
}

} // namespace tractus::sketch
