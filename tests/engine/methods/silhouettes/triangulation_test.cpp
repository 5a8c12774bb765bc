#include "tests/engine/methods/silhouettes/outlines.h"

#include "engine/methods/silhouettes/chordal_axis.h"
#include "engine/methods/silhouettes/loops.h"

#include <limits>

// Tests of the laws of a constrained Delaunay triangulation without additional points.

namespace tractus::silhouette {
namespace {

double area_of(ChordalAxis const& axis, Triangle const& triangle)
{
    auto const& p = axis.outline();
    auto const& c = triangle.corner;
    return cross(p[c[1]] - p[c[0]], p[c[2]] - p[c[0]]) / 2;
}

// Returns the worst violation of the Delaunay condition, as the determinant of in_circle().
double worst_circle(ChordalAxis const& axis)
{
    double worst = -std::numeric_limits<double>::infinity();
    auto const& p = axis.outline();
    for (std::uint32_t k = 0; k < axis.triangles().size(); ++k)
        for (std::uint32_t e = 0; e < 3; ++e) {
            auto const& triangle = axis.triangles()[k];
            if (triangle.beyond[e] == kNoTriangle)
                continue;
            auto const back = axis.reversed({ k, e });
            auto const& other = axis.triangles()[back.triangle];
            EXPECT_EQ(other.beyond[back.edge], k);
            EXPECT_EQ(axis.beyond(back).first, axis.beyond({ k, e }).last);
            worst
                = std::max(worst,
                           in_circle(p[triangle.corner[0]], p[triangle.corner[1]],
                                     p[triangle.corner[2]], p[other.corner[(back.edge + 2) % 3]]));
        }
    return worst;
}

void expect_identities(std::vector<Vec2> const& outline, std::string const& name)
{
    ChordalAxis const axis(outline);
    auto const n = outline.size();
    auto const counts = axis.counts();
    ASSERT_EQ(axis.triangles().size(), n - 2) << name;
    EXPECT_EQ(counts.terminal + counts.sleeve + counts.junction, n - 2) << name;
    EXPECT_EQ(counts.terminal, counts.junction + 2) << name;
    EXPECT_EQ(2 * counts.terminal + counts.sleeve, n) << name;
    double sum = 0;
    for (auto const& triangle : axis.triangles()) {
        sum += area_of(axis, triangle);
        EXPECT_GT(area_of(axis, triangle), -1e-12) << name;
    }
    EXPECT_NEAR(sum, signed_area(outline), 1e-9 * sum) << name;
    double const size = (box_of(outline).high - box_of(outline).low).maxCoeff();
    EXPECT_LE(worst_circle(axis), 1e-9 * std::pow(size, 4)) << name;
    for (std::uint32_t k = 0; k < axis.triangles().size(); ++k) {
        for (std::uint32_t e = 0; axis.chord_count(k) == 3 && e < 3; ++e)
            EXPECT_GT(axis.rise({ k, e }), -1e-6 * size) << name;
    }
}

TEST(SilhouetteTriangulation, CutsASquareAndAnArrow)
{
    auto const square
        = triangulate(std::vector<Vec2> { Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1) });
    ASSERT_EQ(square.size(), 2U);
    // In this arrow, only the diagonal from the notch to the tip is inside.
    auto const arrow
        = triangulate(std::vector<Vec2> { Vec2(0, 0), Vec2(4, 0), Vec2(1, 1), Vec2(0, 4) });
    ASSERT_EQ(arrow.size(), 2U);
    for (auto const& triangle : arrow) {
        EXPECT_NE(std::find(triangle.corner.begin(), triangle.corner.end(), 0U),
                  triangle.corner.end());
        EXPECT_NE(std::find(triangle.corner.begin(), triangle.corner.end(), 2U),
                  triangle.corner.end());
    }
}

TEST(SilhouetteTriangulation, TakesTheShorterDiagonalOfALozenge)
{
    auto const lozenge
        = triangulate(std::vector<Vec2> { Vec2(-3, 0), Vec2(0, -1), Vec2(3, 0), Vec2(0, 1) });
    for (auto const& triangle : lozenge) {
        EXPECT_NE(std::find(triangle.corner.begin(), triangle.corner.end(), 1U),
                  triangle.corner.end());
        EXPECT_NE(std::find(triangle.corner.begin(), triangle.corner.end(), 3U),
                  triangle.corner.end());
    }
}

TEST(SilhouetteTriangulation, IdentitiesHoldForDrawnOutlines)
{
    for (std::size_t const samples : { 16U, 100U, 256U, 512U }) {
        OutlineOptions const options { .samples = samples };
        expect_identities(cleaned(star(7, 40, 100), options).outline, "star");
        expect_identities(cleaned(ellipse(30, 90), options).outline, "ellipse");
        expect_identities(cleaned(lobed_crown(9), options).outline, "crown");
    }
}

TEST(SilhouetteTriangulation, IdentitiesHoldForTenThousandScribbles)
{
    int taken = 0;
    for (std::uint32_t i = 0; i < 10'000; ++i) {
        // Most cases have few samples, since an outline of 256 samples takes a thousand times as
        // long as one of 32.
        std::size_t const samples = i % 100 == 0 ? 256 : 24 + i % 72;
        auto const clean = clean_drawing(scribble(i), { .samples = samples });
        if (!clean) // The scribble has only a loop that is too small.
            continue;
        ++taken;
        ASSERT_FALSE(crosses_itself(clean->outline)) << i;
        expect_identities(clean->outline, "scribble " + std::to_string(i));
        if (HasFailure())
            return;
    }
    EXPECT_GT(taken, 9'000);
}

TEST(SilhouetteTriangulationCorpus, IdentitiesHoldForThePublishedOutlines)
{
    REQUIRE_CORPUS();
    for (auto const& [name, drawing, expected] : published_outlines()) {
        auto const outline = cleaned(drawing).outline;
        expect_identities(outline, name);
        EXPECT_EQ(outline.size(), expected["samples"].get<std::size_t>()) << name;
        EXPECT_EQ(ChordalAxis(outline).triangles().size(), expected["triangles"]) << name;
    }
}

} // namespace
} // namespace tractus::silhouette
