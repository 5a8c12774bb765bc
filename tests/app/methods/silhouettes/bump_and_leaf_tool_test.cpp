#include "app/document/document.h"
#include "app/methods/all_methods.h"
#include "app/methods/silhouettes/erase_outline_tool.h"
#include "app/methods/silhouettes/outline_layer.h"
#include "app/methods/silhouettes/outline_previewer.h"
#include "app/session/edit_record.h"
#include "tests/app/methods/silhouettes/drawn_trees.h"

#include <gtest/gtest.h>
#include <memory>
#include <tuple>

namespace tractus::silhouette {
namespace {

using namespace drawn_trees;
using silhouette::DrawTree;

// Returns the short stroke that the pen draws in a tap at a position.
Stroke tap(double x, double y)
{
    return stroke_through({ { x, y, 150 }, { x + 0.3, y + 0.1, 150 }, { x, y + 0.1, 150 } });
}

tools::Tool with_what(OutlineTool::What what)
{
    return OutlineTool { .what = what };
}

std::size_t bumps_of_crown(scene::Scene const& scene)
{
    return silhouette::skeleton_of(*silhouette::outlined_tree(*scene.drawn))
        .value()
        .systems[0]
        .bumps.size();
}

// One touch splits the crown's upper right lobe; another joins that lobe and the lower right one.
// Both effects can be undone and erased, and logs must keep them.
TEST(OutlineTool, SplitsAndJoinsBumps)
{
    using What = OutlineTool::What;
    document::Document document({}, document::Document::Working::AtOnce);
    for (auto const& stroke : { trunk_at(0), crown_around(0, 10) })
        document.draw({ stroke, OutlineTool {} });
    auto const scene = [&] { return document.newest()->scene; };
    auto const before = bumps_of_crown(scene());
    auto const nodes = scene().base->node_position_mm;
    for (auto const& [what, more, place, words] :
         { std::tuple(What::Split, 1, Vec2(22, 32),
                      "split of_any siblings foot_first whole_nodes fills_by_species"),
           std::tuple(What::Join, -1, Vec2(30, 10),
                      "join of_any siblings foot_first whole_nodes fills_by_species") }) {
        auto const tool = with_what(what);
        EXPECT_EQ(tools::words_for(tool).arguments, words);
        EXPECT_EQ(tools::parse_tool(methods::all_methods().tools, "outline", words).value(), tool);
        document.draw({ tap(place.x(), place.y()), tool });
        EXPECT_EQ(static_cast<int>(bumps_of_crown(scene())) - static_cast<int>(before), more);
        auto const touched = scene().base->node_position_mm;
        EXPECT_NE(touched, nodes);
        auto const& touches = silhouette::outlined_tree(*scene().drawn)->touches;
        ASSERT_EQ(touches.size(), 1u);
        EXPECT_EQ(kTrunkLayer.lines(scene()).size(), what == What::Split ? 3u : 2u) << "its mark";
        document.undo();
        EXPECT_EQ(scene().base->node_position_mm, nodes);
        document.redo();
        EXPECT_EQ(scene().base->node_position_mm, touched);
        document.draw({ stroke_through({ { place.x() - 3, place.y(), 0 },
                                         { place.x() + 3, place.y() + 1, 0 } }),
                        EraseOutlineTool {} });
        EXPECT_TRUE(silhouette::outlined_tree(*scene().drawn)->touches.empty());
        EXPECT_EQ(bumps_of_crown(scene()), before);
    }
    auto const shared = std::make_shared<scene::Scene const>(scene());
    tools::Tool const split = with_what(What::Split);
    EXPECT_GT(outline_previewer()->show({ shared, split, tap(22, 32).tips.vector(), 99 }).size(),
              outline_previewer()->show({ shared, split, tap(900, 0).tips.vector(), 99 }).size());
    auto const beside
        = scene::apply_edit(scene(), meant(tap(900, 0), scene(), { .what = What::Split }));
    ASSERT_FALSE(beside);
    EXPECT_NE(beside.error().message.find("on no bump"), std::string::npos);
    EXPECT_FALSE(split.edits_for(tap(0, 0), small_scene())) << "no tree with an outline";
}

TEST(OutlineTool, WritesTouchesInSessions)
{
    auto const tree = crowned();
    auto const edit = meant(tap(22, 32), tree, { .what = OutlineTool::What::Split });
    auto const again
        = session::edit_of(session::record_of(edit), methods::all_methods().edits).value();
    EXPECT_EQ(again.get<DrawTree>()->part, DrawTree::Part::Split);
    EXPECT_EQ(scene::apply_edit(tree, again)->base->node_position_mm,
              scene::apply_edit(tree, edit)->base->node_position_mm);
    silhouette::DeclareLeaf const leaf { tree.state.active, 0, true };
    EXPECT_EQ(session::record_of(leaf).fields.find("outline"), std::string::npos) << "the crown's";
    auto const declared
        = session::edit_of(session::record_of(leaf), methods::all_methods().edits).value();
    EXPECT_TRUE(declared.get<silhouette::DeclareLeaf>()->is_leaf);
    auto const usual = session::record_of(meant(lobe_of_crown(), tree));
    EXPECT_EQ(usual.fields.find("is_leaf"), std::string::npos) << "as before there were leaves";
}

// An outline is drawn as a leaf, reverted to a crown by a touch, declared a leaf again, and undone.
TEST(OutlineTool, DeclaresOutlinesLeaves)
{
    tools::Tool const leaf = with_what(OutlineTool::What::Leaf);
    EXPECT_EQ(tools::words_for(leaf).arguments,
              "leaf of_any siblings foot_first whole_nodes fills_by_species");
    document::Document document({}, document::Document::Working::AtOnce);
    for (auto const& stroke : { trunk_at(0), crown_around(0, 10) })
        document.draw({ stroke, OutlineTool {} });
    auto const scene = [&] { return document.newest()->scene; };
    auto const tree = [&] { return *silhouette::outlined_tree(*scene().drawn); };
    auto const before = scene().base->node_position_mm;
    document.draw({ lobe_of_crown(), leaf });
    ASSERT_EQ(tree().own_outlines.size(), 1u);
    EXPECT_TRUE(tree().own_outlines[0].is_leaf);
    EXPECT_EQ(OutlineTool::kKind.describe(leaf, scene()),
              "The branch ends in the leaf; its siblings follow");
    auto const axes = scene().base->axes.size();
    EXPECT_EQ(scene().base->organs.size(), axes - 1) << "nothing but leaves";
    document.draw({ tap(20, 30), leaf });
    EXPECT_FALSE(tree().own_outlines[0].is_leaf);
    EXPECT_NE(scene().base->axes.size(), axes);
    document.draw({ tap(20, 30), leaf });
    EXPECT_EQ(scene().base->axes.size(), axes);
    document.draw({ tap(0, 10), leaf });
    EXPECT_TRUE(tree().is_leaf) << "the crown's outline";
    EXPECT_EQ(scene().base->organs.size(), 1u);
    EXPECT_NE(OutlineTool::kKind.describe(leaf, scene()).find("The crown is a leaf"),
              std::string::npos);
    document.draw({ tap(0, 10), leaf });
    EXPECT_EQ(scene().base->axes.size(), axes);
    for (int i = 0; i < 5; ++i)
        document.undo();
    EXPECT_EQ(scene().base->node_position_mm, before);
    auto const beside = leaf.edits_for(tap(900, 0), scene());
    ASSERT_FALSE(beside);
    EXPECT_NE(beside.error().message.find("lies in no outline"), std::string::npos);
}

TEST(OutlineTool, BeginsATreeThatIsALeaf)
{
    auto const scene = after({}, crown_around(0, 10), { .what = OutlineTool::What::Leaf });
    EXPECT_TRUE(silhouette::outlined_tree(*scene.drawn)->is_leaf);
    EXPECT_EQ(scene.base->organs.size(), 1u);
}

} // namespace
} // namespace tractus::silhouette
