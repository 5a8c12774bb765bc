#include "engine/scene/scene.h"

#include "engine/plant/join_axes.h"
#include "engine/variation/growth.h"

#include <gtest/gtest.h>

namespace tractus::scene {
namespace {

// Returns a model of a trunk with six internodes and one branch of two internodes.
LoadModel small_model()
{
    return { .source = { .name = "small.l",
                         .text = "Lsystem: 1\nderivation length: 1\n"
                                 "Axiom: F(10)F(10)[+(60)F(8)F(8)]F(10)F(10)F(10)F(10)\n"
                                 "A --> A\nendlsystem\n" } };
}

// Returns a stroke that rises while it bends to the right.
Stroke bent_stroke()
{
    Stroke stroke;
    for (int i = 0; i <= 40; ++i) {
        double const along = i / 40.0;
        stroke.tips.push_back({ .time = timestamp_ns(i * 5'000'000),
                                .position_mm = { 80 * along * along, 0, 50 + 150 * along },
                                .pressure = 0.5,
                                .touching = true });
    }
    return stroke;
}

variation::Selection trunk(Scene const& scene)
{
    return { segments_of(scene.base->axes[0]) };
}

TEST(Scene, HoldsTheModelsPlant)
{
    auto const scene = apply_edit({}, small_model());
    ASSERT_TRUE(scene) << scene.error().message;
    EXPECT_EQ(scene->base->segment_count(), 8u);
    EXPECT_EQ(scene->model_name, "small.l");
    EXPECT_GT(scene->placement.scale, 0);
}

TEST(Scene, RefusesAModelThatDoesNotCompileAndStaysAsItWas)
{
    auto const before = apply_edit({}, small_model()).value();
    auto const after
        = apply_edit(before, LoadModel { .source = { .name = "broken.l", .text = "Axiom F" } });
    ASSERT_FALSE(after);
    EXPECT_EQ(after.error().fault, Fault::User);
    EXPECT_NE(after.error().message.find("broken.l:"), std::string::npos) << after.error().message;
    EXPECT_EQ(before.base->segment_count(), 8u);
}

TEST(Scene, RefusesAStrokeForNothing)
{
    auto const scene = apply_edit({}, small_model()).value();
    auto const result = apply_edit(scene, Associate { bent_stroke() });
    ASSERT_FALSE(result);
    EXPECT_NE(result.error().message.find("select a branch first"), std::string::npos);
}

TEST(Scene, RefusesASegmentThatThePlantDoesNotHave)
{
    auto const scene = apply_edit({}, small_model()).value();
    EXPECT_FALSE(apply_edit(scene, Select { { { 8 } } }));
}

TEST(Scene, LetsAStrokeShapeEverySelectedPath)
{
    auto scene = apply_edit({}, small_model()).value();
    auto const branch = segments_of(scene.base->axes[1]);
    scene = apply_edit(scene, Select { { trunk(scene)[0], branch } }).value();
    scene = apply_edit(scene, Associate { bent_stroke() }).value();
    ASSERT_EQ(scene.associations.size(), 2u);
    EXPECT_EQ(scene.associations[1].what.path, branch);
}

TEST(Scene, IsTheFoldOfItsEdits)
{
    auto const loaded = apply_edit({}, small_model()).value();
    std::vector<Edit> const edits {
        small_model(),
        Select { trunk(loaded) },
        Associate { bent_stroke() },
        Indicate { { .end_mm = { 100, 0, 0 } } },
        SetGrowth { { .strength = 0.5 }, 7 },
    };
    auto const scene = fold(edits);
    ASSERT_TRUE(scene) << scene.error().message;
    EXPECT_EQ(scene->associations.size(), 1u);
    EXPECT_EQ(scene->indicators.size(), 1u);
    EXPECT_EQ(scene->growth.parameters.strength, 0.5);
    EXPECT_EQ(scene->growth.seed, 7u);
    auto const one_less = fold(std::span(edits).first(3));
    EXPECT_TRUE(one_less->indicators.empty());
}

TEST(Scene, ForgetsWhatBelongedToAnotherModel)
{
    auto const loaded = apply_edit({}, small_model()).value();
    std::vector<Edit> const edits { small_model(), Select { trunk(loaded) },
                                    Associate { bent_stroke() }, small_model() };
    auto const scene = fold(edits).value();
    EXPECT_TRUE(scene.associations.empty());
    EXPECT_TRUE(scene.selection.empty());
}

TEST(Scene, GrowsTheDrawnShapeWithoutNoise)
{
    auto const loaded = apply_edit({}, small_model()).value();
    std::vector<Edit> const edits { small_model(), Select { trunk(loaded) },
                                    Associate { bent_stroke() }, SetGrowth { { .strength = 0 } } };
    auto const scene = fold(edits).value();
    auto const plan = plan_growth(scene);
    ASSERT_TRUE(plan) << plan.error().message;
    variation::Grower grower(*plan);
    auto const& plant = grower.grow({ 1, 0 });
    check_plant(plant);
    // The trunk now leans to the right, but its length has not changed.
    EXPECT_GT(plant.node_position_mm[6].x(), 50);
    EXPECT_NEAR(axis_length_mm(plant, plant.axes[0]),
                axis_length_mm(*scene.base, scene.base->axes[0]), 1e-6);
}

TEST(Scene, KnowsTheStrokesThatStillShapeSomething)
{
    auto const loaded = apply_edit({}, small_model()).value();
    Edit const select = Select { trunk(loaded) };
    Edit const stroke = Associate { bent_stroke() };
    Edit const on_branches = Associate { bent_stroke(), variation::Propagation::Descendants };
    auto const straight
        = Associate { { { { .position_mm = { 0, 0, 0 } }, { .position_mm = { 0, 0, 90 } } } } };
    std::vector<Edit> edits { small_model(), select, straight, on_branches, stroke };
    auto const scene = fold(edits).value();
    auto const shaping = shaping_associations(scene);
    ASSERT_EQ(shaping.size(), 2u);
    EXPECT_EQ(shaping[0].propagation, variation::Propagation::Descendants);
    EXPECT_EQ(shaping[1].propagation, variation::Propagation::Selected);
    std::vector<variation::Association> all;
    for (auto const& association : scene.associations)
        all.push_back(association.what);
    auto const of_all = variation::resolve_associations(*scene.base, *scene.rest, all).value();
    auto const of_shaping
        = variation::resolve_associations(*scene.base, *scene.rest, shaping).value();
    for (std::size_t i = 0; i < of_all.frame.size(); ++i)
        EXPECT_EQ(of_shaping.frame[i].coeffs(), of_all.frame[i].coeffs()) << i;
}

} // namespace
} // namespace tractus::scene
