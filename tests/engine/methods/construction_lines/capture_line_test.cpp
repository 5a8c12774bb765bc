#include "engine/methods/construction_lines/capture_line.h"

#include "engine/stroke/polyline.h"
#include "engine/stroke/resample.h"
#include "tests/engine/methods/construction_lines/sketches.h"

namespace tractus::lines {
namespace {

TEST(CaptureLine, KeepsEndsAndAStraightLine)
{
    auto const line = capture_line(std::vector<Vec3> { Vec3(1, 2, 3), Vec3(1, 202, 3) });
    EXPECT_NEAR((line.front() - Vec3(1, 2, 3)).norm(), 0, 1e-9);
    EXPECT_NEAR((line.back() - Vec3(1, 202, 3)).norm(), 0, 1e-9);
    EXPECT_NEAR(polyline_length_mm(line), 200, 1e-9);
    EXPECT_NEAR(static_cast<double>(line.size()), 400, 10);
}

TEST(CaptureLine, TakesTremorOutOfALine)
{
    std::vector<Vec3> tips;
    for (int i = 0; i <= 400; ++i)
        tips.emplace_back(0.4 * std::sin(i * 1.9), i / 2.0, 0);
    double farthest_mm = 0;
    for (auto const& point : capture_line(tips))
        if (point.y() > 10 && point.y() < 190) // Only the ends must stay as they were drawn.
            farthest_mm = std::max(farthest_mm, std::fabs(point.x()));
    EXPECT_LT(farthest_mm, 0.25);
}

TEST(CaptureLine, TakesADotAndAnEndlessLine)
{
    EXPECT_EQ(capture_line(std::vector<Vec3> { Vec3(0, 0, 0), Vec3(0, 1e-3, 0) }).size(), 10U);
    EXPECT_LT(capture_line(std::vector<Vec3> { Vec3(0, 0, 0), Vec3(0, 1e5, 0) }).size(), 8'001U);
}

// Returns the points that a pen reports at the given rate while a trembling hand accelerates, moves
// and stops.
std::vector<Vec3> drawn(std::vector<Vec2> const& corners, double rate_hz)
{
    constexpr double kDuration_s = 1.5;
    std::vector<Vec3> control;
    for (auto const& corner : corners)
        control.emplace_back(corner.x(), corner.y(), 0);
    ArcLength const way(control);
    auto const count = static_cast<int>(std::lround(kDuration_s * rate_hz));
    std::vector<Vec3> tips;
    for (int i = 0; i <= count; ++i) {
        double const share = static_cast<double>(i) / count;
        double const time_s = share * kDuration_s;
        tips.push_back(way.at(share * share * (3 - 2 * share))
                       + 0.15 * Vec3(std::sin(50 * time_s), std::cos(43 * time_s), 0));
    }
    return tips;
}

std::vector<Vec2> flat(std::vector<Vec3> const& points)
{
    std::vector<Vec2> result;
    for (auto const& point : points)
        result.push_back(point.head<2>());
    return result;
}

LineSketch sketch_at(double rate_hz)
{
    auto const line = [&](std::vector<Vec2> const& corners) {
        return flat(capture_line(drawn(corners, rate_hz)));
    };
    auto const stem = capture_line(drawn(flat(arc(160, 70, 300)), rate_hz));
    auto const beside = [](double radius_mm) {
        std::vector<Vec2> points;
        for (int i = -20; i <= 100; ++i)
            points.emplace_back(160 - radius_mm * std::cos(radians(i)),
                                radius_mm * std::sin(radians(i)));
        return points;
    };
    return { .stem = stem,
             .left = line(beside(210)),
             .right = line(beside(120)),
             .inclinations
             = { line({ Vec2(-70, 80), Vec2(75, 20) }), line({ Vec2(-20, 190), Vec2(130, 70) }) },
             .nodes_per_layer = { 8 } };
}

TEST(CaptureLine, FunctionsDoNotDependOnThePensRate)
{
    auto const reference = measured(sketch_at(1000));
    for (double const rate_hz : { 60.0, 90.0, 133.0, 250.0 }) {
        auto const other = measured(sketch_at(rate_hz));
        for (int i = 0; i <= 20; ++i) {
            auto const wanted = values_at(reference, i / 20.0);
            auto const found = values_at(other, i / 20.0);
            EXPECT_NEAR(found.heading_deg, wanted.heading_deg, 0.3) << rate_hz << " " << i;
            EXPECT_NEAR(found.left_deg, wanted.left_deg, 0.3) << rate_hz << " " << i;
            EXPECT_NEAR(found.right_deg, wanted.right_deg, 0.3) << rate_hz << " " << i;
            EXPECT_NEAR(found.left_size, wanted.left_size, 0.002) << rate_hz << " " << i;
            EXPECT_NEAR(found.right_size, wanted.right_size, 0.002) << rate_hz << " " << i;
        }
    }
}

} // namespace
} // namespace tractus::lines
