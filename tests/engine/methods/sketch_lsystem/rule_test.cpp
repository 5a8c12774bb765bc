#include "engine/methods/sketch_lsystem/rule.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

namespace tractus::sketch {
namespace {

TEST(SketchRule, AcceptsItsDefaults)
{
    EXPECT_TRUE(check_rule({}));
}

TEST(SketchRule, RefusesWhatIsOutOfRangeByItsLetter)
{
    auto const refused = check_rule({ .length_ratio = 1.4 });
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().fault, Fault::User);
    EXPECT_EQ(refused.error().message,
              "r, each internode's length by the one before it, is 1.4: give 0.5 to 1.2");
    EXPECT_FALSE(check_rule({ .laterals = 9 }));
    EXPECT_FALSE(check_rule({ .angle_deg = std::numeric_limits<double>::quiet_NaN() }));
    EXPECT_FALSE(check_rule({ .shortest_mm = 0 }));
    EXPECT_FALSE(check_rule({ .most_segments = 0 }));
}

// Closed forms for n steps and k laterals: F_n = n + the sum over j < n of L_j, with L_n = k (k^n -
// 1)/(k - 1), or L_n = n for k = 1.
TEST(SketchRule, CountsInternodesAsTheClosedFormsDo)
{
    Rule rule { .shortest_mm = 1e-3 };
    auto const counts = [&](int laterals) {
        rule.laterals = laterals;
        std::vector<double> result;
        for (int n = 1; n <= 6; ++n)
            result.push_back(count_internodes(rule, n, kUncutDepth));
        return result;
    };
    EXPECT_EQ(counts(0), (std::vector<double> { 1, 2, 3, 4, 5, 6 }));
    EXPECT_EQ(counts(1), (std::vector<double> { 1, 3, 6, 10, 15, 21 }));
    EXPECT_EQ(counts(2), (std::vector<double> { 1, 4, 11, 26, 57, 120 }));
    EXPECT_EQ(counts(3), (std::vector<double> { 1, 5, 18, 58, 179, 543 }));
}

// The laterals have a rule of their own. If it has no laterals, those of node j have n - 1 - j
// internodes each. If it has k' laterals that fork without end, each of these begins a tree of L_m
// internodes.
TEST(SketchRule, CountsLateralsThatGoOn)
{
    Rule rule { .laterals = 3, .shortest_mm = 1e-3 };
    rule.lateral_rules = { { .length_ratio = 1, .laterals = 0, .shortest_mm = 1e-3 } };
    for (int n = 1; n <= 9; ++n)
        EXPECT_EQ(count_internodes(rule, n, kUncutDepth), n + 3 * n * (n - 1) / 2);
    rule.lateral_rules = { { .length_ratio = 1, .laterals = 2, .shortest_mm = 1e-3 } };
    // For n = 4, there are three laterals each of 3, 2, 1 and 0 internodes. Node i of a lateral
    // with m internodes has two complete trees of g = m - 1 - i generations, which have 2 (2^g -
    // 1)/(2 - 1) internodes together.
    auto const of_lateral = [](int m) {
        double sum = m;
        for (int i = 0; i < m; ++i)
            sum += 2 * ((1 << (m - 1 - i)) - 1);
        return sum;
    };
    EXPECT_EQ(count_internodes(rule, 4, kUncutDepth),
              4 + 3 * (of_lateral(3) + of_lateral(2) + of_lateral(1)));
    EXPECT_EQ(count_internodes(rule, 4, 1), 4 + 3 * 3) << "at depth 1 none goes on";
    rule.lateral_rules.assign(kMaxLateralRules + 1, {});
    EXPECT_FALSE(check_rule(rule));
    rule.lateral_rules = { { .angle_deg = 151 } };
    EXPECT_EQ(check_rule(rule).error().message,
              "laterals.a, the laterals' angle in degrees, is 151: give 0 to 150");
}

// The rule has k laterals that use the same rule again. So C(m) = m + k (C(0) + ... + C(m - 1)),
// which is ((k + 1)^m - 1) / k internodes for each lateral with m remaining steps.
TEST(SketchRule, CountsRulesThatCallThemselves)
{
    Rule rule { .laterals = 1, .shortest_mm = 1e-3 };
    for (int const k : { 1, 2, 3 }) {
        rule.lateral_rules
            = { { .length_ratio = 1, .laterals = k, .shortest_mm = 1e-3, .laterals_by = 1 } };
        ASSERT_TRUE(check_rule(rule));
        for (int n = 1; n <= 7; ++n) {
            double sum = n;
            for (int m = 0; m < n; ++m)
                sum += (std::pow(k + 1, m) - 1) / k;
            EXPECT_EQ(count_internodes(rule, n, kUncutDepth), sum) << k << " " << n;
        }
    }
}

// Two rules of laterals call each other. As long as they are alike, the counts must be those of a
// single rule that calls itself.
TEST(SketchRule, CountsRulesThatCallEachOther)
{
    Rule rule { .laterals = 2, .shortest_mm = 1e-3 };
    rule.lateral_rules
        = { { .length_ratio = 1, .laterals = 1, .shortest_mm = 1e-3 },
            { .length_ratio = 1, .laterals = 1, .shortest_mm = 1e-3, .laterals_by = 1 } };
    auto turns = rule;
    turns.lateral_rules.resize(1);
    turns.lateral_rules[0].laterals_by = 1;
    for (int n = 1; n <= 9; ++n)
        EXPECT_EQ(count_internodes(rule, n, kUncutDepth), count_internodes(turns, n, kUncutDepth))
            << "alike, they are one that calls itself";
    rule.lateral_rules[1].laterals_by = 3;
    EXPECT_EQ(check_rule(rule).error().message,
              "laterals.by, the number of its laterals' rule, is 3: give 0 to 2");
}

TEST(SketchRule, CutsTheDepthToStayWithinItsLimit)
{
    Rule const rule { .laterals = 3, .shortest_mm = 0.01, .most_internodes = 20'000 };
    EXPECT_EQ(depth_within_limit(rule, 9), kUncutDepth);
    EXPECT_EQ(count_internodes(rule, 9, kUncutDepth), 14'757);
    EXPECT_EQ(depth_within_limit(rule, 10), 7);
    EXPECT_EQ(count_internodes(rule, 10, 7), 11'476);
    EXPECT_EQ(depth_within_limit(rule, 12), 7);
    EXPECT_EQ(count_internodes(rule, 12, 7), 18'036);
}

TEST(SketchRule, TheShortestInternodeKeepsPlantsSmall)
{
    Rule const rule { .laterals = 3, .most_internodes = 20'000 };
    EXPECT_EQ(count_internodes(rule, 12, kUncutDepth), 9'288);
}

TEST(SketchRule, TheDepthOnlyFallsWhileAStrokeGrows)
{
    Rule const rule { .laterals = 8, .lateral_length = 1, .most_internodes = 5'000 };
    int depth = kUncutDepth;
    for (int segments = 1; segments <= 64; ++segments) {
        int const next = depth_within_limit(rule, segments);
        EXPECT_LE(next, depth);
        EXPECT_LE(count_internodes(rule, segments, next), rule.most_internodes);
        depth = next;
    }
    EXPECT_EQ(depth, 2);
}

} // namespace
} // namespace tractus::sketch
