#include "app/view/shown_layers.h"

#include "app/tools/draw_tool.h"
#include "app/tools/select_tool.h"
#include "tests/app/small_model.h"

#include <array>
#include <gtest/gtest.h>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace tractus::view {
namespace {

using Lines = std::vector<std::vector<Vec3f>>;

// Returns a line whose position depends on the edit that last changed the plant.
Lines lines_of(scene::BuiltPlant const& plant)
{
    auto const x = static_cast<float>(plant.drawn->source_edit);
    return { { Vec3f(x, 0, 0), Vec3f(x, 1, 0) } };
}

bool is_selecting(tools::Tool const& in_hand)
{
    return in_hand.get<tools::SelectTool>() != nullptr;
}

constexpr tools::Layer kStays { .label = "stays", .lines = lines_of };
constexpr tools::Layer kFades { .label = "fades",
                                .lines = lines_of,
                                .seen = tools::Layer::Seen::AWhile,
                                .is_asked_for = is_selecting };
constexpr tools::Layer kHidden { .label = "hidden",
                                 .lines = lines_of,
                                 .seen = tools::Layer::Seen::WhenAskedFor,
                                 .is_asked_for = is_selecting };

constexpr std::array kAll { &kStays, &kFades, &kHidden };

std::string seen_in(ShownLayers const& layers)
{
    std::string said;
    for (auto const& shown : layers.seen())
        said += std::string(shown.layer->label) + " ";
    return said;
}

// Returns the scene after one more edit of its plant.
scene::Scene changed(scene::Scene scene)
{
    auto plant = std::make_shared<scene::PlantState>(*scene.drawn);
    ++plant->source_edit;
    scene.drawn = std::move(plant);
    return scene;
}

class ShownLayersTest : public ::testing::Test {
protected:
    ShownLayersTest() { layers_.set_layers(kAll); }

    tools::Tool const drawing_ = tools::DrawTool {};
    tools::Tool const selecting_ = tools::SelectTool {};
    scene::Scene const scene_ = small_scene();
    ShownLayers layers_;
};

TEST_F(ShownLayersTest, FadeAfterAChangeAndComeBackWithTheNext)
{
    layers_.show(scene_, drawing_);
    EXPECT_EQ(seen_in(layers_), "stays ") << "nothing has changed yet";
    auto const next = changed(scene_);
    layers_.show(next, drawing_);
    ASSERT_EQ(seen_in(layers_), "stays fades ");
    EXPECT_EQ(layers_.seen()[1].strength, 1);
    layers_.pass(from_seconds(4), drawing_);
    ASSERT_EQ(seen_in(layers_), "stays fades ");
    EXPECT_EQ(layers_.seen()[1].strength, 0.5);
    EXPECT_EQ(layers_.seen()[0].strength, 1);
    layers_.show(next, drawing_); // The plant is the same, so the layers must not change.
    layers_.pass(from_seconds(3), drawing_);
    EXPECT_EQ(seen_in(layers_), "stays ");
    layers_.show(changed(next), drawing_);
    EXPECT_EQ(seen_in(layers_), "stays fades ");
}

TEST_F(ShownLayersTest, StayAsLongAsTheToolInHandAsksForThem)
{
    layers_.show(scene_, selecting_);
    EXPECT_EQ(seen_in(layers_), "stays fades hidden ");
    layers_.pass(from_seconds(60), selecting_);
    EXPECT_EQ(seen_in(layers_), "stays fades hidden ");
    layers_.show(scene_, drawing_);
    EXPECT_EQ(seen_in(layers_), "stays ");
    layers_.show(scene_, selecting_);
    EXPECT_EQ(seen_in(layers_), "stays fades hidden ");
}

TEST(ShownLayers, FadeInFewSteps)
{
    std::set<double> strengths;
    for (int i = 0; i < 700; ++i)
        strengths.insert(ShownLayers::strength_after(from_seconds(0.01 * i)));
    EXPECT_EQ(strengths.size(), 9U);
    EXPECT_EQ(*strengths.rbegin(), 1);
    EXPECT_EQ(*strengths.begin(), 0);
    EXPECT_EQ(ShownLayers::strength_after(from_seconds(2)), 1);
    EXPECT_EQ(ShownLayers::strength_after(from_seconds(6)), 0);
}

} // namespace
} // namespace tractus::view
