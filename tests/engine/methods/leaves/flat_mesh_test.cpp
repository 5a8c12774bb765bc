#include "engine/base/random.h"
#include "engine/methods/leaves/flat_geometry.h"
#include "engine/methods/leaves/flat_mesh.h"

#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <vector>

namespace tractus::leaf {
namespace {

using Ring = std::vector<Vec2>;

// Rays of changing length around a point; negative steps go clockwise.
Ring star_ring(Vec2 const& at, int count, double radius, double depth, int direction = 1)
{
    Ring made;
    for (int i = 0; i < count; ++i) {
        double const angle = direction * 2 * kPi * i / count;
        double const length = radius * (i % 2 == 0 ? 1 : 1 - depth);
        made.emplace_back(at + length * Vec2(std::cos(angle), std::sin(angle)));
    }
    return made;
}

double ring_area(Ring const& ring)
{
    double sum = 0;
    for (std::size_t i = 0; i < ring.size(); ++i)
        sum += cross(ring[i], ring[(i + 1) % ring.size()]) / 2;
    return sum;
}

// Checks that the triangles are counter-clockwise, have the area of the contours and share each
// inner edge between two of them.
void expect_whole(FlatMesh const& mesh, std::vector<Ring> const& rings)
{
    double wanted = 0;
    for (auto const& ring : rings)
        wanted += ring_area(ring);
    double area = 0;
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (auto const& triangle : mesh.triangles()) {
        double const twice = turn(mesh.points()[triangle[0]], mesh.points()[triangle[1]],
                                  mesh.points()[triangle[2]]);
        EXPECT_GT(twice, 0);
        area += twice / 2;
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_EQ(++edges[std::pair(triangle[k], triangle[(k + 1) % 3])], 1);
    }
    EXPECT_NEAR(area, wanted, 1e-9 * std::abs(wanted));
    std::size_t border = 0;
    for (auto const& [ends, count] : edges)
        border += edges.contains({ ends.second, ends.first }) ? 0 : 1;
    std::size_t sides = 0;
    for (auto const& ring : rings)
        sides += ring.size();
    EXPECT_EQ(border, sides);
}

TEST(FlatMesh, FillsContoursWithHoles)
{
    std::vector<Ring> const rings { star_ring({ 0, 0 }, 40, 100, 0.3),
                                    star_ring({ 30, 10 }, 12, 15, 0.4, -1),
                                    star_ring({ -30, -20 }, 20, 20, 0.2, -1),
                                    star_ring({ 300, 0 }, 10, 50, 0.5) };
    expect_whole(FlatMesh(rings), rings);
}

TEST(FlatMesh, TakesPointsAndLines)
{
    std::vector<Ring> const rings { star_ring({ 0, 0 }, 30, 100, 0.25) };
    Random random({ .seed = 3, .stream = 1 });
    FlatMesh mesh(rings);
    for (int i = 0; i < 60; ++i)
        mesh.add_point({ 140 * random.uniform() - 70, 140 * random.uniform() - 70 });
    expect_whole(mesh, rings);
    std::vector<FlatMesh::Corner> line;
    for (int i = 0; i <= 6; ++i)
        if (auto const point = mesh.add_point({ -60.0 + 20 * i, 0.1 * i }))
            line.push_back(*point);
    ASSERT_EQ(line.size(), 7u);
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
        EXPECT_TRUE(mesh.add_line(line[i], line[i + 1])) << i;
    for (int i = 0; i < 20; ++i)
        mesh.add_point({ 120 * random.uniform() - 60, 120 * random.uniform() - 60 });
    expect_whole(mesh, rings);
    // The lines are edges still.
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        bool is_there = false;
        for (auto const& triangle : mesh.triangles())
            for (std::size_t k = 0; k < 3; ++k)
                is_there |= triangle[k] == line[i] && triangle[(k + 1) % 3] == line[i + 1];
        EXPECT_TRUE(is_there) << i;
    }
}

TEST(FlatMesh, TakesNoPointsOutside)
{
    std::vector<Ring> const rings { star_ring({ 0, 0 }, 30, 100, 0),
                                    star_ring({ 0, 0 }, 10, 20, 0, -1) };
    FlatMesh mesh(rings);
    EXPECT_FALSE(mesh.add_point({ 0, 1 }));
    EXPECT_FALSE(mesh.add_point({ 200, 1 }));
    EXPECT_FALSE(mesh.add_point(mesh.points()[3]));
    EXPECT_TRUE(mesh.add_point({ 50, 1 }));
    expect_whole(mesh, rings);
}

} // namespace
} // namespace tractus::leaf
