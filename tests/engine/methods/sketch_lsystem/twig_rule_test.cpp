#include "engine/methods/sketch_lsystem/twig_rule.h"

#include "tests/engine/methods/drawn_by_hand.h"

#include <gtest/gtest.h>

namespace tractus::sketch {
namespace {

struct MeantTwig {
    int laterals = 2;
    double first_mm = 30;
    double ratio = 0.9;
    double angle_deg = 45;
    double share = 0.6;
    double twist_deg = 90;
    int order = 1;
    int nodes = 5;
    double bow = 0; // Bend of the axis at each node, in degrees.
};

// Grows a twig by the rule of the paper, and draws each internode of a lateral as a stroke.
class TwigDrawer {
public:
    TwigDrawer(MeantTwig const& meant, std::uint64_t seed, double tremor_mm)
        : meant_(meant)
        , hand_(seed)
        , tremor_mm_(tremor_mm)
    {
    }

    DrawnTwig draw()
    {
        std::vector<Vec3> axis { Vec3::Zero() };
        Vec3 heading(0, 0, 1);
        Vec3 left(-1, 0, 0);
        Vec3 down(0, 1, 0);
        double length_mm = meant_.first_mm;
        for (int node = 0; node < meant_.nodes; ++node) {
            if (node > 0) {
                Eigen::AngleAxisd const bow(radians(meant_.bow), down);
                heading = bow * heading;
                left = bow * left;
            }
            axis.push_back(axis.back() + length_mm * heading);
            for (int k = 0; k < meant_.laterals; ++k) {
                double const roll
                    = radians(meant_.twist_deg * (node + 1) + 360.0 * k / meant_.laterals);
                Vec3 const aside = std::cos(roll) * left + std::sin(roll) * down;
                add_lateral(axis.back(), heading, aside, length_mm * meant_.share, meant_.order);
            }
            length_mm *= meant_.ratio;
        }
        axis.push_back(axis.back() + length_mm * heading);
        twig_.axis_mm = hand_.draw(axis, tremor_mm_);
        hand_.shuffle(twig_.laterals_mm);
        return std::move(twig_);
    }

private:
    void add_lateral(Vec3 const& foot, Vec3 const& heading, Vec3 const& aside, double length_mm,
                     int order)
    {
        double const turn = radians(meant_.angle_deg);
        Vec3 const way = std::cos(turn) * heading + std::sin(turn) * aside;
        Vec3 const tip = foot + length_mm * way;
        auto stroke = hand_.draw({ foot, tip }, tremor_mm_);
        if (hand_.chance(0.5))
            std::reverse(stroke.begin(), stroke.end());
        twig_.laterals_mm.push_back(std::move(stroke));
        if (order < 2)
            return;
        Vec3 const across = (aside - aside.dot(way) * way).normalized();
        for (int k = 0; k < meant_.laterals; ++k) {
            Eigen::AngleAxisd const roll(radians(360.0 * k / meant_.laterals), way);
            add_lateral(tip, way, roll * across, length_mm * meant_.share, order - 1);
        }
    }

