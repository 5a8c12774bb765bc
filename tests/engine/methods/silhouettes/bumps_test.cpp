#include "tests/engine/methods/silhouettes/outlines.h"

namespace tractus::silhouette {
namespace {

// True if the bumps of the named outline are half circles.
bool is_circular(std::string const& name)
{
    return name == "circle" || name == "pear";
}

char const* name_of(Role role)
{
    return role == Role::Foot ? "foot" : role == Role::Apex ? "apex" : "lateral";
}

TEST(SilhouetteBumps, AStarHasOneForEachSpike)
{
    for (int const spikes : { 4, 5, 8, 13 }) {
        auto const clean = cleaned(star(spikes, spikes > 10 ? 70 : 40, 100));
        auto const bumps = bumps_of(clean);
        ASSERT_EQ(bumps.size(), static_cast<std::size_t>(spikes));
        int apexes = 0;
        for (auto const& bump : bumps) {
            // The end of the spike's branch is near the tip of the spike, and the branch arrives
            // there along the spike.
            Vec2 const tip = clean.to_sheet.point(bump.tip);
            EXPECT_NEAR(tip.norm(), 99, 2);
            EXPECT_GT(direction_of(clean.to_sheet.vector(bump.tangent)).dot(direction_of(tip)),
                      0.99);
            apexes += bump.role == Role::Apex;
        }
        EXPECT_EQ(apexes, 1);
    }
}

TEST(SilhouetteBumps, ARoundLobesEndIsAboutItsCentre)
{
    auto const clean = cleaned(lobed_crown(7));
    auto const bumps = bumps_of(clean);
    ASSERT_EQ(bumps.size(), 7U);
    for (auto const& bump : bumps) {
        EXPECT_NEAR(clean.to_sheet.point(bump.end).norm(), 62, 5);
        EXPECT_NEAR(bump.radius * clean.to_sheet.turn.norm(),
                    1.12 * 62 * std::sin(radians(230. / 12)), 3);
    }
}

TEST(SilhouetteBumps, AnEllipseHasTwoEnds)
{
    auto const bumps = bumps_of(cleaned(ellipse(45, 90)));
    ASSERT_EQ(bumps.size(), 2U);
    EXPECT_TRUE((bumps[0].role == Role::Apex && bumps[1].role == Role::Foot)
                || (bumps[1].role == Role::Apex && bumps[0].role == Role::Foot));
}

TEST(SilhouetteBumps, TwoLobesBesideTheTrunksEndAreAFork)
{
    auto const bumps = bumps_of(cleaned(lobed_crown(6, 0, 180)));
    ASSERT_EQ(bumps.size(), 6U);
    for (auto const& bump : bumps)
        EXPECT_EQ(bump.role, Role::Lateral);
}

TEST(SilhouetteBumps, ATrunkOutsideHasNoRun)
{
    auto drawing = ellipse(45, 90);
    drawing.trunk = { Vec2(100, 0), Vec2(100, 50) };
    auto const clean = cleaned(drawing);
    EXPECT_FALSE(inside_run(clean.outline, clean.trunk));
}

TEST(SilhouetteBumps, TheLongestRunInsideCounts)
{
    std::vector<Vec2> const outline { Vec2(0, 0), Vec2(10, 0), Vec2(10, 10), Vec2(0, 10) };
    std::vector<Vec2> const trunk { Vec2(5, 1),  Vec2(12, 2), Vec2(5, 3), Vec2(5, 4),
                                    Vec2(12, 5), Vec2(5, 6),  Vec2(5, 7) };
    auto const run = inside_run(outline, trunk);
    ASSERT_TRUE(run);
    EXPECT_EQ(run->first, 2U);
    EXPECT_EQ(run->last, 3U);
}

// A drawing that is moved, rotated and scaled with its trunk must have the same bumps, transformed
// in the same way.
TEST(SilhouetteBumps, FollowTheDrawing)
{
    for (auto const& drawing : { star(8, 45, 100), lobed_crown(9), ellipse(45, 90) }) {
        auto const clean = cleaned(drawing);
        auto const bumps = bumps_of(clean);
        for (auto const& way : { Similarity { .to = Vec2(123.4, -56.7) },
                                 Similarity { .turn = Vec2(std::cos(1), std::sin(1)) },
                                 Similarity { .to = Vec2(1, 2), .turn = Vec2(-7.5, 3) } }) {
            auto const other = cleaned(moved(drawing, way));
            auto const others = bumps_of(other);
            ASSERT_EQ(others.size(), bumps.size());
            for (std::size_t i = 0; i < bumps.size(); ++i) {
                Vec2 const wanted = way.point(clean.to_sheet.point(bumps[i].end));
                EXPECT_LT((other.to_sheet.point(others[i].end) - wanted).norm(),
                          1e-6 * other.to_sheet.turn.norm());
                EXPECT_NEAR(others[i].radius, bumps[i].radius, 1e-6);
                EXPECT_EQ(others[i].role, bumps[i].role);
            }
        }
    }
}

// Expects each bump to have a counterpart in the mirrored drawing, to within half a percent of the
// diagonal.
void expect_mirrored(Drawing const& drawing, std::string const& name)
{
    auto const clean = cleaned(drawing);
    auto const bumps = bumps_of(clean);
    Similarity const mirror { .turn = Vec2(-1, 0), .mirrors = true };
    auto const other = cleaned(moved(drawing, mirror));
    auto const others = bumps_of(other);
    ASSERT_EQ(others.size(), bumps.size()) << name;
    for (auto const& bump : bumps) {
        Vec2 const wanted = mirror.point(clean.to_sheet.point(bump.end));
        auto const nearest
            = std::min_element(others.begin(), others.end(), [&](Bump const& a, Bump const& b) {
                  return (other.to_sheet.point(a.end) - wanted).norm()
                      < (other.to_sheet.point(b.end) - wanted).norm();
              });
        EXPECT_LT((other.to_sheet.point(nearest->end) - wanted).norm(),
                  0.005 * other.to_sheet.turn.norm())
            << name;
        EXPECT_EQ(nearest->role, bump.role) << name;
    }
}

TEST(SilhouetteBumps, AMirroredDrawingHasMirroredBumps)
{
    auto crooked = lobed_crown(9, -40, 190);
    crooked.trunk = { Vec2(4, -95), Vec2(-3, -20), Vec2(6, 45) };
    expect_mirrored(crooked, "crooked");
    expect_mirrored(star(9, 50, 100), "star");
}

TEST(SilhouetteBumpsCorpus, CountsAndRolesAreThoseOfThePublishedOutlines)
{
    REQUIRE_CORPUS();
    for (auto const& [name, drawing, expected] : published_outlines()) {
        auto const clean = cleaned(drawing);
        auto const bumps = bumps_of(clean);
        auto const& wanted = expected["bump"];
        ASSERT_EQ(bumps.size(), wanted.size()) << name;
        double const close = 0.02 * clean.to_sheet.turn.norm();
        for (auto const& bump : wanted) {
            auto const end = point_in(bump["end"]);
            auto const nearest
                = std::min_element(bumps.begin(), bumps.end(), [&](Bump const& a, Bump const& b) {
                      return (clean.to_sheet.point(a.end) - end).norm()
                          < (clean.to_sheet.point(b.end) - end).norm();
                  });
            if (is_circular(name))
                // On a circle, the position of a bump's end depends on the positions of the
                // samples.
                continue;
            EXPECT_LT((clean.to_sheet.point(nearest->end) - end).norm(), close) << name << bump;
            EXPECT_LT((clean.to_sheet.point(nearest->tip) - point_in(bump["tip"])).norm(), close)
                << name << bump;
            EXPECT_NEAR(nearest->radius * clean.to_sheet.turn.norm(), bump["radius"].get<double>(),
                        close)
                << name;
            EXPECT_EQ(name_of(nearest->role), bump["role"]) << name << bump;
        }
        auto roles = [&](char const* role) {
            return std::count_if(wanted.begin(), wanted.end(),
                                 [&](auto const& bump) { return bump["role"] == role; });
        };
        for (auto const role : { Role::Foot, Role::Apex, Role::Lateral })
            EXPECT_EQ(std::count_if(bumps.begin(), bumps.end(),
                                    [&](Bump const& bump) { return bump.role == role; }),
                      roles(name_of(role)))
                << name << " " << name_of(role);
        if (!is_circular(name))
            expect_mirrored(drawing, name);
    }
}

} // namespace
} // namespace tractus::silhouette
