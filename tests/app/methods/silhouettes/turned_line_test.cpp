// Tests of trunks and branches of an outlined tree that were drawn from their tip to their foot.
#include "app/methods/all_methods.h"
#include "app/methods/silhouettes/outline_tool.h"
#include "app/session/edit_record.h"
#include "tests/app/methods/silhouettes/drawn_trees.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace tractus::silhouette {
namespace {

using namespace drawn_trees;
using Part = DrawTree::Part;

// The stroke from its last position to its first.
Stroke downwards(Stroke const& stroke)
{
    std::vector<Vec3> places;
    for (auto const& tip : stroke.tips)
        places.push_back(tip.position_mm);
    std::reverse(places.begin(), places.end());
    std::vector<TipSample> tips(stroke.tips.begin(), stroke.tips.end());
    for (std::size_t i = 0; i < tips.size(); ++i)
        tips[i].position_mm = places[i];
    return { std::move(tips) };
}

OutlineTool closely()
{
    return { .reads = OutlineTool::Reads::Closely };
}

std::string told(OutlineTool const& tool, scene::Scene const& scene)
{
    return OutlineTool::kKind.describe(tools::Tool(tool), scene);
}

TEST(TurnedLine, ATrunkFromItsTopIsThatFromItsFoot)
{
    auto const edit = meant(downwards(trunk_at(0)), {});
    EXPECT_TRUE(edit.is_drawn_reversed);
    auto const upright = crowned();
    auto const turned = after(after({}, downwards(trunk_at(0))), crown_around(0, 10));
    ASSERT_EQ(turned.plants.size(), 1U);
    EXPECT_EQ(turned.base->node_position_mm, upright.base->node_position_mm);
    EXPECT_EQ(turned.state.plants[0]->stands_at_mm, upright.state.plants[0]->stands_at_mm);
    EXPECT_NE(told({}, after({}, downwards(trunk_at(0)))).find("turned round"), std::string::npos);
    EXPECT_EQ(told({}, turned).find("turned round"), std::string::npos)
        << "the crown was drawn since then";
    // Logs that are older read the stroke as drawn.
    EXPECT_FALSE(meant(downwards(trunk_at(0)), {}, closely()).is_drawn_reversed);
}

TEST(TurnedLine, ATrunkFromTheCrownDownIsTheCrownsTrunk)
{
    auto const alone = after({}, crown_around(0, 10));
    auto const edit = meant(downwards(trunk_at(0)), alone);
    EXPECT_TRUE(edit.is_drawn_reversed);
    EXPECT_EQ(edit.part, Part::Trunk);
    EXPECT_EQ(edit.plant, alone.state.active);
    EXPECT_NE(meant(downwards(trunk_at(0)), alone, closely()).part, Part::Trunk);
    // The trunk of a tree that has one is drawn anew from its top.
    auto const again = meant(downwards(trunk_at(1)), crowned());
    EXPECT_TRUE(again.is_drawn_reversed);
    EXPECT_EQ(again.part, Part::Trunk);
}

TEST(TurnedLine, ABranchFromItsTipBeginsOnTheTrunk)
{
    auto const tree = crowned();
    auto const branch = stroke_through({ { 1, 2, 150 }, { 13, 13, 150 }, { 27, 22, 150 } });
    auto const usual = meant(branch, tree);
    auto const edit = meant(downwards(branch), tree);
    EXPECT_FALSE(usual.is_drawn_reversed);
    EXPECT_TRUE(edit.is_drawn_reversed);
    EXPECT_EQ(edit.part, usual.part);
    EXPECT_EQ(scene::apply_edit(tree, edit)->base->node_position_mm,
              scene::apply_edit(tree, usual)->base->node_position_mm);
}

TEST(TurnedLine, OneTouchTurnsALineBack)
{
    auto const turned = after(after({}, crown_around(0, 10)), downwards(trunk_at(0)));
    OutlineTool const tool { .what = OutlineTool::What::TurnRound };
    auto const touch = stroke_through({ { 1, -40, 150 }, { 1, -40, 150 } });
    auto const edits = tools::Tool(tool).edits_for(touch, turned);
    ASSERT_TRUE(edits) << edits.error().message;
    auto const back = scene::apply_edits(turned, *edits).value();
    EXPECT_EQ(foot_of(*outlined_tree(*back.drawn))->y(), 20) << "it hangs";
    EXPECT_EQ(told(tool, back), "The line is turned round");
    auto const twice
        = scene::apply_edits(back, tools::Tool(tool).edits_for(touch, back).value()).value();
    EXPECT_EQ(twice.base->node_position_mm, turned.base->node_position_mm);
    auto const beside = stroke_through({ { 60, -40, 150 }, { 60, -40, 150 } });
    EXPECT_FALSE(tools::Tool(tool).edits_for(beside, turned));
}

TEST(TurnedLine, IsKeptBySessions)
{
    auto const edit = meant(downwards(trunk_at(0)), {});
    auto const again
        = session::edit_of(session::record_of(edit), methods::all_methods().edits).value();
    EXPECT_TRUE(again.get<DrawTree>()->is_drawn_reversed);
    EXPECT_EQ(session::record_of(meant(trunk_at(0), {})).fields.find("turned_round"),
              std::string::npos)
        << "as it always was";
}

} // namespace
} // namespace tractus::silhouette