    MeantTwig meant_;
    Hand hand_;
    double tremor_mm_;
    DrawnTwig twig_;
};

MeantTwig random_twig(std::uint64_t seed)
{
    Hand chooser(seed * 31 + 7);
    MeantTwig meant;
    meant.laterals = 1 + static_cast<int>(chooser.below(3));
    meant.first_mm = chooser.between(22, 50);
    meant.ratio = chooser.between(0.75, 1.0);
    meant.angle_deg = chooser.between(25, 80);
    meant.share = chooser.between(0.4, 0.9);
    meant.order = chooser.chance(0.3) ? 2 : 1;
    meant.nodes = 4 + static_cast<int>(chooser.below(4));
    meant.bow = chooser.between(-6, 6);
    // Adding multiples of 360 degrees / k to the rotation gives the same twig. The angle nearest to
    // 0 is used.
    double const half_deg = 180.0 / meant.laterals;
    meant.twist_deg = chooser.between(-half_deg, half_deg);
    return meant;
}

double twist_off_deg(double found_deg, MeantTwig const& meant)
{
    return std::fabs(std::remainder(found_deg - meant.twist_deg, 360.0 / meant.laterals));
}

TEST(TwigRule, FindsTheRulesOfRandomTwigs)
{
    constexpr int kTwigs = 200;
    int right = 0;
    int accepted = 0; // Number of rules that were found correctly and also accepted.
    double angles = 0;
    double shares = 0;
    double ratios = 0;
    double worst_deg = 0;
    int exact = 0; // Number of rules whose angles are off by at most 3 degrees.
    for (std::uint64_t seed = 1; seed <= kTwigs; ++seed) {
        auto const meant = random_twig(seed);
        auto const found = find_twig_rule(TwigDrawer(meant, seed, 0.2).draw());
        ASSERT_TRUE(found) << seed << ": " << found.error().message;
        bool const is_right = found->rule.laterals == meant.laterals && found->order == meant.order
            && found->nodes == meant.nodes && found->bare_nodes == 0;
        if (!is_right) {
            std::printf("%d: %d laterals (%d), order %d (%d), %d nodes (%d), %d bare\n",
                        static_cast<int>(seed), found->rule.laterals, meant.laterals, found->order,
                        meant.order, found->nodes, meant.nodes, found->bare_nodes);
            continue;
        }
        ++right;
        double const off_deg = std::fabs(found->rule.angle_deg - meant.angle_deg);
        worst_deg = std::max(worst_deg, off_deg);
        exact += off_deg <= 3 && twist_off_deg(found->rule.axis_twist_deg, meant) <= 3;
        angles += off_deg;
        shares = std::max(shares, std::fabs(found->rule.lateral_length / meant.share - 1));
        ratios = std::max(ratios, std::fabs(found->rule.length_ratio / meant.ratio - 1));
        accepted += found->is_rule();
    }
    std::printf("%d of %d; angles off by %.2f degrees in the mean, %.2f at most; length ratios by "
                "%.3f and %.3f at most\n",
                right, kTwigs, angles / right, worst_deg, shares, ratios);
    EXPECT_GE(right, 0.95 * kTwigs);
    EXPECT_GE(accepted, 0.95 * right);
    EXPECT_GE(exact, 0.98 * right);
    EXPECT_LE(shares, 0.05);
    EXPECT_LE(ratios, 0.05);
}

TEST(TwigRule, WithoutAHandTheNumbersAreExact)
{
    MeantTwig const meant { .laterals = 2, .share = 0.5, .twist_deg = 90, .nodes = 6 };
    DrawnTwig twig;
    double at_mm = 0;
    for (int node = 0; node < meant.nodes; ++node) {
        double const length_mm = meant.first_mm * std::pow(meant.ratio, node);
        at_mm += length_mm;
        for (int side : { -1, 1 }) {
            double const out_mm = side * 0.5 * length_mm * std::sqrt(0.5);
            Vec3 const way = node % 2 == 0 ? Vec3(0, out_mm, std::fabs(out_mm))
                                           : Vec3(out_mm, 0, std::fabs(out_mm));
            twig.laterals_mm.push_back({ Vec3(0, 0, at_mm), Vec3(0, 0, at_mm) + way });
        }
    }
    twig.axis_mm = { Vec3::Zero(), Vec3(0, 0, at_mm + 10) };
    auto const found = find_twig_rule(twig).value();
    EXPECT_EQ(found.rule.laterals, 2);
    EXPECT_NEAR(found.rule.first_length_mm, 30, 1e-3);
    EXPECT_NEAR(found.rule.length_ratio, 0.9, 1e-6);
    EXPECT_NEAR(found.rule.angle_deg, 45, 1e-3);
    EXPECT_NEAR(found.rule.lateral_length, 0.5, 1e-4);
    EXPECT_NEAR(std::fabs(found.rule.axis_twist_deg), 90, 0.3);
    EXPECT_LT(found.misfit, 0.01);
}

TEST(TwigRule, AScribbleIsNoRule)
{
    Hand hand(4);
    DrawnTwig twig { .axis_mm = { Vec3::Zero(), Vec3(0, 0, 150) }, .laterals_mm = {} };
    for (int i = 0; i < 9; ++i) {
        Vec3 const foot(0, 0, hand.between(5, 145));
        twig.laterals_mm.push_back(
            { foot, foot + Vec3(hand.between(-60, 60), 0, hand.between(-60, 60)) });
    }
    auto const found = find_twig_rule(twig);
    if (found)
        EXPECT_FALSE(found->is_rule()) << found->misfit;
}

TEST(TwigRule, RefusesWhatIsNoTwig)
{
    std::vector<Vec3> const axis { Vec3::Zero(), Vec3(0, 0, 100) };
    EXPECT_NE(find_twig_rule({ axis, {} }).error().message.find("has 0 laterals"),
              std::string::npos);
    EXPECT_NE(find_twig_rule({ axis, { { Vec3(0, 0, 1), Vec3(0, 0, 1) } } })
                  .error()
                  .message.find("lateral 1 is only a dot"),
              std::string::npos);
    double const nan = std::nan("");
    EXPECT_NE(find_twig_rule({ { Vec3(nan, 0, 0), Vec3(0, 0, 9) }, { axis } })
                  .error()
                  .message.find("the axis is only a dot"),
              std::string::npos);
}

} // namespace
} // namespace tractus::sketch
