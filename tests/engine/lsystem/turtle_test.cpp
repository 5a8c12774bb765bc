#include "engine/lsystem/interpret.h"

#include "engine/base/vectors.h"
#include "tests/engine/lsystem/small_model.h"

#include <cmath>
#include <gtest/gtest.h>

namespace tractus {
namespace {

Vec3 tip(Plant const& plant)
{
    return plant.node_position_mm.back();
}

void expect_near(Vec3 const& found, Vec3 const& expected)
{
    EXPECT_LT((found - expected).norm(), 1e-7)
        << found.transpose() << ", expected " << expected.transpose();
}

TEST(Turtle, GrowsUpwards)
{
    auto const plant = drawn("F(100)F");
    ASSERT_EQ(plant.axes.size(), 1u);
    EXPECT_EQ(plant.axes[0].segment_count, 2u);
    expect_near(tip(plant), { 0, 0, 101 });
}

TEST(Turtle, MeasuresInUnits)
{
    auto const model = compiled(with_header("Axiom: F(3)", 0));
    auto const plant = interpret(model, *derive(model));
    ASSERT_TRUE(plant);
    expect_near(tip(*plant), { 0, 0, 30 });
}

TEST(Turtle, TurnsInItsFrame)
{
    expect_near(tip(drawn("+(90)F")), { -1, 0, 0 });
    expect_near(tip(drawn("-(90)F")), { 1, 0, 0 });
    expect_near(tip(drawn("&(90)F")), { 0, 1, 0 }); // Down is away from the user.
    expect_near(tip(drawn("^(90)F")), { 0, -1, 0 });
    expect_near(tip(drawn("/(90)+(90)F")), { 0, 1, 0 });
    expect_near(tip(drawn("\\(90)+(90)F")), { 0, -1, 0 });
    expect_near(tip(drawn("|F")), { 0, 0, -1 });
    expect_near(tip(drawn("+(30)F(2)")), { -1, 0, std::sqrt(3) });
}

TEST(Turtle, TakesItsAngleFromTheView)
{
    expect_near(tip(drawn("+F")), { -std::sqrt(0.5), 0, std::sqrt(0.5) });
    expect_near(tip(drawn("+F", "angle increment: 90\n")), { -1, 0, 0 });
    expect_near(tip(drawn("+F", "angle factor: 4\n")), { -1, 0, 0 });
}

TEST(Turtle, HangsBranchesOnTheSegmentThatBearsThem)
{
    auto const plant = drawn("F[+(90)FF]F[-(90)F]F");
    ASSERT_EQ(plant.axes.size(), 3u);
    EXPECT_EQ(plant.axes[0].segment_count, 3u);
    EXPECT_EQ(plant.axes[1].segment_count, 2u);
    EXPECT_EQ(plant.axes[1].parent_segment, 0u);
    EXPECT_EQ(plant.axes[2].parent_segment, 1u);
    EXPECT_EQ(plant.axes[2].order, 1u);
    expect_near(plant.positions(plant.axes[1])[0], { 0, 0, 1 });
}

TEST(Turtle, LeavesOutStubs)
{
    auto const plant = drawn("F[F(0)[+(90)F]]");
    ASSERT_EQ(plant.axes.size(), 2u);
    EXPECT_EQ(plant.axes[1].parent_segment, 0u);
}

TEST(Turtle, BeginsAnAxisBehindAGap)
{
    auto const plant = drawn("Ff(2)F");
    ASSERT_EQ(plant.axes.size(), 2u);
    EXPECT_EQ(plant.axes[1].parent_segment, 0u);
    expect_near(plant.positions(plant.axes[1])[0], { 0, 0, 3 });
}

TEST(Turtle, TakesRadiiFromTheLineWidth)
{
    auto const plant = drawn("!(4)F!(2)F[!(1)+(90)F]!(3)", "line width increment: 0.5\n");
    std::vector<float> const expected { 2, 1, 1.5, 0.5, 0.5 };
    EXPECT_EQ(plant.node_radius_mm, expected);
    auto const stepped = drawn("F#F!!F", "initial line width: 4\nline width increment: 1\n");
    std::vector<float> const expected_stepped { 2, 2.5, 1.5, 1.5 };
    EXPECT_EQ(stepped.node_radius_mm, expected_stepped);
}

TEST(Turtle, UsesThePipeModelWhereTheViewSaysSo)
{
    auto const plant = drawn("F[+(90)F][-(90)F]", "radii: pipe 2 1\n");
    EXPECT_FLOAT_EQ(plant.node_radius_mm[0], std::sqrt(2.0f));
}

TEST(Turtle, RollsUntilItsLeftIsHorizontal)
{
    // Heading to +x, rolled by 50 degrees; @v makes the upper side look up, so ^ leads up.
    expect_near(tip(drawn("-(90)/(50)@v^(90)F")), { 0, 0, 1 });
    expect_near(tip(drawn("&(90)\\(20)@v^(90)F")), { 0, 0, 1 });
}

TEST(Turtle, ReadsVectorsInTheModelsSpace)
{
    expect_near(tip(drawn("@M(1,2,3)F")), { 1, -3, 3 });
    expect_near(tip(drawn("@R(0,0,1)F")), { 0, -1, 0 });
    expect_near(tip(drawn("@R(1,0,0,0,1,0)^(90)F")), { 0, 0, 1 });
}

TEST(Turtle, BendsTowardsTropisms)
{
    // Heading to -x, T up: |H x T| = 1, elasticity 0.3: turns by 0.3 radians.
    expect_near(tip(drawn("+(90)F", "tropism: T: 0,1,0 E: 0.3\n")),
                { -std::cos(0.3), 0, std::sin(0.3) });
    expect_near(tip(drawn("+(90)@Ts(1,0.3)F", "tropism: T: 0,1,0\n")),
                { -std::cos(0.3), 0, std::sin(0.3) });
    // The older tropism bends behind the step.
    expect_near(tip(drawn("+(90)FF", "tropism direction: 0,1,0\ninitial elasticity: 0.3\n")),
                { -1 - std::cos(0.3), 0, std::sin(0.3) });
    // Perpendicular to T, a turtle that heads along it turns away by the elasticity.
    auto const away = tip(drawn("F", "tropism: T: 0,1,0 A: 90 E: 0.2\n"));
    EXPECT_NEAR(std::acos(away.z()), 0.2, 1e-9);
}

TEST(Turtle, PlacesOrgansInTheirFrame)
{
    auto const view = "material: 3 green kind=leaf color=0.2,0.6,0.1\norgan: l leaf kind=blade "
                      "material=3 length=2 width=1\n";
    auto const plant = drawn("F[+(90)~l(2)]", view);
    ASSERT_EQ(plant.organs.size(), 1u);
    auto const& organ = plant.organs[0];
    EXPECT_EQ(organ.segment, 0u);
    expect_near(organ.position_mm, { 0, 0, 1 });
    expect_near(organ.orientation * Vec3::UnitY(), { -1, 0, 0 }); // Along the heading.
    expect_near(organ.orientation * Vec3::UnitZ(), { 0, -1, 0 }); // The turtle's upper side.
    EXPECT_EQ(organ.scale, Vec3f(2, 2, 2));
    auto const& shape = plant.organ_shapes[organ.shape];
    EXPECT_EQ(shape.length_mm, 2);
    EXPECT_EQ(plant.materials[shape.material].name, "green");
}

TEST(Turtle, DrawsBallsAboutItself)
{
    auto const plant = drawn("F@O(2)");
    ASSERT_EQ(plant.organs.size(), 1u);
    expect_near(plant.organs[0].position_mm, { 0, 0, 0 });
    EXPECT_EQ(plant.organs[0].scale, Vec3f(2, 2, 2));
}

TEST(Turtle, FillsPolygons)
{
    auto const plant = drawn("F{.+(90)f.-(90)F-(90)f}");
    ASSERT_EQ(plant.polygons.size(), 1u);
    EXPECT_EQ(plant.polygons[0].vertex_count, 5u);
    EXPECT_EQ(plant.polygons[0].segment, 0u);
    EXPECT_EQ(plant.segment_count(), 1u);
}

TEST(Turtle, LeavesOutWhatIsNotANumber)
{
    auto const model = compiled(
        with_header("Axiom: F(log(-1))F(exp(1000))F+(log(0))F@M(1e38,1e38,1e38)F[[]]]}", 0));
    auto const result = interpret_with_warnings(model, *derive(model));
    ASSERT_TRUE(result) << result.error().message;
    check_plant(result->plant);
    EXPECT_GE(result->warnings.size(), 3u);
}

TEST(Turtle, DrawsAMillionSegmentsInDeepBrackets)
{
    auto const model
        = compiled(with_header("Axiom: A(1000000)\nhomomorphism\nmaximum depth: 1000000\n"
                               "A(n) : n>0 --> F[&A(n-1)]",
                               0));
    auto const plant = interpret(model, *derive(model));
    ASSERT_TRUE(plant) << plant.error().message;
    check_plant(*plant);
    EXPECT_EQ(plant->segment_count(), 1'000'000u);
}

TEST(Turtle, StopsARunawayHomomorphism)
{
    auto const model
        = compiled(with_header("Axiom: A\nhomomorphism\nmaximum depth: 50\nA --> AA", 0));
    auto const plant = interpret(model, *derive(model), { .unit_mm = 10, .max_modules = 10000 });
    ASSERT_FALSE(plant);
    EXPECT_EQ(plant.error().message, "model.l: the homomorphism makes more than 10000 modules");
}

} // namespace
} // namespace tractus
