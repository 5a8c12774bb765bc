#include "app/methods/sketch_lsystem/rule_file.h"

#include <gtest/gtest.h>

namespace tractus::sketch {
namespace {

TEST(RuleFile, TakesWhatIsMissingFromTheRest)
{
    auto const rule = parse_rule("k = 3\nl = 40\n", "three.toml");
    ASSERT_TRUE(rule) << rule.error().message;
    EXPECT_EQ(rule->laterals, 3);
    EXPECT_EQ(rule->first_width_mm, 6); // The default width is 0.15 of the first length.
    // The default twist is 180 degrees divided by the number of laterals.
    EXPECT_EQ(rule->axis_twist_deg, 60);
    // The default twist is 180 degrees divided by the number of laterals.
    EXPECT_EQ(rule->lateral_twist_deg, 60);
    EXPECT_EQ(rule->length_ratio, 0.9);
}

TEST(RuleFile, ReadsEveryLetter)
{
    auto const rule = parse_rule("k=1\nl=20\nr=0.8\nq=0.7\nw=2\ns=0.5\nv=0.4\na=30\nT=10\nt=-20\n"
                                 "l_min=2\nn_max=9\nlimit=500\n",
                                 "all.toml");
    ASSERT_TRUE(rule) << rule.error().message;
    EXPECT_EQ(*rule,
              (Rule { .first_length_mm = 20,
                      .length_ratio = 0.8,
                      .width_ratio = 0.7,
                      .first_width_mm = 2,
                      .laterals = 1,
                      .angle_deg = 30,
                      .lateral_length = 0.5,
                      .lateral_width = 0.4,
                      .axis_twist_deg = 10,
                      .lateral_twist_deg = -20,
                      .shortest_mm = 2,
                      .most_segments = 9,
                      .most_internodes = 500 }));
}

TEST(RuleFile, GivesLateralsRulesOfTheirOwn)
{
    auto const rule = parse_rule(
        "k = 3\n[[laterals]]\nk = 4\nr = 0.9\n[[laterals]]\nk = 0\n[[laterals]]\nby = 2\n",
        "my.toml");
    ASSERT_TRUE(rule) << rule.error().message;
    ASSERT_EQ(rule->lateral_rules.size(), 3u);
    EXPECT_EQ(rule->lateral_rules[2], (LateralRule { .twist_deg = 90, .laterals_by = 2 }));
    EXPECT_EQ(rule->lateral_rules[0],
              (LateralRule { .length_ratio = 0.9, .laterals = 4, .twist_deg = 45 }));
    EXPECT_EQ(rule->lateral_rules[1], (LateralRule { .laterals = 0, .twist_deg = 0 }));
}

TEST(RuleFile, HasNoTwistWithoutLaterals)
{
    auto const rule = parse_rule("k = 0", "bare.toml");
    ASSERT_TRUE(rule) << rule.error().message;
    EXPECT_EQ(rule->axis_twist_deg, 0);
}

std::string refusal(char const* text)
{
    auto const rule = parse_rule(text, "my.toml");
    return rule ? "accepted" : rule.error().message;
}

TEST(RuleFile, RefusesWhatIsNoRuleInASentence)
{
    EXPECT_EQ(refusal("r = 1.4"),
              "my.toml: r, each internode's length by the one before it, is 1.4: give 0.5 to 1.2");
    EXPECT_EQ(refusal("k = 2.5"), "my.toml:1: k is 2.5, expected a whole number");
    EXPECT_EQ(refusal("k = -1"), "my.toml:1: k is -1, which is no count");
    EXPECT_EQ(refusal("a = nan"), "my.toml:1: a is nan, expected a number");
    EXPECT_NE(refusal("angle = 3").find("my.toml:1: angle"), std::string::npos);
    EXPECT_NE(refusal("[[laterals]]\nl = 3").find("my.toml:2: laterals[1].l"), std::string::npos)
        << refusal("[[laterals]]\nl = 3");
    EXPECT_NE(refusal("k = ").find("my.toml"), std::string::npos);
}

} // namespace
} // namespace tractus::sketch
