#include "engine/methods/silhouettes/own_outline.h"
#include "engine/methods/silhouettes/tree_edits.h"
#include "engine/scene/scene.h"
#include "tests/engine/methods/silhouettes/outlines.h"

#include <cmath>
#include <utility>

namespace tractus::silhouette {
namespace {

class OwnOutlineEdits : public ::testing::Test {
protected:
    using Part = DrawTree::Part;

    static std::vector<Vec2> disc(Vec2 const& middle, double radius)
    {
        std::vector<Vec2> points;
        for (int i = 0; i < 60; ++i)
            points.emplace_back(
                middle
                + radius
                    * Vec2(std::cos(i * kPi / 30), (1 + 0.2 * (i % 2)) * std::sin(i * kPi / 30)));
        return points;
    }

    // Outlines around the lobes on the right and on the left of the crown.
    static std::vector<Vec2> right_lobe() { return disc({ 52, -20 }, 30); }
    static std::vector<Vec2> left_lobe() { return disc({ -52, -20 }, 30); }

    static scene::Scene draw(scene::Scene const& before, Part part, std::vector<Vec2> const& points)
    {
        return draw_on(before, { .part = part, .stroke = stroke_of(points) });
    }

    static OutlinedTree const& drawing(scene::Scene const& scene)
    {
        return *outlined_tree(*scene.drawn);
    }

