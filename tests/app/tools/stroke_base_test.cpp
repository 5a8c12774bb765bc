// Tests of strokes that were drawn from the tip of a branch or limb to its foot.
#include "app/tools/stroke_base.h"

#include "app/document/draw.h"
#include "app/methods/all_methods.h"
#include "app/tools/bent_plant.h"
#include "app/tools/draw_in_order_tool.h"
#include "app/tools/draw_tool.h"
#include "app/tools/limb_tool.h"
#include "app/tools/turn_stroke_tool.h"
#include "engine/plant/join_axes.h"
#include "tests/app/small_model.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace tractus::tools {
namespace {

// Returns a stroke through the positions in reverse order.
Stroke reversed_stroke(std::vector<Vec3> places_mm)
{
    std::reverse(places_mm.begin(), places_mm.end());
    return stroke_through(places_mm);
}

std::vector<Vec3> bowed_trunk(scene::Scene const& scene)
{
    Vec3 const foot_mm = scene.placement.origin_mm;
    return { foot_mm, foot_mm + Vec3(20, 0, 60), foot_mm + Vec3(10, 5, 150) };
}

// Returns the positions of a branch's ends and middle as they are displayed.
std::vector<Vec3> along_branch(scene::Scene const& scene, std::vector<SegmentId> const& branch)
{
    BentPlant const bent(scene);
    Vec3 const from_mm = bent.begin_of(branch.front());
    Vec3 const to_mm = bent.end_of(branch.back());
    return { from_mm, 0.5 * (from_mm + to_mm) + Vec3(0, 0, 3), to_mm };
}

std::vector<Vec3> bent_nodes(scene::Scene const& scene)
{
    return BentPlant(scene).nodes_mm();
}

double lowest_mm(scene::Scene const& scene)
{
    double lowest = 0;
    for (auto const& node_mm : bent_nodes(scene))
        lowest = std::min(lowest, node_mm.z());
    return lowest;
}

TEST(StrokeBase, ATrunkDrawnFromItsTopIsTurnedRoundAndSaysSo)
{
    auto const begun = small_scene();
    auto upright = begun;
    auto turned = begun;
    ASSERT_TRUE(document::draw(stroke_through(bowed_trunk(begun)), DrawInOrderTool {}, upright)
                    .refusal.empty());
    auto const said
        = document::draw(reversed_stroke(bowed_trunk(begun)), DrawInOrderTool {}, turned);
    ASSERT_TRUE(said.refusal.empty()) << said.refusal;
    EXPECT_TRUE(turned.drawn->strokes[0].what.is_drawn_reversed);
    EXPECT_FALSE(upright.drawn->strokes[0].what.is_drawn_reversed);
    EXPECT_NE(bent_branch_message(Tool(DrawInOrderTool {}), turned).find("\"Turn round\""),
              std::string::npos);
    EXPECT_EQ(bent_branch_message(Tool(DrawInOrderTool {}), upright), "");
    auto const as_upright = bent_nodes(upright);
    auto const as_turned = bent_nodes(turned);
    for (std::size_t i = 0; i < as_upright.size(); ++i)
        EXPECT_LT((as_upright[i] - as_turned[i]).norm(), 1e-6) << i;
    EXPECT_GT(lowest_mm(turned), -1e-6);
    // One touch turns the stroke back: the tree hangs down, as drawn.
    ASSERT_TRUE(document::draw({}, TurnStrokeTool {}, turned).refusal.empty());
    EXPECT_LT(lowest_mm(turned), -10);
    EXPECT_EQ(bent_branch_message(Tool(TurnStrokeTool {}), turned).find("ran from"),
              std::string::npos);
}

TEST(StrokeBase, ABranchDrawnFromItsTipToItsFootIsTurnedRound)
{
    auto scene = small_scene();
    auto const branch = segments_of(scene.base->axes[1]);
    select(scene, { branch });
    auto const line = along_branch(scene, branch);
    for (auto const propagation :
         { variation::Propagation::Selected, variation::Propagation::Both }) {
        auto const edits
            = Tool(DrawTool { propagation }).edits_for(reversed_stroke(line), scene).value();
        auto const& drawn = *edits.front().get<scene::Associate>();
        EXPECT_TRUE(drawn.is_drawn_reversed);
        EXPECT_LT((drawn.stroke.tips.front().position_mm - line.front()).norm(), 1e-9);
    }
    auto const is_reversed = [&](Stroke const& stroke, DrawTool const& tool) {
        auto const edits = Tool(tool).edits_for(stroke, scene).value();
        return edits.front().get<scene::Associate>()->is_drawn_reversed;
    };
    EXPECT_FALSE(is_reversed(stroke_through(line), {}));
    EXPECT_FALSE(is_reversed(reversed_stroke(line), { variation::Propagation::Descendants }))
        << "what the branch bears has feet elsewhere";
    for (auto& place_mm : std::vector(line))
        EXPECT_FALSE(is_reversed(
            reversed_stroke({ place_mm + Vec3(70, 0, 0), place_mm + Vec3(120, 0, 20) }), {}))
            << "drawn elsewhere";
}

TEST(StrokeBase, LogsOlderThanItKeepTheirPlants)
{
    auto scene = small_scene();
    auto const stroke = reversed_stroke(bowed_trunk(scene));
    auto const kinds = methods::all_methods().tools;
    for (auto const* words : { "", "chord heading" }) {
        auto const tool = parse_tool(kinds, "draw_in_order", words).value();
        auto const edits = tool.edits_for(stroke, scene).value();
        auto const& drawn = *edits.back().get<scene::Associate>();
        EXPECT_FALSE(drawn.is_drawn_reversed) << words;
        EXPECT_EQ(drawn.stroke.tips.id(), stroke.tips.id()) << words;
    }
    for (auto const& tool : { Tool(DrawTool {}), Tool(DrawInOrderTool {}), Tool(LimbTool {}) })
        EXPECT_NE(words_for(tool).arguments.find("from_foot"), std::string::npos);
}

TEST(StrokeBase, ALimbDrawnFromItsTipStandsOnItsBranch)
{
    auto const scene = small_scene();
    BentPlant const bent(scene);
    Vec3 const on_trunk_mm = bent.end_of(segments_of(scene.base->axes[0])[4]);
    std::vector<Vec3> const line { on_trunk_mm, on_trunk_mm + Vec3(0, 30, 10),
                                   on_trunk_mm + Vec3(0, 60, 25) };
    auto const rising = drawn_limb({}, stroke_through(line), scene).value();
    auto const falling = drawn_limb({}, reversed_stroke(line), scene).value();
    EXPECT_FALSE(rising.is_drawn_reversed);
    EXPECT_TRUE(falling.is_drawn_reversed);
    EXPECT_EQ(falling.at, rising.at);
    EXPECT_LT((falling.joint_mm - rising.joint_mm).norm(), 1e-9);
    auto const as_drawn = drawn_limb({ .base = StrokeBase::AsDrawn }, reversed_stroke(line), scene);
    EXPECT_TRUE(!as_drawn || !as_drawn->is_drawn_reversed);
    auto after = scene;
    ASSERT_TRUE(document::draw(reversed_stroke(line), LimbTool {}, after).refusal.empty());
    EXPECT_NE(LimbTool::kKind.describe(Tool(LimbTool {}), after).find("turned round"),
              std::string::npos);
    // A limb from one branch to another stays as drawn.
    Vec3 const on_branch_mm = bent.end_of(segments_of(scene.base->axes[2]).back());
    EXPECT_FALSE(
        drawn_limb({}, stroke_through({ on_branch_mm, on_trunk_mm }), scene)->is_drawn_reversed);
}

} // namespace
} // namespace tractus::tools
