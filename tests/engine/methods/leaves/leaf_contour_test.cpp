#include "engine/methods/leaves/leaf_contour.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <vector>

namespace tractus::leaf {
namespace {

constexpr int kContourSide = 200;

// Alpha of a shape whose signed distance in pixels from its edge is given, positive inside; x and y
// are those of the pixel's centre, y upwards.
std::vector<float> drawn_alpha(std::function<double(double, double)> const& inside)
{
    std::vector<float> alpha;
    for (int row = 0; row < kContourSide; ++row)
        for (int x = 0; x < kContourSide; ++x)
            alpha.push_back(static_cast<float>(
                std::clamp(inside(x + 0.5, kContourSide - row - 0.5) + 0.5, 0.0, 1.0)));
    return alpha;
}

double drawn_ring(double x, double y)
{
    double const radius = std::hypot(x - 90, y - 110);
    return std::min(70 - radius, radius - 30);
}

TEST(LeafContour, GoesRoundPartsAndHoles)
{
    auto const contours = trace_contours(drawn_alpha(drawn_ring), kContourSide, 0.5, 10);
    ASSERT_EQ(contours.size(), 2u);
    auto const [hole, part]
        = std::minmax_element(contours.begin(), contours.end(), [](auto const& a, auto const& b) {
              return contour_area(a) < contour_area(b);
          });
    EXPECT_NEAR(contour_area(*part), kPi * 70 * 70, 20);
    EXPECT_NEAR(contour_area(*hole), -kPi * 30 * 30, 20);
    for (auto const& point : *part)
        EXPECT_NEAR((point - Vec2(90, 110)).norm(), 70, 0.1);
}

TEST(LeafContour, IsClosedAtThePicturesEdge)
{
    auto const all = drawn_alpha([](double, double) { return 9.0; });
    auto const contours = trace_contours(all, kContourSide, 0.5, 10);
    ASSERT_EQ(contours.size(), 1u);
    EXPECT_NEAR(contour_area(contours[0]), double(kContourSide) * kContourSide, 2);
}

TEST(LeafContour, ThinnedStaysWithinItsTolerance)
{
    auto const contours = trace_contours(drawn_alpha(drawn_ring), kContourSide, 0.5, 10);
    for (double const tolerance : { 0.2, 1.0, 4.0 }) {
        auto const thin = thinned(contours[0], tolerance);
        EXPECT_LT(thin.size(), contours[0].size() / 4);
        for (std::size_t i = 0; i < thin.size(); ++i) {
            Vec2 const middle = (thin[i] + thin[(i + 1) % thin.size()]) / 2;
            double const radius = (middle - Vec2(90, 110)).norm();
            EXPECT_LT(std::min(std::abs(radius - 70), std::abs(radius - 30)), tolerance + 0.1);
        }
    }
}

double drawn_lobes(double x, double y)
{
    double const angle = std::atan2(y - 100, x - 100);
    return 60 + 25 * std::cos(7 * angle) - std::hypot(x - 100, y - 100);
}

bool contour_holds(Contour const& contour, Vec2 const& at)
{
    bool is_inside = false;
    for (std::size_t i = 0; i < contour.size(); ++i) {
        Vec2 const& a = contour[i];
        Vec2 const& b = contour[(i + 1) % contour.size()];
        if ((a.y() > at.y()) == (b.y() > at.y()))
            continue;
        is_inside ^= a.x() + (at.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()) > at.x();
    }
    return is_inside;
}

TEST(LeafContour, GrowsSimplerWithinItsAreaAndHoldsWhatItHeld)
{
    auto const traced = trace_contours(drawn_alpha(drawn_lobes), kContourSide, 0.5, 10);
    ASSERT_EQ(traced.size(), 1u);
    auto contour = thinned(traced[0], 0.3);
    auto const before = contour;
    double const area = contour_area(contour);
    grow_simpler(contour, 0.05 * area, area, kContourSide);
    EXPECT_LT(contour.size(), before.size() / 2);
    EXPECT_GE(contour_area(contour), area);
    EXPECT_LE(contour_area(contour), 1.0501 * area);
    for (std::size_t i = 0; i < before.size(); ++i) {
        Vec2 const inwards = before[i] + 1e-3 * (Vec2(100, 100) - before[i]);
        EXPECT_TRUE(contour_holds(contour, inwards)) << i;
    }
}

} // namespace
} // namespace tractus::leaf