    // Returns the names of the branches that have outlines of their own.
    static std::vector<std::string> outlined(scene::Scene const& scene)
    {
        std::vector<std::string> names;
        auto const skeleton = skeleton_of(drawing(scene));
        EXPECT_TRUE(skeleton);
        for (auto const& branch : skeleton->systems[0].branches)
            if (branch.is_outlined())
                names.push_back(name_of(branch));
        return names;
    }
};

// The tree must be the one that the same lines give without a document.
TEST_F(OwnOutlineEdits, MakeTheTreeOfItsLines)
{
    auto const scene = draw(lobed_tree(), Part::OwnOutline, right_lobe());
    auto lines = lobed_crown(5);
    ASSERT_TRUE(add_own_outline(lines, right_lobe()));
    auto const skeleton = infer_skeleton(lines).value();
    auto const made = make_tree(skeleton, tree_options({}, drawn_height(skeleton) / 0.1));
    EXPECT_EQ(scene.base->node_position_mm, made.plant.node_position_mm);
    EXPECT_NE(scene.base->node_position_mm, lobed_tree().base->node_position_mm);
    ASSERT_EQ(drawing(scene).own_outlines.size(), 1U);
    EXPECT_EQ(outlined(scene), std::vector { drawing(scene).own_outlines[0].branch });
}

TEST_F(OwnOutlineEdits, AreTakenAwayAgain)
{
    auto const before = lobed_tree();
    auto const both
        = draw(draw(before, Part::OwnOutline, right_lobe()), Part::OwnOutline, left_lobe());
    auto const& own = drawing(both).own_outlines;
    ASSERT_EQ(own.size(), 2U);
    EXPECT_NE(own[0].id, own[1].id);
    EraseTreePart erase { both.state.active, Part::OwnOutline, own[0].id };
    auto const one = scene::apply_edit(both, erase).value();
    EXPECT_EQ(outlined(one), std::vector { own[1].branch });
    erase.branch = own[1].id;
    EXPECT_EQ(scene::apply_edit(one, erase)->base->node_position_mm, before.base->node_position_mm);
    auto const again
        = scene::apply_edit(one, EraseTreePart { both.state.active, Part::OwnOutline, 77 });
    ASSERT_FALSE(again);
    EXPECT_NE(again.error().message.find("no such part"), std::string::npos);
}

TEST_F(OwnOutlineEdits, StayWithTheirBranchWhereTheCrownIsDrawnAnew)
{
    auto const before = draw(lobed_tree(), Part::OwnOutline, right_lobe());
    auto const name = drawing(before).own_outlines[0].branch;
    for (double const size : { 0.97, 1.04 }) {
        Similarity const way { .turn = size * Vec2(std::cos(0.03), std::sin(0.03)) };
        auto const after = draw(before, Part::Outline, way.points(lobed_crown(5).outline[0]));
        EXPECT_EQ(outlined(after), std::vector { name }) << size;
    }
    auto const with_branch
        = draw(before, Part::Branch, { { 0, -10 }, { -25, 5 }, { -45, 10 }, { -60, 12 } });
    EXPECT_EQ(outlined(with_branch), std::vector { name });
    auto form = drawing(before).form;
    form.patterns[0] = Pattern::Spiral;
    form.levels = 1;
    auto const formed = scene::apply_edit(before, FormTree { before.state.active, form }).value();
    EXPECT_EQ(outlined(formed), std::vector { name });
}

// If a new crown lacks the lobe, the outline must wait. A crown with the lobe must restore it to
// its branch.
TEST_F(OwnOutlineEdits, WaitForTheirBranch)
{
    auto const before = draw(lobed_tree(), Part::OwnOutline, right_lobe());
    auto const narrow = draw(before, Part::Outline, ellipse(16, 60).outline[0]);
    EXPECT_EQ(drawing(narrow).own_outlines.size(), 1U);
    EXPECT_TRUE(outlined(narrow).empty());
    auto const again = draw(narrow, Part::Outline, lobed_crown(5).outline[0]);
    EXPECT_EQ(outlined(again).size(), 1U);
    auto const bare
        = scene::apply_edit(before, EraseTreePart { before.state.active, Part::Outline }).value();
    EXPECT_EQ(outlined(draw(bare, Part::Outline, lobed_crown(5).outline[0])).size(), 1U);
}

// Strokes on other branches must keep their branches.
TEST_F(OwnOutlineEdits, LeaveTheNamesOfOtherBranches)
{
    auto const before = lobed_tree();
    auto const had = skeleton_of(drawing(before)).value();
    auto const after = draw(before, Part::OwnOutline, right_lobe());
    auto const has = skeleton_of(drawing(after)).value();
    ASSERT_EQ(had.systems[0].branches.size(), has.systems[0].branches.size());
    for (std::size_t i = 0; i < had.systems[0].branches.size(); ++i) {
        EXPECT_EQ(name_of(had.systems[0].branches[i]), name_of(has.systems[0].branches[i]));
        auto const& model = had.systems[0].branches[i].model;
        if (has.systems[0].branches[model.value_or(i)].is_outlined())
            continue;
        auto const below_had = had.system_of[0][i];
        auto const below_has = has.system_of[0][i];
        ASSERT_EQ(below_had == kNoSystem, below_has == kNoSystem);
        if (below_had == kNoSystem)
            continue;
        auto const& one = had.systems[below_had].branches;
        auto const& other = has.systems[below_has].branches;
        ASSERT_EQ(one.size(), other.size());
        for (std::size_t k = 0; k < one.size(); ++k)
            EXPECT_EQ(name_of(one[k]), name_of(other[k]));
    }
}

TEST_F(OwnOutlineEdits, AreRefusedWhereNoBranchIs)
{
    auto const scene = lobed_tree();
    auto const refusal = [](scene::Scene const& before, std::vector<Vec2> const& points,
                            scene::ItemId plant) {
        auto const after = scene::apply_edit(
            before,
            DrawTree { .part = Part::OwnOutline, .stroke = stroke_of(points), .plant = plant });
        return after ? std::string() : after.error().message;
    };
    EXPECT_NE(refusal(scene, lobed_crown(5).outline[0], scene.state.active).find("around none"),
              std::string::npos);
    EXPECT_NE(refusal({}, right_lobe(), 0).find("no tree"), std::string::npos);
    auto const stem = draw({}, Part::Trunk, lobed_crown(5).trunk);
    EXPECT_FALSE(refusal(stem, right_lobe(), stem.state.active).empty());
}

} // namespace
} // namespace tractus::silhouette
