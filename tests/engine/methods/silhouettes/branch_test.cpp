#include "tests/engine/methods/silhouettes/outlines.h"

#include "engine/methods/silhouettes/branch.h"

namespace tractus::silhouette {
namespace {

double length_of_cubic(Cubic const& curve, std::size_t chords)
{
    return length_of(curve.points(chords + 1));
}

TEST(SilhouetteBranch, ACurveThatArrivesAsItSetsOutIsStraight)
{
    Cubic const curve { Vec2(0, 0), Vec2(60, 0), Vec2(30, 0), Vec2(30, 0) };
    EXPECT_NEAR(length_of_cubic(curve, 200), 60, 1e-9);
}

// The curve contains a right angle. Its expected middle and length are the published ones.
TEST(SilhouetteBranch, TheMiddleAndTheLengthOfACurveAreKnown)
{
    Cubic const curve { Vec2(0, 0), Vec2(60, 0), Vec2(0, 30), 30 * direction_of(Vec2(1, 1)) };
    EXPECT_LT((curve.at(0.5) - Vec2(27.3483, 1.0983)).norm(), 1e-4);
    EXPECT_NEAR(length_of_cubic(curve, 16), 62.0721, 1e-4);
    EXPECT_NEAR(length_of_cubic(curve, 200), 62.1689, 1e-4);
}

TEST(SilhouetteBranch, AnglesAreLinearBetweenSamplesAndLearnOthers)
{
    BranchingAngles angles;
    EXPECT_DOUBLE_EQ(angles.at_deg(0), 80);
    EXPECT_DOUBLE_EQ(angles.at_deg(0.5), 57.5);
    EXPECT_DOUBLE_EQ(angles.at_deg(1), 35);
    angles.learn({ .t = 0.5, .angle_deg = 90 });
    EXPECT_DOUBLE_EQ(angles.at_deg(0.25), 85);
    angles.learn({ .t = 0.53, .angle_deg = 20 });
    EXPECT_EQ(angles.samples().size(), 3U);
    EXPECT_DOUBLE_EQ(angles.at_deg(0.53), 20);
}

std::vector<Vec2> upright_trunk()
{
    return resampled_line(upright(0, 126), 64);
}

TEST(SilhouetteBranch, AtRightAnglesTheBaseIsAsHighAsTheEnd)
{
    auto const trunk = upright_trunk();
    BranchingAngles const level({ { 0, 90 } });
    auto const branch = infer_branch({ .trunk = trunk, .bases = { 0, 63 }, .angles = level },
                                     { .end = Vec2(50, 60), .tangent = Vec2::UnitX() });
    EXPECT_LT((branch.curve.base - Vec2(0, 60)).norm(), 1e-9);
    EXPECT_NEAR(branch.length, 50, 1e-9);
    EXPECT_EQ(branch.side, Side::Right);
}

// Compares the branch with the shortest branch from any base. All bases are tried, one by one.
TEST(SilhouetteBranch, NoBaseGivesAShorterBranch)
{
    auto const trunk = upright_trunk();
    BranchingAngles const angles;
    BranchSearch const search { .trunk = trunk, .bases = { 5, 60 }, .angles = angles };
    for (int i = 0; i < 200; ++i) {
        Random random({ 20, 2, static_cast<std::uint32_t>(i) });
        BranchEnd const to { .end = Vec2(random.uniform(-80, 80), random.uniform(-20, 160)),
                             .tangent = turned(Vec2::UnitX(), random.uniform(0, 2 * kPi)) };
        auto const found = infer_branch(search, to);
        for (std::size_t k = 5; k <= 60; ++k)
            EXPECT_GE(branch_from(search, k, to).length, found.length - 1e-8);
    }
}

TEST(SilhouetteBranch, AConeIsAsWideAsItsBump)
{
    EXPECT_DOUBLE_EQ(cone_angle_deg(0, 1), 20);
    EXPECT_DOUBLE_EQ(cone_angle_deg(0.25, 1), 42.5);
    EXPECT_DOUBLE_EQ(cone_angle_deg(2, 1), 110);
}

TEST(SilhouetteBranchCorpus, ClosedFormsAreThePublishedOnes)
{
    REQUIRE_CORPUS();
    std::ifstream stream(corpus() / "silhouettes" / "arrangement.json");
    auto const forms = nlohmann::json::parse(stream);
    for (auto const& [share, angle_deg] : forms["cone_deg_of_r_over_d"].items())
        EXPECT_NEAR(cone_angle_deg(std::stod(share), 1), angle_deg.get<double>(), 1e-3);
    auto const trunk = upright_trunk();
    BranchingAngles const angles;
    for (auto const& row : forms["vertical_trunk_126_mm_baf_80_35_64_samples"]) {
        auto const branch = infer_branch(
            { .trunk = trunk, .bases = { 0, 63 }, .angles = angles },
            { .end = point_in(row["end"]),
              .tangent = turned(Vec2::UnitX(), radians(row["end_tangent_deg"].get<double>())) });
        EXPECT_NEAR(branch.curve.base.y(), row["base_y"].get<double>(), 1e-3);
        EXPECT_NEAR(branch.t, row["t"].get<double>(), 1e-4);
        EXPECT_NEAR(branch.length, row["length"].get<double>(), 1e-3);
    }
}

} // namespace
} // namespace tractus::silhouette
