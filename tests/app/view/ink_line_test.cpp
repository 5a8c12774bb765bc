#include "app/view/ink_line.h"

#include <cmath>
#include <gtest/gtest.h>

namespace tractus::view {

namespace {

InkLine line_through(std::vector<InkLine::Point> points)
{
    return { std::move(points), tools::InkStyle::Look::Line };
}

InkLine::Point point(float x, float y, float width_mm = 1)
{
    return { { x, y, 0 }, width_mm };
}

// Returns the distance of a point, in position and width, from the nearest part of a line.
double distance_mm(InkLine::Point const& from, InkLine const& line)
{
    auto const dot = [](InkLine::Point const& of) {
        return Eigen::Vector4d(of.position_mm.x(), of.position_mm.y(), of.position_mm.z(),
                               of.width_mm);
    };
    double nearest_mm = 1e9;
    for (std::size_t i = 1; i < line.points.size(); ++i) {
        auto const start = dot(line.points[i - 1]);
        Eigen::Vector4d const way = dot(line.points[i]) - start;
        Eigen::Vector4d const to_point = dot(from) - start;
        double const share = std::clamp(to_point.dot(way) / way.squaredNorm(), 0.0, 1.0);
        nearest_mm = std::min(nearest_mm, (to_point - share * way).norm());
    }
    return nearest_mm;
}

TEST(InkLine, OfAStraightStrokeTheEndsStay)
{
    InkLine line;
    for (int i = 0; i <= 100; ++i)
        line.points.push_back(point(0.3f * static_cast<float>(i), 7));
    auto const thin = thinned(line);
    ASSERT_EQ(thin.points.size(), 2u);
    EXPECT_EQ(thin.points.back().position_mm.x(), line.points.back().position_mm.x());
}

TEST(InkLine, ThinnedItIsWhereItWasWithFewerPoints)
{
    InkLine curl;
    curl.look = tools::InkStyle::Look::Arrow;
    for (int i = 0; i <= 600; ++i) {
        float const turn = 0.02f * static_cast<float>(i);
        curl.points.push_back({ { 30 * std::cos(turn), 30 * std::sin(turn), 0.5f * turn },
                                2 + std::sin(0.5f * turn) });
    }
    auto const thin = thinned(curl);
    EXPECT_EQ(thin.look, curl.look);
    EXPECT_LT(thin.points.size(), curl.points.size() / 4);
    for (auto const& left_out : curl.points)
        EXPECT_LE(distance_mm(left_out, thin), kThinned_mm + 1e-4);
}

TEST(InkLine, AWidthThatPressureChangesStays)
{
    auto const thin = thinned(
        line_through({ point(0, 0), point(1, 0), point(2, 0, 3), point(3, 0), point(4, 0) }));
    EXPECT_EQ(thin.points.size(), 5u);
}

TEST(InkLine, OneThatEndsWhereItBeganKeepsItsShape)
{
    auto const thin = thinned(
        line_through({ point(0, 0), point(5, 0), point(5, 5), point(0, 5), point(0, 0) }));
    EXPECT_EQ(thin.points.size(), 5u);
}

TEST(InkLine, DotsStay)
{
    EXPECT_TRUE(thinned({}).points.empty());
    EXPECT_EQ(thinned(line_through({ point(1, 1) })).points.size(), 1u);
    EXPECT_EQ(thinned(line_through({ point(1, 1), point(1, 1), point(1, 1) })).points.size(), 2u);
}

// The pen leans far to the right and draws away from the user.
TEST(InkLine, IsBroadAcrossTheLeanOfAPencilsSide)
{
    std::vector<TipSample> tips(5);
    for (std::size_t i = 0; i < tips.size(); ++i) {
        tips[i].position_mm = Vec3(0, 5 * static_cast<double>(i), 100);
        tips[i].pressure = 1;
        tips[i].tilt_rad = Vec2(radians(65), 0);
    }
    EXPECT_FLOAT_EQ(ink_line(tips, {}).points[2].width_mm, 3.5f);
    EXPECT_FLOAT_EQ(ink_line(tips, {}, Nib::Side).points[2].width_mm, 4 * 3.5f);
}

} // namespace

} // namespace tractus::view
