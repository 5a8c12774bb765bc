#include "app/methods/plants/choose_plant_tool.h"
#include "app/methods/plants/copy_plant_tool.h"
#include "app/methods/plants/graft_plant_tool.h"
#include "app/methods/plants/hide_branch_tool.h"
#include "app/methods/plants/hide_plant_tool.h"
#include "app/methods/plants/move_plant_tool.h"
#include "app/methods/plants/remove_plant_tool.h"
#include "app/methods/plants/take_off_tool.h"
#include "engine/plant/join_axes.h"
#include "tests/app/small_model.h"

#include <gtest/gtest.h>

namespace tractus::plants {
namespace {

scene::Scene after(tools::Tool const& tool, Stroke const& stroke, scene::Scene const& scene)
{
    auto const edits = tool.edits_for(stroke, scene);
    EXPECT_TRUE(edits) << edits.error().message;
    return edits ? scene::apply_edits(scene, *edits).value() : scene::Scene {};
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
    auto const nowhere = tools::Tool(ChoosePlantTool {}).edits_for(touch({ 0, 500, 0 }), two);
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
    EXPECT_FALSE(tools::Tool(ChoosePlantTool {}).edits_for(touch(two.placement.origin_mm), hidden))
        << "what is hidden is not touched";
    auto const shown = after(HidePlantTool { HidePlantTool::What::None }, {}, hidden);
    EXPECT_FALSE(shown.plants[1]->drawn->is_hidden);
    EXPECT_FALSE(tools::Tool(HidePlantTool { HidePlantTool::What::None }).edits_for({}, shown));
}

TEST(PlantTools, RemoveThePlantThatTakesWhatIsDrawn)
{
    auto const two = after(CopyPlantTool {}, {}, small_scene());
    auto const one = after(RemovePlantTool {}, {}, two);
    ASSERT_EQ(one.plants.size(), 1u);
    EXPECT_EQ(one.plants[0], two.plants[0]);
    auto const none = after(RemovePlantTool {}, {}, one);
    EXPECT_TRUE(none.plants.empty());
    EXPECT_FALSE(tools::Tool(RemovePlantTool {}).edits_for({}, none));
    EXPECT_FALSE(tools::Tool(CopyPlantTool {}).edits_for({}, none));
}

Vec3 end_of(scene::BuiltPlant const& plant, SegmentId segment)
{
    return plant.placement.world_of_plant(
        plant.base->node_position_mm[nodes_of(*plant.base, segment).tip]);
}

TEST(PlantTools, PutAPlantOnABranchAndTakeItOff)
{
    auto const two = after(CopyPlantTool {}, {}, small_scene());
    Vec3 const tip_mm = end_of(*two.plants[0], two.base->axes[1].first_segment + 1);
    auto const from_mm = two.placement.origin_mm;
    auto const on = after(GraftPlantTool {}, stroke_through({ from_mm, tip_mm }), two);
    ASSERT_EQ(on.plants.size(), 1u);
    EXPECT_EQ(on.base->segment_count(), 24u);
    EXPECT_EQ(on.placement.scale, two.placement.scale);
    Vec3 const world_point_mm
        = on.placement.world_of_plant(on.base->positions(on.base->axes[3])[0]);
    EXPECT_NEAR((world_point_mm - tip_mm).norm(), 0, 1e-9);
    EXPECT_FALSE(tools::Tool(TakeOffTool {}).edits_for(touch(on.placement.origin_mm), on))
        << "its own";
    auto const off = after(TakeOffTool {}, touch(end_of(on, 14)), on);
    ASSERT_EQ(off.plants.size(), 2u);
    EXPECT_EQ(off.base->segment_count(), 12u);
    EXPECT_EQ(off.placement.origin_mm.z(), 0);
    auto const beside = stroke_through({ from_mm, from_mm + Vec3(0, 400, 0) });
    EXPECT_FALSE(tools::Tool(GraftPlantTool {}).edits_for(beside, two));
}

TEST(PlantTools, PutAPlantInThePlaceOfABranch)
{
    auto const two = after(CopyPlantTool {}, {}, small_scene());
    auto const& branch = two.base->axes[2]; // The branch has four internodes.
    auto const drag = stroke_through(
        { two.placement.origin_mm, end_of(*two.plants[0], branch.first_segment + 2) });
    auto const on = after(GraftPlantTool { tools::Grafting::InPlace }, drag, two);
    ASSERT_EQ(on.plants.size(), 1u);
    EXPECT_EQ(on.base->segment_count(), 12u - 4 + 12);
    EXPECT_EQ(on.base->axes[2].parent_segment, branch.parent_segment) << "where the branch stood";
    auto const shown = after(HideBranchTool { HideBranchTool::What::None }, {}, on);
    EXPECT_EQ(shown.base->segment_count(), 24u);
}

TEST(PlantTools, HideTheBranchesThatAreSelected)
{
    auto scene = small_scene();
    EXPECT_FALSE(tools::Tool(HideBranchTool {}).edits_for({}, scene)) << "nothing is selected";
    EXPECT_FALSE(tools::Tool(HideBranchTool { HideBranchTool::What::None }).edits_for({}, scene));
    auto path = segments_of(scene.base->axes[2]);
    path.insert(path.begin(), { 0, 1, 2 }); // A path selected by pen begins at the ground.
    select(scene, { path });
    auto const hidden = after(HideBranchTool {}, {}, scene);
    EXPECT_EQ(hidden.base->segment_count(), 8u) << "the stem stays";
    auto const shown = after(HideBranchTool { HideBranchTool::What::None }, {}, hidden);
    EXPECT_EQ(shown.base->node_position_mm, scene.base->node_position_mm);
}

} // namespace
} // namespace tractus::plants
