#include "engine/methods/construction_lines/line_model.h"

#include "engine/lsystem/language/print.h"
#include "tests/engine/methods/construction_lines/sketches.h"

namespace tractus::lines {
namespace {

using Kind = Pattern::Kind;

std::string derived(Construction const& construction, Pattern const& pattern, int steps = -1)
{
    auto const model = compiled(write_model(construction, pattern, "plant"));
    lsystem::DeriveOptions options;
    if (steps >= 0)
        options.steps = steps;
    return lsystem::to_string(model, *lsystem::derive(model, options));
}

TEST(LineModel, DerivesToTheNodesInAllPatterns)
{
    auto const construction = measured(hand_sketch());
    for (auto const kind :
         { Kind::Distichous, Kind::Decussate, Kind::Spiral, Kind::Alternate, Kind::Whorled })
        EXPECT_EQ(derived(construction, { .kind = kind }),
                  "+(0)^(0)S(0,0.2)B(0.2,0)S(0.2,0.35)B(0.35,1)S(0.35,0.5)B(0.5,2)S(0.5,0.65)"
                  "B(0.65,3)S(0.65,0.8)B(0.8,4)S(0.8,1)");
}

TEST(LineModel, AStepMakesANode)
{
    EXPECT_EQ(derived(measured(hand_sketch()), {}, 2),
              "+(0)^(0)S(0,0.2)B(0.2,0)S(0.2,0.35)B(0.35,1)A(0.35,0,2,2)");
}

TEST(LineModel, SkipsALayerWithoutNodes)
{
    auto sketch = hand_sketch();
    sketch.inclinations.push_back({ Vec2(-60, 100), Vec2(40, 100) });
    sketch.nodes_per_layer = { 0, 2 };
    EXPECT_EQ(derived(measured(sketch), {}),
              "+(0)^(0)S(0,0.5)B(0.5,0)S(0.5,0.65)B(0.65,1)S(0.65,0.8)B(0.8,2)S(0.8,1)");
    sketch.nodes_per_layer = { 0, 0 };
    EXPECT_EQ(derived(measured(sketch), {}), "+(0)^(0)S(0,0.8)B(0.8,0)S(0.8,1)");
}

TEST(LineModel, AWhorlOfTwoIsDecussate)
{
    auto const pairs = tips_of(hand_sketch(), { .kind = Kind::Decussate });
    auto const whorls = tips_of(hand_sketch(), { .kind = Kind::Whorled, .whorl = 2 });
    ASSERT_EQ(pairs.size(), whorls.size());
    for (std::size_t i = 0; i < pairs.size(); ++i)
        EXPECT_NEAR((pairs[i] - whorls[i]).norm(), 0, 1e-3) << i;
}

TEST(LineModel, AlternateOrgansStandLeftAndRightInTurn)
{
    auto const pairs = tips_of(hand_sketch(), { .kind = Kind::Distichous });
    auto const alternate
        = tips_of(hand_sketch(), { .kind = Kind::Alternate, .divergence_deg = 180 });
    ASSERT_EQ(alternate.size(), 5U);
    for (std::size_t i = 0; i < 5; ++i)
        EXPECT_NEAR((alternate[i] - pairs[2 * i + i % 2]).norm(), 0, 1e-3) << i;
}

TEST(LineModel, DivergencesMayBeNegative)
{
    auto const left = tips_of(hand_sketch(), { .kind = Kind::Spiral, .divergence_deg = 99.5 });
    auto const right = tips_of(hand_sketch(), { .kind = Kind::Spiral, .divergence_deg = -99.5 });
    for (std::size_t i = 0; i < left.size(); ++i)
        EXPECT_NEAR((left[i] - Vec3(right[i].x(), right[i].y(), -right[i].z())).norm(), 0, 1e-3);
}

TEST(LineModel, ItsStemIsTheDrawnOne)
{
    for (auto const& sketch : { hand_sketch(), bent_sketch(), coarse_sketch() }) {
        auto const construction = measured(sketch);
        auto const plant = grown(write_model(construction, {}, "plant"));
        ASSERT_EQ(plant.axes.size(), 1U);
        Vec3 const top_mm = plant.positions(plant.axes[0]).back() / 10;
        Vec3 const drawn = construction.stem.point(1) - construction.stem.point(0);
        EXPECT_NEAR(top_mm.x(), drawn.x(), 2e-3 * construction.stem.length_mm());
        EXPECT_NEAR(top_mm.z(), drawn.y(), 2e-3 * construction.stem.length_mm());
        EXPECT_NEAR(top_mm.y(), 0, 1e-6);
    }
}

} // namespace
} // namespace tractus::lines
