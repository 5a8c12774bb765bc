#include "app/document/document.h"
#include "app/methods/all_methods.h"
#include "app/session/edit_record.h"
#include "engine/methods/silhouettes/bump_leaf.h"
#include "tests/app/methods/silhouettes/drawn_trees.h"

#include <algorithm>

namespace tractus::silhouette {
namespace {

using namespace drawn_trees;

Stroke bump_touch_at(Vec2 const& place)
{
    return stroke_through({ { place.x(), place.y(), 150 }, { place.x(), place.y() + 0.1, 150 } });
}

OutlineTool leaf_tool(StyleScope style = StyleScope::Siblings)
{
    return { .what = OutlineTool::What::Leaf, .style = style };
}

// A position in the crown's upper right lobe, in mm on the sheet.
Vec2 const kLobe(20, 30);

// Fixture with a tree whose crown has four lobes.
class BumpLeafTool : public ::testing::Test {
protected:
    BumpLeafTool()
    {
        for (auto const& stroke : { trunk_at(0), crown_around(0, 10) })
            document_.draw({ stroke, OutlineTool {} });
    }

    void touch(Vec2 const& place, OutlineTool const& tool = leaf_tool())
    {
        auto const meant = tools::Tool(tool).edits_for(bump_touch_at(place), scene());
        EXPECT_TRUE(meant) << meant.error().message;
        document_.draw({ bump_touch_at(place), tool });
    }
    scene::Scene scene() const { return document_.newest()->scene; }
    OutlinedTree tree() const { return *outlined_tree(*scene().drawn); }
    std::size_t axes() const { return scene().base->axes.size(); }
    std::size_t leaves_on_trunk() const
    {
        auto const skeleton = skeleton_of(tree()).value();
        return static_cast<std::size_t>(
            std::count_if(skeleton.systems[0].branches.begin(), skeleton.systems[0].branches.end(),
                          [](Branch const& branch) { return branch.leaf.has_value(); }));
    }

    document::Document document_ { {}, document::Document::Working::AtOnce };
};

TEST_F(BumpLeafTool, DeclaresABumpALeafAndTakesItBack)
{
    auto const before = scene().base->node_position_mm;
    auto const bump = leaf_on_bump(tree(), bump_touch_at(kLobe), Search::AnyLevel).value();
    ASSERT_TRUE(bump);
    touch(kLobe, leaf_tool(StyleScope::None));
    ASSERT_EQ(tree().own_outlines.size(), 1u);
    auto const own = tree().own_outlines[0];
    EXPECT_TRUE(own.is_leaf && own.of_bump);
    EXPECT_EQ(own.branch, bump->branch);
    EXPECT_GE(leaves_on_trunk(), 1u);
    EXPECT_LE(leaves_on_trunk(), 6u) << "its copies";
    auto const skeleton = skeleton_of(tree()).value();
    auto const& branch = skeleton.systems[0].branches[skeleton.at(own.branch)->branch];
    EXPECT_NEAR(signed_area(branch.crown), signed_area(bump->outline),
                0.05 * signed_area(bump->outline));
    EXPECT_EQ(OutlineTool::kKind.describe(leaf_tool(), scene()), "The branch ends in the leaf");
    touch(kLobe);
    EXPECT_TRUE(tree().own_outlines.empty());
    EXPECT_EQ(scene().base->node_position_mm, before) << "as if there had been none";
}

TEST_F(BumpLeafTool, SiblingsTakeItAsTheyDoADrawnOne)
{
    touch(kLobe);
    auto const branches = skeleton_of(tree()).value().systems[0].branches.size();
    EXPECT_EQ(leaves_on_trunk(), branches);
    EXPECT_EQ(axes(), scene().base->organs.size() + 1) << "nothing but leaves";
    ASSERT_EQ(tree().own_outlines.size(), 1u);
    // Drawing the outline of the same leaf must have the same effect as the touch.
    document::Document drawn({}, document::Document::Working::AtOnce);
    for (auto const& stroke : { trunk_at(0), crown_around(0, 10) })
        drawn.draw({ stroke, OutlineTool {} });
    drawn.draw({ tree().own_outlines[0].stroke, leaf_tool() });
    EXPECT_EQ(drawn.newest()->scene.base->node_position_mm, scene().base->node_position_mm);
}

// A touch outside the bumps concerns the outline around it, as all touches do in older logs.
TEST_F(BumpLeafTool, LeavesTheCrownsMiddleToTheCrown)
{
    touch({ 0, 10 });
    EXPECT_TRUE(tree().is_leaf);
    touch(kLobe);
    EXPECT_FALSE(tree().is_leaf) << "a crown that is a leaf has no bumps";
    auto old = leaf_tool();
    old.reads = OutlineTool::Reads::AsAtFirst;
    touch(kLobe, old);
    EXPECT_TRUE(tree().is_leaf);
    EXPECT_TRUE(tree().own_outlines.empty());
}

// A bump of a branch's own outline is made a leaf, and then the crown's bump that contains this
// outline.
TEST_F(BumpLeafTool, IsOfTheSmallestOutline)
{
    document_.draw({ lobe_of_crown(), OutlineTool { .style = StyleScope::None } });
    ASSERT_EQ(tree().own_outlines.size(), 1u);
    auto const limb = tree().own_outlines[0].branch;
    auto const skeleton = skeleton_of(tree()).value();
    auto const at = skeleton.at(limb).value();
    auto const& boughs = skeleton.systems[skeleton.system_of[at.system][at.branch]].branches;
    ASSERT_EQ(boughs.front().origin, Branch::Origin::Bump);
    touch(boughs.front().path.curve.end, leaf_tool(StyleScope::None));
    ASSERT_EQ(tree().own_outlines.size(), 2u);
    EXPECT_TRUE(tree().own_outlines[1].branch.starts_with(limb + kPathSeparator));
    EXPECT_TRUE(tree().own_outlines[1].is_leaf);
    EXPECT_EQ(count_without_effect(tree()).value(), 0u);
    auto of_trunk = leaf_tool(StyleScope::None);
    of_trunk.branches = OutlineTool::Branches::OfTrunk;
    touch(tree().own_outlines[0].stroke.tips.begin()->position_mm.head<2>() - Vec2(2, 0), of_trunk);
    EXPECT_TRUE(tree().own_outlines[0].is_leaf) << "the limb's own outline, on the crown's bump";
    EXPECT_EQ(count_without_effect(tree()).value(), 1u);
}

TEST_F(BumpLeafTool, OutlastsACrownThatIsDrawnAnewAndASession)
{
    touch(kLobe);
    ASSERT_EQ(tree().own_outlines.size(), 1u);
    auto const path = tree().own_outlines[0].branch;
    auto const stroke = tree().own_outlines[0].stroke;
    document_.draw({ crown_around(0, 10.5), OutlineTool {} });
    EXPECT_EQ(tree().own_outlines[0].branch, path);
    EXPECT_GT(leaves_on_trunk(), 1u);
    DrawTree const edit { .part = DrawTree::Part::OwnOutline,
                          .stroke = stroke,
                          .is_leaf = true,
                          .of_bump = true,
                          .plant = scene().drawn->id };
    auto const again
        = session::edit_of(session::record_of(edit), methods::all_methods().edits).value();
    EXPECT_TRUE(again.get<DrawTree>()->of_bump);
    EXPECT_EQ(session::record_of(DrawTree {}).fields.find("of_bump"), std::string::npos);
}

} // namespace
} // namespace tractus::silhouette
