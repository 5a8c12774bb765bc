#include "app/document/document.h"
#include "app/methods/all_methods.h"
#include "app/methods/silhouettes/outline_previewer.h"
#include "app/session/edit_record.h"
#include "tests/app/methods/silhouettes/drawn_trees.h"

namespace tractus::silhouette {
namespace {

using namespace drawn_trees;
using Part = DrawTree::Part;

// Returns a crown whose lowest point is at y = -20 mm.
Stroke crown_above()
{
    return crown_around(0, 10);
}

Stroke trunk_up_to(double top, double x = 0)
{
    return stroke_through({ { x, top - 40, 150 }, { x + 1, top - 20, 150 }, { x, top, 150 } });
}

OutlineTool as_at_first()
{
    return { .reads = OutlineTool::Reads::AsAtFirst };
}

// The trunk ends 4 mm below the place where the crown is drawn afterwards.
TEST(TrunkReachTool, TheCrownAboveATrunkIsItsCrown)
{
    auto const stem = after({}, trunk_up_to(-24));
    auto const edit = meant(crown_above(), stem);
    EXPECT_EQ(edit.part, Part::Outline);
    EXPECT_EQ(edit.plant, stem.state.active);
    EXPECT_NEAR(edit.trunk_goes_on_mm, 4 + 0.85 * 60, 1);
    auto const tree = scene::apply_edit(stem, edit).value();
    EXPECT_EQ(tree.plants.size(), 1u);
    EXPECT_GT(tree.base->axes.size(), 20u);
    auto const apart = meant(crown_above(), stem, as_at_first());
    EXPECT_EQ(apart.plant, 0u) << "as logs have it from before";
    EXPECT_EQ(apart.trunk_goes_on_mm, 0);
    EXPECT_EQ(meant(crown_above(), after({}, trunk_up_to(-30))).plant, 0u) << "10 mm are too many";
    EXPECT_EQ(meant(crown_above(), after({}, trunk_up_to(-24, 33))).plant, 0u) << "beside it";
}

TEST(TrunkReachTool, TheTrunkBelowACrownIsItsTrunk)
{
    auto const alone = after({}, crown_above());
    for (double const top : { -24.0, 5.0 }) {
        auto const edit = meant(trunk_up_to(top), alone);
        EXPECT_EQ(edit.part, Part::Trunk) << top;
        EXPECT_EQ(edit.plant, alone.state.active) << top;
        EXPECT_EQ(edit.trunk_goes_on_mm > 0, top < -20) << top;
        auto const tree = scene::apply_edit(alone, edit).value();
        EXPECT_EQ(tree.plants.size(), 1u);
        EXPECT_EQ(meant(trunk_up_to(top), alone, as_at_first()).plant, 0u) << top;
        // A crown that has a trunk is not given another trunk.
        EXPECT_EQ(meant(trunk_up_to(-24, 15), tree).plant, 0u) << top;
    }
}

// The crown is drawn anew three times: within the trunk's reach, around the trunk's tip, and out of
// reach.
TEST(TrunkReachTool, OutlastsACrownThatIsDrawnAnew)
{
    auto const tree = after(after({}, trunk_up_to(-24)), crown_above());
    auto const goes_on
        = [](scene::Scene const& scene) { return outlined_tree(*scene.drawn)->trunk_goes_on_mm; };
    auto const lower = after(tree, crown_around(0, 8));
    EXPECT_NEAR(goes_on(lower), goes_on(tree) - 2, 0.1);
    auto const around = after(tree, crown_around(0, 0));
    EXPECT_EQ(goes_on(around), 0);
    auto const higher = after(tree, crown_around(0, 15));
    EXPECT_EQ(goes_on(higher), goes_on(tree));
    for (auto const* const scene : { &lower, &around, &higher }) {
        EXPECT_EQ(scene->plants.size(), 1u);
        EXPECT_GT(scene->base->axes.size(), 20u);
    }
    auto const bare = scene::apply_edit(tree, EraseTreePart { tree.state.active, Part::Outline });
    ASSERT_TRUE(bare);
    EXPECT_NEAR(bounds(*bare->base).max_mm.z() * bare->placement.scale, 40, 1) << "as drawn";
}

TEST(TrunkReachTool, IsKeptBySessionsAndLogs)
{
    auto const edit = meant(crown_above(), after({}, trunk_up_to(-24)));
    auto const again
        = session::edit_of(session::record_of(edit), methods::all_methods().edits).value();
    EXPECT_EQ(again.get<DrawTree>()->trunk_goes_on_mm, edit.trunk_goes_on_mm);
    auto const usual = session::record_of(meant(crown_above(), after({}, trunk_at(0))));
    EXPECT_EQ(usual.fields.find("trunk_goes_on"), std::string::npos) << "as it always was";
    // The words in a log must give the same tool again.
    auto const words = tools::words_for(tools::Tool(OutlineTool {}));
    auto const tool
        = tools::parse_tool(methods::all_methods().tools, words.name, words.arguments).value();
    document::Document document({}, document::Document::Working::AtOnce);
    document.draw({ trunk_up_to(-24), tool });
    document.draw({ crown_above(), tool });
    auto const& scene = document.newest()->scene;
    EXPECT_EQ(scene.plants.size(), 1u);
    EXPECT_EQ(scene.base->node_position_mm,
              after(after({}, trunk_up_to(-24)), crown_above()).base->node_position_mm);
}

TEST(TrunkReachTool, RefusesWhatIsNoWay)
{
    auto const stem = after({}, trunk_up_to(-24));
    auto edit = meant(crown_above(), stem);
    for (double const wrong : { -1.0, 1e9, std::nan("") }) {
        edit.trunk_goes_on_mm = wrong;
        auto const refused = scene::apply_edit(stem, edit);
        ASSERT_FALSE(refused) << wrong;
        EXPECT_NE(refused.error().message.find("the trunk cannot go on by"), std::string::npos);
    }
}

} // namespace
} // namespace tractus::silhouette
