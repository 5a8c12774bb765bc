#include "engine/methods/construction_lines/hand_line.h"

#include "engine/methods/construction_lines/drawn_line.h"
#include "engine/stroke/polyline.h"
#include "tests/engine/methods/drawn_by_hand.h"

#include <gtest/gtest.h>

namespace tractus::lines {
namespace {

// Returns the points of a curved stem of 180 mm.
std::vector<Vec3> bowed_line()
{
    std::vector<Vec3> points;
    for (int i = 0; i <= 180; ++i)
        points.emplace_back(25 * std::sin(kPi * i / 180), i, 0);
    return points;
}

double heading_deg(std::vector<Vec3> const& line, double share)
{
    ArcLength const along(line);
    Vec3 const way = along.at(share + 0.002) - along.at(share - 0.002);
    return degrees(std::atan2(-way.x(), way.y()));
}

// Returns the root mean square error of a line's headings, in degrees, over the middle 90 % of its
// length.
double rms_heading_error_deg(std::vector<Vec3> const& line, std::vector<Vec3> const& meant)
{
    double sum = 0;
    int count = 0;
    for (double share = 0.05; share <= 0.95; share += 0.01) {
        sum += std::pow(heading_deg(line, share) - heading_deg(meant, share), 2);
        ++count;
    }
    return std::sqrt(sum / count);
}

TEST(HandLine, ATremorOfAThirdOfAMillimetreTurnsNothingByMoreThanADegreeAndAHalf)
{
    auto const meant = bowed_line();
    for (double const tremor_mm : { 0.1, 0.2, 0.35 }) {
        double worst_deg = 0;
        double sum = 0;
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            auto const drawn = without_repeats(Hand(seed).draw(meant, tremor_mm));
            double const error_deg = rms_heading_error_deg(clean_hand_line(drawn), meant);
            worst_deg = std::max(worst_deg, error_deg);
            sum += error_deg * error_deg;
        }
        double const rms_deg = std::sqrt(sum / 20);
        std::printf("tremor %.2f mm: %.2f degrees rms, at worst %.2f\n", tremor_mm, rms_deg,
                    worst_deg);
        EXPECT_LE(rms_deg, 1.5) << tremor_mm;
    }
}

TEST(HandLine, ALineWithoutTremorStays)
{
    auto const meant = bowed_line();
    auto const cleaned = clean_hand_line(meant);
    ArcLength const along(meant);
    ArcLength const other(cleaned);
    for (double share = 0; share <= 1; share += 0.05)
        EXPECT_LT((along.at(share) - other.at(share)).norm(), 0.1) << share;
}

TEST(HandLine, CornersStaySharp)
{
    std::vector<Vec3> line;
    for (int i = 0; i <= 80; ++i)
        line.emplace_back(-80 + i, 80 - i, 0);
    for (int i = 1; i <= 80; ++i)
        line.emplace_back(i, i, 0);
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        auto const cleaned = clean_hand_line(without_repeats(Hand(seed).draw(line, 0.2)));
        double min_mm = 1e9;
        for (auto const& point : cleaned)
            min_mm = std::min(min_mm, (point - Vec3(0, 0, 0)).norm());
        EXPECT_LT(min_mm, 1.0) << seed;
        // The line must be straight to within 3 mm of its corner.
        for (auto const& point : cleaned) {
            double const off_mm = std::fabs(point.y() - std::fabs(point.x())) / std::sqrt(2.0);
            EXPECT_LT(off_mm, 1.2) << seed << ": " << point.transpose();
        }
    }
}

TEST(HandLine, CutsHooksAndNothingElse)
{
    auto const meant = bowed_line();
    for (double const hook_mm : { 0.5, 1.0, 2.0, 3.0 })
        for (double const turn_deg : { -150.0, -90.0, 60.0, 120.0 }) {
            auto line = meant;
            Hand::add_hook(line, hook_mm, turn_deg);
            auto const trimmed = trim_hooks(line);
            EXPECT_LT((trimmed.back() - meant.back()).norm(), 1.2) << hook_mm << " " << turn_deg;
            double const heading = heading_deg(trimmed, 0.99);
            EXPECT_NEAR(heading, heading_deg(meant, 0.99), 6) << hook_mm << " " << turn_deg;
        }
    EXPECT_LT((trim_hooks(meant).back() - meant.back()).norm(), 1e-6);
    EXPECT_LT((trim_hooks(meant).front() - meant.front()).norm(), 1e-6);
}

TEST(HandLine, FewCornersAreExact)
{
    std::vector<Vec3> const line { { 0, 0, 0 }, { 0, 40, 0 }, { 30, 60, 0 } };
    EXPECT_EQ(clean_hand_line(line), line);
}

} // namespace
} // namespace tractus::lines
