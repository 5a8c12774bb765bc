#include "app/methods/plants/choose_plant_tool.h"
#include "app/methods/plants/copy_plant_tool.h"
#include "app/methods/plants/hide_plant_tool.h"
#include "app/methods/plants/move_plant_tool.h"
#include "app/methods/plants/remove_plant_tool.h"
#include "tests/app/small_model.h"

#include <gtest/gtest.h>

namespace tractus {
namespace {

Scene after(Tool const& tool, Stroke const& stroke, Scene const& scene)
{
    auto const edits = tool.mean(stroke, scene);
    EXPECT_TRUE(edits) << edits.error().message;
    return edits ? apply_edits(scene, *edits).value() : Scene {};
}

Stroke touch(Vec3 const& at_mm)
{
    return stroke_through({ at_mm, at_mm + Vec3(1, 0, 0) });
}

TEST(PlantTools, CopyAPlantBesideAllOthersAndGoOnWithIt)
{
    auto const one = small_scene();
    auto const two = after(CopyPlantTool {}, {}, one);
    auto const three = after(CopyPlantTool {}, {}, two);
    ASSERT_EQ(three.plants.size(), 3u);
    EXPECT_EQ(three.state.active, three.plants[2]->drawn->id);
    for (std::size_t i = 1; i < 3; ++i) {
        auto const& left = *three.plants[i - 1];
        auto const& right = *three.plants[i];
        EXPECT_NEAR(right.placement.world_of_plant(bounds(*right.base).min_mm).x()
                        - left.placement.world_of_plant(bounds(*left.base).max_mm).x(),
                    10, 1e-9);
    }
}

TEST(PlantTools, ChooseThePlantThatIsTouched)
{
    auto const two = after(CopyPlantTool {}, {}, small_scene());
    auto const first = after(ChoosePlantTool {}, touch({ 0, 0, 50 }), two);
    EXPECT_EQ(first.state.active, two.plants[0]->drawn->id);
    auto const second = after(ChoosePlantTool {}, touch(two.placement.origin_mm), first);
    EXPECT_EQ(second.state.active, two.plants[1]->drawn->id);
    auto const nowhere = Tool(ChoosePlantTool {}).mean(touch({ 0, 500, 0 }), two);
    ASSERT_FALSE(nowhere);
    EXPECT_NE(nowhere.error().message.find("no plant here"), std::string::npos);
}

TEST(PlantTools, MoveThePlantWhereTheStrokeBegins)
{
    auto const two = after(CopyPlantTool {}, {}, small_scene());
    auto const moved
        = after(MovePlantTool {}, stroke_through({ { 0, 0, 10 }, { -30, 40, 90 } }), two);
    EXPECT_EQ(moved.plants[0]->placement.origin_mm, Vec3(-30, 40, 0)) << "over the ground";
    EXPECT_EQ(moved.plants[1], two.plants[1]);
}

TEST(PlantTools, HideAndShow)
{
    auto const two = after(CopyPlantTool {}, {}, small_scene());
    auto const hidden = after(HidePlantTool {}, {}, two);
    EXPECT_TRUE(hidden.plants[1]->drawn->is_hidden);
    EXPECT_FALSE(Tool(ChoosePlantTool {}).mean(touch(two.placement.origin_mm), hidden))
        << "what is hidden is not touched";
    auto const shown = after(HidePlantTool { HidePlantTool::What::None }, {}, hidden);
    EXPECT_FALSE(shown.plants[1]->drawn->is_hidden);
    EXPECT_FALSE(Tool(HidePlantTool { HidePlantTool::What::None }).mean({}, shown));
}

TEST(PlantTools, RemoveThePlantThatTakesWhatIsDrawn)
{
    auto const two = after(CopyPlantTool {}, {}, small_scene());
    auto const one = after(RemovePlantTool {}, {}, two);
    ASSERT_EQ(one.plants.size(), 1u);
    EXPECT_EQ(one.plants[0], two.plants[0]);
    auto const none = after(RemovePlantTool {}, {}, one);
    EXPECT_TRUE(none.plants.empty());
    EXPECT_FALSE(Tool(RemovePlantTool {}).mean({}, none));
    EXPECT_FALSE(Tool(CopyPlantTool {}).mean({}, none));
}

} // namespace
} // namespace tractus
