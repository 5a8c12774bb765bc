#include "engine/methods/silhouettes/drawn_surface.h"

#include "engine/methods/silhouettes/crown_surface.h"
#include "engine/methods/silhouettes/monotone_curve.h"
#include "engine/methods/silhouettes/tree.h"
#include "tests/engine/methods/silhouettes/crown_lines.h"
#include "tests/engine/methods/silhouettes/outlines.h"

#include <cmath>
#include <map>

namespace tractus::silhouette {
namespace {

using namespace crown_lines;

CrownSurface surface_of(std::vector<CrownLine> const& lines, Drawing drawing = {})
{
    auto const added = add_surface(drawing, lines, Vec2(0, 0));
    EXPECT_TRUE(added) << added.error().message;
    return { drawing.surface, drawing.trunk };
}

std::string refused_lines(std::vector<CrownLine> const& lines, Drawing drawing = {})
{
    auto const added = add_surface(drawing, lines, Vec2(0, 0));
    return added ? "it is taken" : added.error().message;
}

double reach(CrownSurface const& surface, double theta_deg, double height)
{
    auto const reach = surface.reach(theta_deg, height);
    EXPECT_TRUE(reach) << "at " << theta_deg << " degrees, " << height;
    return reach.value_or(-1);
}

// Returns the distance from the centre of an ellipse to its edge, in the direction theta.
double radius_of_ellipse(double a, double b, double theta_deg)
{
    return a * b / std::hypot(b * std::cos(radians(theta_deg)), a * std::sin(radians(theta_deg)));
}

TEST(MonotoneCurve, GoesStraightThroughALineAndOverNoPeak)
{
    MonotoneCurve const line({ { 0, 1 }, { 1, 3 }, { 5, 11 } });
    for (double const x : { -1.0, 0.0, 0.3, 2.0, 5.0, 7.0 })
        EXPECT_NEAR(line.at(x), 1 + 2 * x, 1e-12) << x;
    MonotoneCurve const hill({ { 0, 0 }, { 1, 4 }, { 2, 4.1 }, { 4, 1 } });
    for (double x = 0; x <= 4; x += 0.05) {
        EXPECT_LE(hill.at(x), 4.1 + 1e-12) << x;
        EXPECT_GE(hill.at(x), -1e-12) << x;
    }
    EXPECT_EQ(MonotoneCurve({ { 2, 5 } }).at(9), 5);
}

TEST(CrownLine, IsKnownByItsShape)
{
    EXPECT_EQ(kind_of(ring(40, 25, 60)).value(), CrownLineKind::Ring);
    EXPECT_EQ(kind_of(ring(40, 6, 60)).value(), CrownLineKind::Ring);
    // A line that is not quite closed is also a ring.
    EXPECT_EQ(kind_of(ring(40, 40, 60, 0.85)).value(), CrownLineKind::Ring);
    EXPECT_EQ(kind_of(ring(40, 40, 60, 1.2)).value(),
              CrownLineKind::Ring); // A line that continues beyond its beginning is also a ring.
    EXPECT_EQ(kind_of(cone_climb(4)).value(), CrownLineKind::Climb);
    EXPECT_EQ(kind_of(cone_climb(1.4)).value(), CrownLineKind::Climb);
    for (double const azimuth : { 0.0, 35.0, 90.0, 150.0 }) {
        auto const line = side(azimuth, 30, 50, 80);
        EXPECT_EQ(kind_of(line).value(), CrownLineKind::Side) << azimuth;
        EXPECT_NEAR(azimuth_deg(line), azimuth, 1e-6);
    }
    EXPECT_FALSE(kind_of({ { 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 } }));
    EXPECT_FALSE(kind_of({ { 0, 0, 0 }, { 10, 20, 3 }, { 20, 40, 5 }, { 30, 60, 9 } }));
    EXPECT_FALSE(kind_of({ { 0, 0, 0 }, { 1, std::nan(""), 3 }, { 2, 4, 5 }, { 3, 6, 9 } }));
}

TEST(CrownLine, TakesThePlaceOfOneThatLiesWhereItDoes)
{
    EXPECT_TRUE(takes_place_of(ring(40, 25, 60), ring(30, 30, 63)));
    EXPECT_FALSE(takes_place_of(ring(40, 25, 60), ring(40, 25, 65)));
    EXPECT_FALSE(takes_place_of(ring(40, 25, 60), cone_climb(4)));
    EXPECT_TRUE(takes_place_of(cone_climb(3), cone_climb(4)));
    EXPECT_TRUE(takes_place_of(side(175, 30, 50, 80), side(3, 30, 50, 80)));
    EXPECT_FALSE(takes_place_of(side(90, 30, 50, 80), side(75, 30, 50, 80)));
}

// At each height between the rings, the section must be the given ellipse.
TEST(DrawnSurface, RingsOfAnEllipseGiveItBack)
{
    for (auto const& [a, b] : { std::pair(40.0, 25.0), std::pair(20.0, 60.0) }) {
        std::vector<CrownLine> rings;
        for (double const height : { 40.0, 60.0, 80.0, 100.0 })
            rings.push_back(ring(a, b, height));
        auto const surface = surface_of(rings);
        for (double theta = 0; theta < 360; theta += 7)
            for (double height = 42; height < 100; height += 9) {
                double const radius = radius_of_ellipse(a, b, theta);
                EXPECT_NEAR(reach(surface, theta, height), radius, 0.01 * radius)
                    << theta << ", " << height;
            }
    }
}

// Rings alone must give back the ellipsoid, including its closed top and bottom.
TEST(DrawnSurface, RingsOfAnEllipsoidCloseAsItDoes)
{
    std::vector<CrownLine> rings;
    for (double const up : { -0.8, -0.4, 0.0, 0.4, 0.8 })
        rings.push_back(
            ring(40 * std::sqrt(1 - up * up), 25 * std::sqrt(1 - up * up), 80 + 50 * up));
    auto const surface = surface_of(rings);
    for (double theta = 0; theta < 360; theta += 15)
        for (double const up : { -0.9, -0.6, 0.2, 0.6, 0.9 }) {
            double const radius = radius_of_ellipse(40, 25, theta) * std::sqrt(1 - up * up);
            EXPECT_NEAR(reach(surface, theta, 80 + 50 * up), radius, 0.03 * 40)
                << theta << ", " << up;
        }
    EXPECT_NEAR(surface.heights(0).y(), 130, 1.5);
    EXPECT_NEAR(surface.heights(0).x(), 30, 1.5);
}

TEST(DrawnSurface, AClimbOnAConeGivesTheCone)
{
    auto const surface = surface_of({ cone_climb(5) });
    for (double theta = 0; theta < 360; theta += 11)
        for (double height = 32; height < 119; height += 8)
            EXPECT_NEAR(reach(surface, theta, height), cone_radius(height), 0.01 * 40)
                << theta << ", " << height;
    EXPECT_NEAR(surface.heights(90).y(), 120, 2);
}

// The second outline is seen from the side. It gives the other half-axis of the elliptic sections.
TEST(DrawnSurface, TwoOutlinesGiveTheEllipsesBetweenThem)
{
    auto const surface = surface_of({ side(0, 40, 50, 80), side(90, 25, 50, 80) });
    for (double theta = 0; theta < 360; theta += 9)
        for (double const up : { -0.7, 0.0, 0.5 }) {
            double const radius = radius_of_ellipse(40, 25, theta) * std::sqrt(1 - up * up);
            EXPECT_NEAR(reach(surface, theta, 80 + 50 * up), radius, 0.02 * radius)
                << theta << ", " << up;
        }
}

// In the sheet, the outline must determine the surface; across the sheet, the rings must determine
// it.
TEST(DrawnSurface, AnOutlineCountsInItsPlaneWhereRingsDisagree)
{
    auto drawing = ellipse(40, 50);
    drawing.trunk = { Vec2(0, -60), Vec2(0, 35) };
    std::vector<CrownLine> rings;
    for (double const height : { -30.0, 0.0, 30.0 })
        rings.push_back(ring(20, 20, height));
    auto const surface = surface_of(rings, drawing);
    EXPECT_NEAR(reach(surface, 0, 60), 40, 0.4);
    EXPECT_NEAR(reach(surface, 180, 60), 40, 0.4);
    EXPECT_NEAR(reach(surface, 90, 60), 20, 0.2);
    EXPECT_NEAR(reach(surface, 270, 60), 20, 0.2);
    EXPECT_NEAR(surface.heights(90).y(), 110, 1);
}

TEST(DrawnSurface, IsMovedAndScaledWithItsLines)
{
    std::vector<CrownLine> rings { ring(40, 25, 60), ring(30, 28, 80), ring(12, 9, 95) };
    auto const surface = surface_of(rings);
    Drawing moved;
    for (auto& line : rings)
        for (auto& point : line)
            point = 3 * point + Vec3(17, -20, 0);
    ASSERT_TRUE(add_surface(moved, rings, Vec2(17, -20)));
    CrownSurface const other(moved.surface, moved.trunk);
    for (double theta = 0; theta < 360; theta += 30)
        for (double const height : { 55.0, 70.0, 90.0 })
            EXPECT_NEAR(reach(other, theta, 3 * height), 3 * reach(surface, theta, height), 1e-6);
}

TEST(DrawnSurface, RefusesLinesBesideTheTrunk)
{
    auto beside = ring(20, 20, 60);
    for (auto& point : beside)
        point.x() += 70;
    Drawing drawing;
    drawing.trunk = upright(0, 80);
    EXPECT_NE(
        refused_lines({ beside }, drawing).find("the ring at 60 mm does not go around the trunk"),
        std::string::npos)
        << refused_lines({ beside }, drawing);
    auto outline = side(90, 30, 50, 80);
    for (auto& point : outline)
        point.z() += 70;
    EXPECT_NE(refused_lines({ outline }, drawing).find("beside the trunk"), std::string::npos);
}

// How far the trunk's branches and the foliage reach, as shares of the surface's radius in the same
// direction.
struct Reaches {
    double farthest = 0;
    double on_average = 0; // Mean reach of the branches' ends.
    double outside = 0;    // Share of the twigs whose positions are outside of the surface.
};

Reaches reaches_of(Drawing const& drawing)
{
    auto const skeleton = infer_skeleton(drawing).value();
    auto const tree = make_tree(skeleton);
    check_plant(tree.plant);
    CrownSurface const surface(skeleton.surface, skeleton.systems[0].trunk);
    double const unit = drawn_height(skeleton) / 8000;
    auto const share_at = [&](Vec3 const& place_mm) {
        double const theta_deg = degrees(std::atan2(place_mm.y(), place_mm.x()));
        auto const reach = surface.reach(theta_deg, unit * place_mm.z());
        return unit * place_mm.head<2>().norm() / std::max(reach.value_or(0), 1.0);
    };
    Reaches result;
    double count = 0;
    for (auto const& axis : tree.plant.axes) {
        if (axis.order != 1)
            continue;
        auto const last = axis.first_node + axis.segment_count;
        double const share = share_at(tree.plant.node_position_mm[last]);
        result.farthest = std::max(result.farthest, share);
        result.on_average += share;
        count += 1;
    }
    result.on_average /= count;
    for (auto const& organ : tree.plant.organs)
        result.outside += share_at(organ.position_mm) > 1.05;
    result.outside /= static_cast<double>(tree.plant.organs.size());
    return result;
}

TEST(DrawnSurface, BranchesAndFoliageFollowIt)
{
    for (auto const& [a, b] :
         { std::pair(40.0, 40.0), std::pair(45.0, 20.0), std::pair(20.0, 45.0) }) {
        Drawing drawing;
        std::vector<CrownLine> rings;
        for (double const up : { -0.8, -0.4, 0.0, 0.4, 0.8 })
            rings.push_back(
                ring(a * std::sqrt(1 - up * up), b * std::sqrt(1 - up * up), 80 + 50 * up));
        ASSERT_TRUE(add_surface(drawing, rings, Vec2(0, 0)));
        auto const reaches = reaches_of(drawing);
        EXPECT_GT(reaches.on_average, 0.6) << a << ", " << b;
        EXPECT_LT(reaches.farthest, 1.1) << a << ", " << b;
        EXPECT_LT(reaches.outside, 0.03) << a << ", " << b;
    }
}

// Rings around a round crown must give the same tree as its outline alone.
TEST(DrawnSurface, RingsOfACircleGiveTheTreeOfTheRevolution)
{
    auto const outlined = ellipse(40, 50);
    auto ringed = outlined;
    std::vector<CrownLine> rings;
    for (double const up : { -0.9, -0.6, -0.3, 0.0, 0.3, 0.6, 0.9 })
        rings.push_back(ring(40 * std::sqrt(1 - up * up), 40 * std::sqrt(1 - up * up), 50 * up));
    ASSERT_TRUE(add_surface(ringed, rings, {}));
    auto const one = make_tree(infer_skeleton(outlined).value());
    auto const other = make_tree(infer_skeleton(ringed).value());
    // The trunk's branches must be the same, and have the same ends.
    std::map<std::string, Vec3> ends;
    auto const end_of = [](Tree const& tree, std::size_t axis) {
        auto const& one_axis = tree.plant.axes[axis];
        return tree.plant.node_position_mm[one_axis.first_node + one_axis.segment_count];
    };
    std::size_t on_trunk = 0;
    for (std::size_t i = 0; i < one.plant.axes.size(); ++i)
        if (one.plant.axes[i].order == 1) {
            ends[one.axis_names[i]] = end_of(one, i);
            ++on_trunk;
        }
    std::size_t again = 0;
    double sum = 0;
    for (std::size_t i = 0; i < other.plant.axes.size(); ++i)
        if (other.plant.axes[i].order == 1 && ends.contains(other.axis_names[i])) {
            ++again;
            sum += (end_of(other, i) - ends[other.axis_names[i]]).norm();
        }
    EXPECT_GE(again, on_trunk - 2);
    EXPECT_LT(sum / static_cast<double>(again), 0.01 * 8000);
}

} // namespace
} // namespace tractus::silhouette
