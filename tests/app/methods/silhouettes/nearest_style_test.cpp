#include "engine/methods/silhouettes/nearest_style.h"

#include "engine/methods/silhouettes/measured_style.h"
#include "tests/app/methods/silhouettes/drawn_trees.h"

// Tests that a tree with only a crown outline takes the style of the nearest tree that has its own
// style.

namespace tractus::silhouette {
namespace {

using namespace drawn_trees;

OutlineTool oak()
{
    return { .form = OutlineTool::Form::Oak };
}

OutlinedTree const& tree_of(scene::Scene const& scene, scene::ItemId plant)
{
    return *outlined_tree(*scene.state.plants[scene::plant_number(scene.state, plant).value()]);
}

Plant const& plant_of(scene::Scene const& scene, scene::ItemId plant)
{
    return *scene.plants[scene::plant_number(scene.state, plant).value()]->base;
}

// Returns the scene with an additional tree that has a trunk and a crown, with ids from `id`.
scene::Scene with_tree(scene::Scene const& scene, double x_mm, scene::ItemId id,
                       OutlineTool const& tool = {})
{
    auto trunk = meant(trunk_at(x_mm), scene, tool);
    trunk.id = id;
    auto const begun = scene::apply_edit(scene, trunk);
    EXPECT_TRUE(begun) << begun.error().message;
    auto crown = meant(crown_around(x_mm, 10), *begun, tool);
    EXPECT_EQ(crown.plant, id);
    return scene::apply_edit(*begun, crown).value();
}

// Returns the scene after an edit, including the dependent edits that belong to the same step.
scene::Scene stepped(scene::Scene const& scene, scene::Edit const& edit)
{
    auto step = std::vector { edit };
    auto const more = dependent_style_edits(scene, step);
    step.insert(step.end(), more.begin(), more.end());
    return scene::apply_edits(scene, step).value();
}

// Returns the form of trees that are newly begun.
TreeForm begun_form()
{
    return { .has_whole_nodes = true,
             .plane_branches = kUsualPlaneBranches,
             .leaves_reach_outline = true };
}

TreeForm style_of(scene::Scene const& scene, scene::ItemId plant)
{
    return with_style_of(begun_form(), plant_of(scene, plant)).value();
}

TEST(NearestStyle, IsTakenByATreeOfWhichNobodySaysMore)
{
    auto const alone = with_tree({}, -100, 10);
    EXPECT_FALSE(has_own_style(tree_of(alone, 10)));
    EXPECT_TRUE(takes_style(tree_of(alone, 10)));
    EXPECT_EQ(tree_of(alone, 10).form, begun_form()) << "there is nothing to take";

    auto const first = with_tree({}, -100, 10, oak());
    EXPECT_TRUE(has_own_style(tree_of(first, 10)));
    auto const scene = with_tree(first, 0, 20);
    EXPECT_EQ(tree_of(scene, 20).form, style_of(first, 10));
    EXPECT_NE(tree_of(scene, 20).form, begun_form());
    EXPECT_FALSE(has_own_style(tree_of(scene, 20))) << "nobody takes what is taken";
}

TEST(NearestStyle, IsThatOfTheNearestTree)
{
    auto const pine = OutlineTool { .form = OutlineTool::Form::Pine };
    auto scene = with_tree(with_tree({}, -150, 10, oak()), 150, 20, pine);
    scene = with_tree(with_tree(scene, -60, 30), 60, 40);
    EXPECT_EQ(tree_of(scene, 30).form, style_of(scene, 10));
    EXPECT_EQ(tree_of(scene, 40).form, style_of(scene, 20));
    EXPECT_NE(style_of(scene, 10), style_of(scene, 20));
    // After plant 20 has moved, it is the nearest tree with a style.
    auto const moved = stepped(scene, scene::MovePlant { 20, Vec3(-70, 0, 0) });
    EXPECT_EQ(tree_of(moved, 30).form, style_of(moved, 20));
    auto const removed = stepped(scene, scene::RemovePlant { 10 });
    EXPECT_EQ(tree_of(removed, 30).form, style_of(removed, 20));
}

// A tree is drawn first. When its neighbour is refined later, it takes the neighbour's new style.
TEST(NearestStyle, FollowsARefinedTree)
{
    auto const drawn = with_tree(with_tree({}, 100, 10), 0, 20);
    EXPECT_EQ(tree_of(drawn, 10).form, begun_form());
    auto own = meant(lobe_of_crown(), drawn, { .branches = OutlineTool::Branches::OfTrunk });
    ASSERT_EQ(own.part, DrawTree::Part::OwnOutline);
    own.id = 30;
    auto const refined = stepped(drawn, own);
    EXPECT_TRUE(has_own_style(tree_of(refined, 20)));
    EXPECT_EQ(tree_of(refined, 10).form, style_of(refined, 20));
    EXPECT_NE(tree_of(refined, 10).form, begun_form());
    // The style must not be taken again if nothing that matters to it has changed.
    EXPECT_TRUE(
        dependent_style_edits(refined, { scene::SetScale { refined.placement.scale } }).empty());
    // If the user has set the form of the tree, it no longer takes a style.
    auto const formed = scene::apply_edit(refined, FormTree { 10, {} }).value();
    EXPECT_FALSE(takes_style(tree_of(formed, 10)));
    EXPECT_TRUE(
        dependent_style_edits(formed, { EraseTreePart { 20, DrawTree::Part::OwnOutline, 30 } })
            .empty());
}

TEST(NearestStyle, IsNotTakenByNumbersThatSomebodyChose)
{
    auto const first = with_tree({}, -100, 10, oak());
    OutlineTool many;
    many.density = 2;
    EXPECT_FALSE(tree_of(with_tree(first, 0, 20, many), 20).takes_style);
    OutlineTool const as_logs { .reads = OutlineTool::Reads::AsAtFirst };
    auto const scene = with_tree(first, 0, 20, as_logs);
    EXPECT_FALSE(tree_of(scene, 20).takes_style);
    EXPECT_EQ(tree_of(scene, 20).form, begun_form());
}

TEST(NearestStyle, StaysWhereChanceIsAnother)
{
    auto scene = with_tree(with_tree({}, -100, 10, oak()), 0, 20);
    tools::Tool const reseed(OutlineTool { .what = OutlineTool::What::Reseed });
    auto const edits = reseed.kind().edits_for(reseed, {}, scene);
    ASSERT_TRUE(edits) << edits.error().message;
    scene = scene::apply_edits(scene, *edits).value();
    EXPECT_TRUE(takes_style(tree_of(scene, 20)));
    EXPECT_EQ(tree_of(scene, 20).form.styles, style_of(scene, 10).styles);
}

} // namespace
} // namespace tractus::silhouette
