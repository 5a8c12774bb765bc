#include "engine/methods/construction_lines/around_stem.h"

#include "tests/engine/methods/construction_lines/sketches.h"

// Tests of organs that reach to boundaries around a stem, compared with shapes in closed form.

namespace tractus::lines {
namespace {

constexpr double kAcross_mm = 40; // Half-axis of the cross-section in the sheet.
constexpr double kDeep_mm = 25;   // Half-axis of the cross-section towards the viewer.

double on_ellipse(double azimuth_deg)
{
    double const angle = radians(azimuth_deg);
    return 1 / std::hypot(std::cos(angle) / kAcross_mm, std::sin(angle) / kDeep_mm);
}

// Returns a vertical line on the elliptic cylinder, at the given azimuth around the stem.
std::vector<Vec3> on_cylinder(double azimuth_deg)
{
    double const far_mm = on_ellipse(azimuth_deg);
    double const angle = radians(azimuth_deg);
    Vec3 const out = far_mm * Vec3(-std::cos(angle), 0, -std::sin(angle));
    return { out + Vec3(0, -20, 0), out + Vec3(0, 350, 0) };
}

LineSketch upright(std::vector<double> const& azimuths_deg)
{
    LineSketch sketch { .stem = { Vec3(0, 0, 0), Vec3(0, 200, 0) },
                        .left = {},
                        .right = {},
                        .inclinations = { { Vec2(-60, 75), Vec2(0, 40), Vec2(60, 75) },
                                          { Vec2(-60, 195), Vec2(0, 160), Vec2(60, 195) } },
                        .nodes_per_layer = { 12 } };
    for (auto const azimuth_deg : azimuths_deg)
        sketch.around.push_back(on_cylinder(azimuth_deg));
    return sketch;
}

TEST(AroundStem, FourBoundariesGiveAnEllipticCrossSectionBack)
{
    auto const construction = measured(upright({ 0, 90, 180, 270 }));
    ASSERT_EQ(construction.around.size(), 4U);
    for (std::size_t node = 0; node < construction.nodes.size(); ++node) {
        double const sine = std::sin(radians(construction.nodes[node].left_deg));
        for (int t = 0; t < 360; t += 3)
            EXPECT_NEAR(size_at(construction, node, t) * 200 * sine, on_ellipse(t), 1e-6) << t;
    }
}

// In the plant made from the text of the model, the tip of each organ must lie on the cylinder.
TEST(AroundStem, OrgansOfTheModelReachTheEllipticCylinder)
{
    for (auto const kind : { Pattern::Kind::Distichous, Pattern::Kind::Decussate,
                             Pattern::Kind::Spiral, Pattern::Kind::Whorled }) {
        auto const tips = tips_of(upright({ 0, 90, 180, 270 }), { .kind = kind, .whorl = 5 });
        EXPECT_GE(tips.size(), 13U);
        for (auto const& tip : tips)
            EXPECT_NEAR(std::hypot(tip.x() / kAcross_mm, tip.z() / kDeep_mm), 1, 0.01)
                << name_of(kind);
    }
}

// Any set of azimuths of boundaries must give back the elliptic cross-section.
TEST(AroundStem, ManyBoundariesGiveAnEllipticCrossSectionBack)
{
    std::vector<std::vector<double>> const azimuths_deg {
        { 0, 30, 60, 90, 120, 150, 180, 210, 240, 270, 300, 330 },
        { 10, 70, 130, 190, 250, 310 },
        { 25, 75, 120, 160, 200, 240, 290, 345 },
    };
    for (auto const& each : azimuths_deg) {
        auto const construction = measured(upright(each));
        double const sine = std::sin(radians(construction.nodes[0].left_deg));
        for (int t = 0; t < 360; ++t)
            EXPECT_NEAR(size_at(construction, 0, t) * 200 * sine / on_ellipse(t), 1, 0.01) << t;
        Pattern const pattern { .kind = Pattern::Kind::Spiral };
        for (auto const& tip :
             organ_tips(construction, grown(write_model(construction, pattern, "plant"))))
            EXPECT_NEAR(std::hypot(tip.x() / kAcross_mm, tip.z() / kDeep_mm), 1, 0.01);
    }
}

// If the stem is an arc of a circle, the cross-section must be the same ellipse all along it.
TEST(AroundStem, FollowsABentStem)
{
    constexpr double kRadius_mm = 150;
    auto const ring = [&](double out_mm, double depth_mm) {
        std::vector<Vec3> points;
        for (int i = -20; i <= 220; ++i) {
            double const angle = radians(90) * i / 200;
            points.emplace_back(kRadius_mm - (kRadius_mm + out_mm) * std::cos(angle),
                                (kRadius_mm + out_mm) * std::sin(angle), depth_mm);
        }
        return points;
    };
    auto const ray = [&](double along_deg) {
        auto const at = [&](double radius_mm) {
            return Vec2(kRadius_mm - radius_mm * std::cos(radians(along_deg)),
                        radius_mm * std::sin(radians(along_deg)));
        };
        return std::vector<Vec2> { at(kRadius_mm + 70), at(kRadius_mm - 70) };
    };
    LineSketch const sketch { .stem = arc(kRadius_mm, 90, 400),
                              .left = {},
                              .right = {},
                              .inclinations = { ray(15), ray(80) },
                              .nodes_per_layer = { 9 },
                              .around = { ring(kAcross_mm, 0), ring(0, kDeep_mm),
                                          ring(-kAcross_mm, 0), ring(0, -kDeep_mm) } };
    auto const construction = measured(sketch);
    ASSERT_EQ(construction.around.size(), 4U);
    double const length_mm = construction.stem.length_mm();
    for (std::size_t node = 0; node < construction.nodes.size(); ++node)
        for (int t = 0; t < 360; t += 15)
            EXPECT_NEAR(size_at(construction, node, t) * length_mm, on_ellipse(t), 0.01) << t;
}

TEST(AroundStem, SizesBetweenTwoOppositeBoundariesAreHalfEllipses)
{
    auto const at = [](double t) { return size_between({ 0.25, 0.15, 180 }, t / 180); };
    EXPECT_NEAR(at(0), 0.25, 1e-12);
    EXPECT_NEAR(at(45), 0.2209, 5e-5);
    EXPECT_NEAR(at(90), 0.2, 1e-12);
    EXPECT_NEAR(at(135), 0.1697, 5e-5);
    EXPECT_NEAR(at(180), 0.15, 1e-12);
}

TEST(AroundStem, EqualSizesAreACircleHoweverFarApart)
{
    for (double const gap_deg : { 20.0, 90.0, 110.0, 180.0, 250.0, 360.0 })
        for (double share = 0; share <= 1; share += 0.1)
            EXPECT_NEAR(size_between({ 0.3, 0.3, gap_deg }, share), 0.3, 1e-12);
}

TEST(AroundStem, SizesDoNotJumpWhereBoundariesMove)
{
    for (double gap_deg = 10; gap_deg < 300; gap_deg += 0.5)
        for (double share = 0.05; share < 1; share += 0.1)
            EXPECT_NEAR(size_between({ 0.4, 0.2, gap_deg }, share),
                        size_between({ 0.4, 0.2, gap_deg + 0.5 }, share), 1e-3);
    for (double before_deg = 20; before_deg < 200; before_deg += 0.5)
        for (double share = 0.05; share < 1; share += 0.1)
            EXPECT_NEAR(size_between({ 0.4, 0.3, 50, 0.35, before_deg }, share),
                        size_between({ 0.4, 0.3, 50, 0.35, before_deg + 0.5 }, share), 2e-3);
}

TEST(AroundStem, ALineKeepsItsAzimuth)
{
    DrawnStem const stem(std::vector<Vec3> { Vec3(0, 0, 0), Vec3(0, 200, 0) });
    for (double const azimuth_deg : { 0.0, 30.0, 90.0, 179.0, 200.0, 270.0, 350.0 })
        EXPECT_NEAR(azimuth_of(on_cylinder(azimuth_deg), stem).value(), azimuth_deg, 1e-9);
    std::vector<Vec3> helix;
    for (int i = 0; i <= 200; ++i)
        helix.emplace_back(-30 * std::cos(radians(3.6 * i)), i, -30 * std::sin(radians(3.6 * i)));
    EXPECT_EQ(azimuth_of(helix, stem), std::nullopt) << "it goes around";
    EXPECT_EQ(degrees_between(350, 10), 20);
    EXPECT_EQ(degrees_between(0, 180), 180);
}

// The stem leans towards the viewer by 30 degrees. Front and back are then directions perpendicular
// to the stem.
TEST(AroundStem, AzimuthsAreThoseAroundAStemThatLeans)
{
    double const sine = std::sin(radians(30));
    double const cosine = std::cos(radians(30));
    DrawnStem const stem(std::vector<Vec3> { Vec3(0, 0, 0), 200 * Vec3(0, cosine, sine) });
    Vec3 const behind(0, 30 * sine, -30 * cosine);
    std::vector<Vec3> const line { behind, behind + 200 * Vec3(0, cosine, sine) };
    EXPECT_NEAR(azimuth_of(line, stem).value(), 90, 1e-9);
    EXPECT_NEAR(reach_mm({ 0.5, 90, 90 }, stem, line).value(), 30, 1e-9);
    EXPECT_NEAR(reach_mm({ 0.5, 90, 30 }, stem, line).value(), 60, 1e-9);
    EXPECT_EQ(reach_mm({ 0.5, 270, 90 }, stem, line), std::nullopt) << "on the other side";
    EXPECT_EQ(reach_mm({ 0.5, 90, 1 }, stem, line), std::nullopt) << "past its end";
}

} // namespace
} // namespace tractus::lines
