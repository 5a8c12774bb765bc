#include "engine/methods/sketch_lsystem/rule.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>

namespace tractus::sketch {

static Result<void> check_range(char const* letter, char const* meaning, double value, double least,
                                double most)
{
    if (value >= least && value <= most) // False for NaN.
        return {};
    return fail(
        Fault::User,
        fmt::format("{}, {}, is {:g}: give {:g} to {:g}", letter, meaning, value, least, most));
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
    TRY(check_range("n_max", "the most segments of a stroke", rule.most_segments, 1, 10'000));
    return check_range("limit", "the most internodes of a plant", rule.most_internodes,
                       rule.most_segments, 1e7);
}

double as_written(double value)
{
    return std::strtod(fmt::format("{:.6g}", value).c_str(), nullptr) + 0.0;
}

Rule as_written(Rule const& rule)
{
    Rule result = rule;
    for (auto* const value :
         { &result.first_length_mm, &result.length_ratio, &result.width_ratio,
           &result.first_width_mm, &result.angle_deg, &result.lateral_length, &result.lateral_width,
           &result.axis_twist_deg, &result.lateral_twist_deg, &result.shortest_mm })
        *value = as_written(*value);
    result.most_internodes = std::floor(rule.most_internodes);
    return result;
}

// How often the laterals of a node may fork in so many steps. Multiplied as the model does it, so
// that both stop at the same one.
static int count_forks(Rule const& rule, double parent_length_mm, int steps, int depth)
{
    int forks = 0;
    double length_mm = parent_length_mm * rule.lateral_length;
    while (forks < std::min(steps, depth) && length_mm >= rule.shortest_mm) {
        ++forks;
        length_mm *= rule.lateral_length;
    }
    return forks;
}

double count_internodes(Rule const& rule, int segments, int depth)
{
    double count = segments;
    double length_mm = rule.first_length_mm;
    for (int node = 0; node < segments; ++node) {
        int const forks = count_forks(rule, length_mm, segments - 1 - node, depth);
        double generation = 1;
        for (int i = 0; i < forks; ++i) {
            generation *= rule.laterals;
            count += generation;
        }
        length_mm *= rule.length_ratio;
    }
    return count;
}

int depth_within_limit(Rule const& rule, int segments)
{
    int depth = kUncutDepth;
    while (depth > 0 && count_internodes(rule, segments, depth) > rule.most_internodes)
        --depth;
    return depth;
}

} // namespace tractus::sketch
