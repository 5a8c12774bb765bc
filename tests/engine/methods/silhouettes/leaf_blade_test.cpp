#include "engine/methods/silhouettes/leaf_blade.h"

#include "engine/methods/silhouettes/chosen_style.h"
#include "engine/methods/silhouettes/own_outline.h"
#include "engine/methods/silhouettes/sibling_style.h"
#include "engine/scene/foliated_plant.h"
#include "tests/engine/methods/silhouettes/refined.h"

#include <memory>
#include <set>

namespace tractus::silhouette {
namespace {

using Part = DrawTree::Part;

// Returns the outline of a leaf around the end of the branch in the right lobe of the oak. The
// outline is longer than wide and has a point.
std::vector<Vec2> leaf_outline()
{
    std::vector<Vec2> outline;
    for (int i = 0; i < 80; ++i) {
        double const angle = i * kPi / 40;
        double const wide = 22 * std::sin(angle) * (1 - 0.35 * std::cos(angle));
        outline.emplace_back(58 + 31 * std::cos(angle), -23 + wide);
    }
    return outline;
}

Drawing crown_with_leaf(StyleScope style_to)
{
    auto drawing = lobed_crown(5);
    auto const added
        = add_own_outline(drawing, leaf_outline(), {}, style_to, Search::AnyLevel, true);
    EXPECT_TRUE(added) << added.error().message;
    return drawing;
}

Tree tree_of(Drawing const& drawing)
{
    auto const skeleton = skeleton_of_lines(drawing);
    auto tree = make_tree(skeleton, tree_options({}, 1000 * drawn_height(skeleton)));
    check_plant(tree.plant);
    return tree;
}

// Returns the organs of a plant that are drawn leaves.
std::vector<Organ> leaves_of(Plant const& plant)
{
    std::vector<Organ> leaves;
    for (auto const& organ : plant.organs)
        if (plant.organ_shapes[organ.shape].cut)
            leaves.push_back(organ);
    return leaves;
}

// Returns the corners of a leaf in the plant's frame.
std::vector<Vec3> corners_of(Plant const& plant, Organ const& organ)
{
    std::vector<Vec3> corners;
    for (auto const& corner : plant.organ_shapes[organ.shape].cut->corners)
        corners.push_back(
            organ.position_mm
            + organ.orientation
                * Vec3(organ.scale.x() * corner.x(), organ.scale.y() * corner.y(), 0));
    return corners;
}

// The tree must consist only of one leaf on a petiole, which has the position and size of the drawn
// outline.
TEST(LeafBlade, OfACrownIsTheWholeTree)
{
    auto drawing = ellipse(30, 50);
    drawing.is_leaf = true;
    auto const skeleton = skeleton_of_lines(drawing);
    ASSERT_EQ(skeleton.systems.size(), 1u);
    EXPECT_TRUE(skeleton.systems[0].branches.empty());
    auto const tree = tree_of(drawing);
    EXPECT_EQ(tree.plant.axes.size(), 1u);
    EXPECT_EQ(tree.plant.organs.size(), 1u);
    EXPECT_EQ(tree.leaves, 1u);
    EXPECT_EQ(tree.sprays, 0u);
    // The leaf is drawn 100 mm high, on a stem that begins 10 mm below it. One millimetre of the
    // drawing becomes one metre.
    Vec2 const foot = drawing.trunk.front();
    for (auto const& corner : corners_of(tree.plant, tree.plant.organs[0])) {
        EXPECT_NEAR(corner.y(), 0, 1e-3);
        Vec2 const drawn = foot + Vec2(corner.x(), corner.z()) / 1000;
        EXPECT_NEAR(std::hypot(drawn.x() / 30, drawn.y() / 50), 1, 0.01);
    }
    double area = 0;
    auto const& cut = *tree.plant.organ_shapes[tree.plant.organs[0].shape].cut;
    for (auto const& [a, b, c] : cut.triangles) {
        double const twice
            = cross(cut.corners[b] - cut.corners[a], cut.corners[c] - cut.corners[a]);
        EXPECT_GE(twice, 0) << "the upper side";
        area += twice / 2;
    }
    double const size = static_cast<double>(tree.plant.organs[0].scale.x()) / 1000;
    EXPECT_NEAR(area * size * size, kPi * 30 * 50, 0.01 * kPi * 30 * 50);
}

TEST(LeafBlade, OfABranchEndsTheRecursionThere)
{
    auto const plain = tree_of(lobed_crown(5));
    EXPECT_TRUE(leaves_of(plain.plant).empty());
    auto const drawing = crown_with_leaf(StyleScope::None);
    auto const skeleton = skeleton_of_lines(drawing);
    auto const at = skeleton.at(drawing.own_outlines[0].branch).value();
    EXPECT_EQ(skeleton.system_of[at.system][at.branch], kNoSystem);
    ASSERT_TRUE(skeleton.systems[0].branches[at.branch].leaf);
    auto const tree = tree_of(drawing);
    auto const leaves = leaves_of(tree.plant);
    ASSERT_GE(leaves.size(), 1u);
    EXPECT_LT(leaves.size(), tree.plant.axes.size() / 10);
    // One of the leaves must be where its outline was drawn, except that its branch is rotated
    // about the trunk.
    double nearest = 1e9;
    for (auto const& leaf : leaves) {
        double farthest = 0;
        for (auto const& corner : corners_of(tree.plant, leaf)) {
            Vec2 const at_mm(std::hypot(corner.x(), corner.y()) / 1000,
                             corner.z() / 1000 + drawing.trunk[0].y());
            farthest = std::max(farthest, distance_to_outline(leaf_outline(), at_mm));
        }
        nearest = std::min(nearest, farthest);
    }
    EXPECT_LT(nearest, 2.5) << "millimetres of the drawing";
}

// All branches without a drawing of their own must end in copies of the drawn leaf, without twigs.
TEST(LeafBlade, GoesToSiblings)
{
    auto const drawing = crown_with_leaf(StyleScope::Siblings);
    auto const skeleton = skeleton_of_lines(drawing);
    ASSERT_EQ(skeleton.systems.size(), 1u);
    auto const& branches = skeleton.systems[0].branches;
    auto const& source = branches[skeleton.at(drawing.own_outlines[0].branch)->branch];
    auto const length_of_leaf
        = [](Branch const& branch) { return (branch.leaf->tip - branch.leaf->base).norm(); };
    auto const chord = [](Branch const& branch) {
        return (branch.path.curve.end - branch.path.curve.base).norm();
    };
    std::size_t outside = 0;
    std::size_t corners = 0;
    for (auto const& branch : branches) {
        ASSERT_TRUE(branch.leaf) << name_of(branch);
        double const usual = std::min(1.0, chord(branch) / chord(source)) * length_of_leaf(source);
        EXPECT_LE(length_of_leaf(branch), usual * (1 + 1e-9));
        EXPECT_GE(length_of_leaf(branch), 0.32 * usual);
        outside += static_cast<std::size_t>(
            std::count_if(branch.crown.begin(), branch.crown.end(), [&](Vec2 const& point) {
                return !is_inside(skeleton.systems[0].outline, point);
            }));
        corners += branch.crown.size();
    }
    EXPECT_LE(10 * outside, corners);
    auto const tree = tree_of(drawing);
    EXPECT_EQ(tree.sprays, 0u);
    EXPECT_EQ(leaves_of(tree.plant).size(), tree.plant.axes.size() - 1);
    EXPECT_EQ(tree.leaves, tree.plant.axes.size() - 1);
    std::set<OrganShapeId> shapes;
    for (auto const& leaf : leaves_of(tree.plant))
        shapes.insert(leaf.shape);
    EXPECT_EQ(shapes.size(), 1u) << "one organ, many times";
}

// A leaf is drawn on a branch of a limb. The limb's other branches must then become leaves. Limbs
// that follow the limb's style must also have leaves.
TEST(LeafBlade, GoesDownWithAStyle)
{
    auto drawing = lobed_crown(5);
    ASSERT_TRUE(add_own_outline(drawing, limb(), {}, StyleScope::Siblings));
    auto const skeleton = skeleton_of_lines(drawing);
    auto const limb_at = skeleton.at(drawing.own_outlines[0].branch).value();
    auto const& system = skeleton.systems[skeleton.system_of[0][limb_at.branch]];
    auto const child = std::find_if(system.branches.begin(), system.branches.end(),
                                    [](auto& one) { return one.origin == Branch::Origin::Bump; });
    ASSERT_NE(child, system.branches.end());
    auto const added
        = add_own_outline(drawing, child->crown, {}, StyleScope::Siblings, Search::AnyLevel, true);
    ASSERT_TRUE(added) << added.error().message;
    auto const with = skeleton_of_lines(drawing);
    std::size_t bearing = 0;
    for (std::size_t s = 1; s < with.systems.size(); ++s) {
        EXPECT_TRUE(has_only_leaves(with.systems[s])) << with.parents[s];
        ++bearing;
    }
    EXPECT_GE(bearing, 5u);
    auto const tree = tree_of(drawing);
    EXPECT_GT(leaves_of(tree.plant).size(), 50u);
    // Only branches whose crowns are too small for a style have twigs.
    std::set<SegmentId> bearing_twigs;
    for (auto const& organ : tree.plant.organs)
        if (!tree.plant.organ_shapes[organ.shape].cut)
            bearing_twigs.insert(axis_of(tree.plant, organ.segment));
    EXPECT_LE(bearing_twigs.size(), 1u);
}

TEST(LeafBlade, IsAStyleThatIsCarried)
{
    auto drawing = crown_with_leaf(StyleScope::None);
    auto const skeleton = skeleton_of_lines(drawing);
    auto const source = drawing.own_outlines[0].branch;
    std::string target;
    for (auto const& branch : skeleton.systems[0].branches)
        if (branch.origin == Branch::Origin::Bump && name_of(branch) != source)
            target = name_of(branch);
    ASSERT_TRUE(choose_styles(drawing.styles, { { target, source } }, skeleton));
    auto const carried = skeleton_of_lines(drawing);
    auto const& branch = carried.systems[0].branches[carried.at(target)->branch];
    EXPECT_TRUE(branch.leaf);
    EXPECT_EQ(branch.style_from, source);
    auto const refused = choose_styles(drawing.styles, { { source, target } }, skeleton);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("is a leaf as it was drawn"), std::string::npos);
}

// The leaves of a species must replace the drawn leaf, and have its length.
TEST(LeafBlade, WearsGrownLeaves)
{
    auto const plant = tree_of(crown_with_leaf(StyleScope::Siblings)).plant;
    auto const grown = std::make_shared<CutLeaf const>(
        CutLeaf { .corners = { { -0.3, 0 }, { 0.3, 0 }, { 0, 1 } }, .triangles = { { 0, 1, 2 } } });
    auto const worn = scene::foliated(plant, { .leaves = { grown } });
    for (std::size_t i = 0; i < plant.organs.size(); ++i) {
        auto const& shape = worn.organ_shapes[worn.organs[i].shape];
        ASSERT_TRUE(shape.cut);
        EXPECT_EQ(shape.cut, grown);
        EXPECT_NEAR(shape.length_mm, 1, 1e-6) << "times the organ's scale";
        EXPECT_EQ(worn.organs[i].scale, plant.organs[i].scale);
    }
}

class LeafEdits : public ::testing::Test {
protected:
    static scene::Scene declare(scene::Scene const& before, scene::ItemId outline, bool is_leaf)
    {
        auto const after
            = scene::apply_edit(before, DeclareLeaf { before.state.active, outline, is_leaf });
        EXPECT_TRUE(after) << after.error().message;
        return after.value_or(scene::Scene {});
    }
    static OutlinedTree const& drawing(scene::Scene const& scene)
    {
        return *outlined_tree(*scene.drawn);
    }
};

TEST_F(LeafEdits, DeclareAnOutlineALeafAndTakeItBack)
{
    auto const outlined = draw_on(lobed_tree(),
                                  { .part = Part::OwnOutline,
                                    .stroke = stroke_of(limb()),
                                    .style_to = StyleScope::Siblings });
    auto const id = drawing(outlined).own_outlines[0].id;
    auto const leafy = declare(outlined, id, true);
    EXPECT_EQ(leaves_of(*leafy.base).size(), leafy.base->axes.size() - 1);
    auto const again = declare(leafy, id, false);
    EXPECT_EQ(again.base->node_position_mm, outlined.base->node_position_mm);
    auto const whole = declare(outlined, 0, true);
    EXPECT_EQ(whole.base->organs.size(), 1u);
    EXPECT_EQ(count_without_effect(drawing(whole)).value(), 1u) << "the limb's outline";
    EXPECT_EQ(declare(whole, 0, false).base->node_position_mm, outlined.base->node_position_mm);
    auto const none = scene::apply_edit(outlined, DeclareLeaf { outlined.state.active, 77, true });
    ASSERT_FALSE(none);
    EXPECT_NE(none.error().message.find("no such outline"), std::string::npos);
}

// An outline that is a leaf must stay one if the outline or the crown is redrawn.
TEST_F(LeafEdits, OutlastLinesThatAreDrawnAnew)
{
    auto const leaf = draw_on(
        lobed_tree(),
        { .part = Part::OwnOutline, .stroke = stroke_of(leaf_outline()), .is_leaf = true });
    auto const path = drawing(leaf).own_outlines[0].branch;
    Similarity const way { .from = { 58, -23 }, .to = { 58, -23 }, .turn = { 1.05, 0.02 } };
    auto const larger = draw_on(
        leaf, { .part = Part::OwnOutline, .stroke = stroke_of(way.points(leaf_outline())) });
    ASSERT_EQ(drawing(larger).own_outlines.size(), 1u);
    EXPECT_TRUE(drawing(larger).own_outlines[0].is_leaf);
    Similarity const crown { .turn = 1.02 * Vec2(std::cos(0.02), std::sin(0.02)) };
    auto const redrawn = draw_on(
        larger,
        { .part = Part::Outline, .stroke = stroke_of(crown.points(lobed_crown(5).outline[0])) });
    EXPECT_EQ(drawing(redrawn).own_outlines[0].branch, path);
    EXPECT_GE(leaves_of(*redrawn.base).size(), 1u);
    EXPECT_EQ(count_without_effect(drawing(redrawn)).value(), 0u);
}

// Branches that were drawn on a branch must wait while that branch is a leaf.
TEST_F(LeafEdits, LetBranchesOnThemWait)
{
    auto const outlined
        = draw_on(lobed_tree(), { .part = Part::OwnOutline, .stroke = stroke_of(limb()) });
    auto const path = drawing(outlined).own_outlines[0].branch;
    auto const skeleton = skeleton_of(drawing(outlined)).value();
    Vec2 const from = skeleton.systems[0].branches[skeleton.at(path)->branch].path.curve.at(0.6);
    auto const borne
        = draw_on(outlined,
                  { .part = Part::OwnBranch,
                    .stroke = stroke_of({ from, from + Vec2(1, 4), from + Vec2(3, 9) }) });
    ASSERT_EQ(drawing(borne).own_branches[0].branch, path);
    auto const leaf = declare(borne, drawing(borne).own_outlines[0].id, true);
    EXPECT_EQ(count_without_effect(drawing(leaf)).value(), 1u);
    auto const again = declare(leaf, drawing(borne).own_outlines[0].id, false);
    EXPECT_EQ(again.base->node_position_mm, borne.base->node_position_mm);
}

} // namespace
} // namespace tractus::silhouette
