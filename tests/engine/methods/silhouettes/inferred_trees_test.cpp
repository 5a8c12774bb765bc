#include "engine/methods/silhouettes/inferred_trees.h"
#include "tests/engine/methods/silhouettes/outlines.h"
#include "tests/engine/methods/silhouettes/refined.h"

#include <cmath>
#include <memory>

namespace tractus::silhouette {
namespace {

using Part = DrawTree::Part;

OutlinedTree const& drawing(scene::Scene const& scene)
{
    return *outlined_tree(*scene.drawn);
}

void expect_same(BranchingSystem const& one, BranchingSystem const& other)
{
    ASSERT_EQ(one.branches.size(), other.branches.size());
    EXPECT_EQ(one.outline, other.outline);
    EXPECT_EQ(one.trunk, other.trunk);
    for (std::size_t i = 0; i < one.branches.size(); ++i) {
        EXPECT_EQ(name_of(one.branches[i]), name_of(other.branches[i]));
        EXPECT_EQ(one.branches[i].crown, other.branches[i].crown);
        EXPECT_EQ(one.branches[i].model, other.branches[i].model);
        EXPECT_EQ(one.branches[i].leaf.has_value(), other.branches[i].leaf.has_value());
        EXPECT_EQ(one.branches[i].path.curve.points(5), other.branches[i].path.curve.points(5));
    }
}

// Expects the stored inference of a tree to be equal, to the last bit, to a new inference from its
// lines and names.
void expect_known(scene::Scene const& scene)
{
    auto const& tree = drawing(scene);
    ASSERT_TRUE(tree.inferred);
    auto const known = tree.inferred->find(tree);
    ASSERT_TRUE(known);
    auto const anew = infer_drawing(drawing_of(tree).value(), options_of(tree)).value();
    ASSERT_EQ(known->skeleton.systems.size(), anew.skeleton.systems.size());
    EXPECT_EQ(known->skeleton.system_of, anew.skeleton.system_of);
    EXPECT_EQ(known->skeleton.parents, anew.skeleton.parents);
    EXPECT_EQ(known->as_inferred.size(), anew.as_inferred.size());
    for (std::size_t i = 0; i < anew.skeleton.systems.size(); ++i) {
        expect_same(known->skeleton.systems[i], anew.skeleton.systems[i]);
        expect_same(known->bare(i), anew.bare(i));
    }
}

// Redraws the crown, slightly rotated and scaled.
scene::Scene crown_again(scene::Scene const& before, double size, double turn)
{
    Similarity const way { .turn = size * Vec2(std::cos(turn), std::sin(turn)) };
    return draw_on(
        before,
        { .part = Part::Outline, .stroke = stroke_of(way.points(lobed_crown(5).outline[0])) });
}

TEST(InferredTrees, KnowATreeWhoseLinesAreDrawnAnew)
{
    auto scene = lobed_tree();
    expect_known(scene);
    scene = crown_again(scene, 1.02, 0.02);
    EXPECT_FALSE(drawing(scene).names.empty());
    expect_known(scene);
    scene = draw_on(scene,
                    { .part = Part::Branch,
                      .stroke = stroke_of({ { 0, -10 }, { -25, 5 }, { -45, 10 }, { -60, 12 } }) });
    expect_known(scene);
}

TEST(InferredTrees, KnowATreeWithLinesOnItsBranches)
{
    for (auto const style : { StyleScope::None, StyleScope::Siblings, StyleScope::Deeper }) {
        auto scene
            = draw_on(lobed_tree(),
                      { .part = Part::OwnOutline, .stroke = stroke_of(limb()), .style_to = style });
        expect_known(scene);
        auto const path = drawing(scene).own_outlines[0].branch;
        scene = crown_again(scene, 1.03, -0.02);
        EXPECT_EQ(drawing(scene).own_outlines[0].branch, path);
        expect_known(scene);
        scene = crown_again(scene, 0.99, 0.03);
        expect_known(scene);
        auto const anew
            = infer_skeleton(drawing_of(drawing(scene)).value(), options_of(drawing(scene)));
        auto const plant = make_tree(
            *anew, tree_options(drawing(scene).form, drawn_height(*anew) / drawing(scene).scale));
        EXPECT_EQ(scene.base->node_position_mm, plant.plant.node_position_mm);
    }
}

// If the redrawn crown moves lines to other branches, the tree must be inferred again.
TEST(InferredTrees, BuildWhatTheLinesSayWhereTheyHaveGoneElsewhere)
{
    auto const outlined
        = draw_on(lobed_tree(), { .part = Part::OwnOutline, .stroke = stroke_of(limb()) });
    auto const path = drawing(outlined).own_outlines[0].branch;
    auto const narrow = draw_on(
        outlined, { .part = Part::Outline, .stroke = stroke_of(ellipse(16, 60).outline[0]) });
    auto const again = crown_again(narrow, 1, 0);
    EXPECT_NE(drawing(again).own_outlines[0].branch, path);
    EXPECT_EQ(count_without_effect(drawing(again)).value(), 0u);
    expect_known(again); // The stored inference must not have changed since the tree was built.
}

TEST(InferredTrees, AreThoseOfTheNewestTwoVersions)
{
    auto const first = lobed_tree();
    auto const second = crown_again(first, 1.02, 0);
    auto& inferred = *drawing(second).inferred;
    EXPECT_EQ(&inferred, drawing(first).inferred.get());
    EXPECT_TRUE(inferred.find(drawing(first)));
    EXPECT_TRUE(inferred.find(drawing(second)));
    auto const third = crown_again(second, 0.97, 0);
    EXPECT_TRUE(inferred.find(drawing(third)));
    EXPECT_TRUE(inferred.find(drawing(second)));
    EXPECT_FALSE(inferred.find(drawing(first)));
    auto other = drawing(third);
    other.form.levels = 1;
    EXPECT_FALSE(inferred.find(other));
}

// A crown that is a leaf has no branches, but must keep their names for later.
TEST(InferredTrees, SayNothingOfALeaf)
{
    auto const before = crown_again(lobed_tree(), 1.02, 0);
    auto const leaf
        = scene::apply_edit(before, DeclareLeaf { before.state.active, 0, true }).value();
    EXPECT_FALSE(drawing(leaf).inferred->find(drawing(leaf)));
    EXPECT_EQ(leaf.base->organs.size(), 1u);
    auto const again
        = scene::apply_edit(leaf, DeclareLeaf { before.state.active, 0, false }).value();
    EXPECT_EQ(again.base->node_position_mm, before.base->node_position_mm);
}

// Building other individuals for a collection must not replace the stored inference of the drawn
// plant.
TEST(InferredTrees, AreNotOfAnotherChance)
{
    auto const scene = lobed_tree();
    auto const varied = scene.drawn->source.varied({ .seed = 5, .plant = 3 });
    auto const* const other = varied.get<OutlinedTree>(OutlinedTree::kKind);
    ASSERT_TRUE(other);
    EXPECT_FALSE(other->inferred);
    EXPECT_TRUE(varied.build({}));
}

} // namespace
} // namespace tractus::silhouette
