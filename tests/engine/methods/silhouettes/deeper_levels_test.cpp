#include "engine/methods/silhouettes/chosen_style.h"
#include "engine/methods/silhouettes/own_branch.h"
#include "engine/methods/silhouettes/own_outline.h"
#include "engine/methods/silhouettes/tree.h"
#include "engine/methods/silhouettes/tree_edits.h"
#include "engine/scene/scene.h"
#include "tests/engine/methods/silhouettes/refined.h"

#include <algorithm>

namespace tractus::silhouette {
namespace {

// Returns the line of a twig that begins on the outer half of a branch, on its left side.
std::vector<Vec2> twig_on(Branch const& branch)
{
    auto const line = resampled_line(branch.line(17), 21);
    Vec2 const way = 0.3 * branch.path.length * direction_of(line[14] - line[12]);
    return { line[12], line[12] + 0.5 * turned(way, 0.6), line[12] + turned(way, 0.9) };
}

// Adds `levels` twigs, each on the previous one. The first is on the trunk's branch `from`. Returns
// the path of the last twig.
std::string draw_down(Drawing& drawing, std::string const& from, int levels,
                      StyleScope style_to = StyleScope::None)
{
    auto path = from;
    for (int level = 0; level < levels; ++level) {
        auto const skeleton = skeleton_of_lines(drawing);
        auto const at = skeleton.at(path).value();
        auto const twig = twig_on(skeleton.systems[at.system].branches[at.branch]);
        auto const added = add_own_branch(drawing, twig, style_to, {}, Search::AnyLevel);
        EXPECT_TRUE(added) << path << ": " << added.error().message;
        EXPECT_EQ(drawing.own_branches.back().branch, path);
        auto const after = skeleton_of_lines(drawing);
        auto const parent = after.at(path).value();
        auto const below = after.system_of[parent.system][parent.branch];
        EXPECT_NE(below, kNoSystem);
        for (auto const& branch : after.systems[below].branches)
            if (branch.is_stroke() && branch.stroke == twig)
                path += "/" + name_of(branch);
    }
    return path;
}

std::string first_bump(Skeleton const& skeleton)
{
    for (auto const& branch : skeleton.systems[0].branches)
        if (branch.origin == Branch::Origin::Bump)
            return name_of(branch);
    return {};
}

TEST(DeeperLevels, BranchesAreDrawnOnBranchesToAnyLevel)
{
    auto drawing = lobed_crown(5);
    auto const path = draw_down(drawing, first_bump(skeleton_of_lines(drawing)), 5);
    EXPECT_EQ(std::count(path.begin(), path.end(), '/'), 5);
    for (int const levels : { 1, 2, 3 }) {
        auto const skeleton = skeleton_of_lines(drawing, { .levels = levels });
        for (auto const& own : drawing.own_branches) {
            auto const at = skeleton.at(own.branch);
            ASSERT_TRUE(at) << own.branch;
            auto const& parent = skeleton.systems[at->system].branches[at->branch];
            ASSERT_EQ(parent.own_branches.size(), 1u) << own.branch;
            EXPECT_EQ(parent.own_branches[0], own.line);
            auto const& below = skeleton.systems[skeleton.system_of[at->system][at->branch]];
            EXPECT_TRUE(std::any_of(below.branches.begin(), below.branches.end(),
                                    [&](Branch const& branch) {
                                        return branch.is_stroke() && branch.stroke == own.line;
                                    }))
                << "exactly as it was drawn";
        }
        auto const tree = make_tree(skeleton);
        check_plant(tree.plant);
        EXPECT_NE(std::find(tree.axis_names.begin(), tree.axis_names.end(), path),
                  tree.axis_names.end());
    }
}

// In space, twigs must stay in the plane of the drawing and end where their strokes end.
TEST(DeeperLevels, StrokesEndWhereTheyWereDrawn)
{
    auto drawing = lobed_crown(5);
    auto const path = draw_down(drawing, first_bump(skeleton_of_lines(drawing)), 3);
    auto const skeleton = skeleton_of_lines(drawing);
    double const height = drawn_height(skeleton);
    auto const tree = make_tree(skeleton, { .height_mm = height });
    Vec2 const foot = skeleton.systems[0].trunk.front();
    std::size_t found = 0;
    for (std::size_t a = 0; a < tree.axis_names.size(); ++a) {
        if (tree.axis_names[a] != path)
            continue;
        ++found;
        auto const& axis = tree.plant.axes[a];
        auto const& end = tree.plant.node_position_mm[axis.first_node + axis.segment_count];
        Vec2 const drawn = drawing.own_branches.back().line.back() - foot;
        EXPECT_NEAR(end.x(), drawn.x(), 0.02 * height);
        EXPECT_NEAR(end.z(), drawn.y(), 0.02 * height);
        EXPECT_NEAR(end.y(), 0, 0.02 * height);
    }
    EXPECT_EQ(found, 1u);
}

// The outline is drawn around a branch that ends in a lobe of another branch's own outline.
TEST(DeeperLevels, OutlinesAreDrawnAroundBranchesOfBranches)
{
    auto drawing = lobed_crown(7);
    ASSERT_TRUE(add_own_outline(drawing, limb()));
    auto const on_trunk = drawing.own_outlines[0].branch;
    auto const skeleton = skeleton_of_lines(drawing);
    auto const at = skeleton.at(on_trunk).value();
    auto const& system = skeleton.systems[skeleton.system_of[at.system][at.branch]];
    std::size_t taken = 0;
    for (auto const& branch : system.branches) {
        if (branch.origin != Branch::Origin::Bump)
            continue;
        auto deeper = drawing;
        std::vector<Vec2> around; // Crown of the branch, with lobes.
        auto const middle = box_of(branch.crown).middle();
        for (std::size_t i = 0; i < branch.crown.size(); ++i) {
            double const turn
                = 2 * kPi * static_cast<double>(i) / static_cast<double>(branch.crown.size());
            around.push_back(middle
                             + (1.1 + 0.1 * std::sin(5 * turn)) * (branch.crown[i] - middle));
        }
        ASSERT_TRUE(add_own_outline(deeper, around, {}, StyleScope::None, Search::AnyLevel));
        EXPECT_EQ(deeper.own_outlines.back().branch, on_trunk + "/" + name_of(branch));
        auto const after = skeleton_of_lines(deeper);
        auto const child = after.at(deeper.own_outlines.back().branch).value();
        EXPECT_TRUE(after.systems[child.system].branches[child.branch].is_outlined());
        EXPECT_GE(after.branches_on(child), 3u);
        check_plant(make_tree(after).plant);
        ++taken;
        // In old logs, outlines could only belong to the trunk's branches.
        auto old = drawing;
        auto const on_trunk_alone = add_own_outline(old, around);
        EXPECT_TRUE(!on_trunk_alone
                    || old.own_outlines.back().branch.find('/') == std::string::npos);
    }
    EXPECT_GE(taken, 4u);
}

TEST(DeeperLevels, AStyleGoesToSiblingsThere)
{
    auto drawing = lobed_crown(7);
    ASSERT_TRUE(add_own_outline(drawing, limb()));
    auto const on_trunk = drawing.own_outlines[0].branch;
    auto const plain = skeleton_of_lines(drawing);
    auto const at = plain.at(on_trunk).value();
    auto const& children = plain.systems[plain.system_of[at.system][at.branch]].branches;
    auto const longest
        = std::max_element(children.begin(), children.end(), [](auto const& a, auto const& b) {
              return a.path.length < b.path.length;
          });
    ASSERT_TRUE(
        add_own_branch(drawing, twig_on(*longest), StyleScope::Siblings, {}, Search::AnyLevel));
    ASSERT_EQ(drawing.own_branches[0].branch, on_trunk + "/" + name_of(*longest));
    auto const styled = skeleton_of_lines(drawing);
    auto const below = styled.system_of[at.system][at.branch];
    for (std::size_t b = 0; b < styled.systems[below].branches.size(); ++b) {
        auto const child = styled.system_of[below][b];
        ASSERT_NE(child, kNoSystem);
        EXPECT_TRUE(styled.systems[child].is_in_siblings_style);
    }
    EXPECT_EQ(styled.system_of[0].size(), plain.system_of[0].size());
    EXPECT_GT(styled.systems.size(), plain.systems.size());
    check_plant(make_tree(styled).plant);
}

// Branches of a branch that follows the example must follow it, too.
TEST(DeeperLevels, AStyleGoesDown)
{
    auto drawing = lobed_crown(7);
    ASSERT_TRUE(add_own_outline(drawing, limb()));
    SkeletonOptions const options { .levels = 3 };
    auto const following = [&](StyleScope style_to) {
        drawing.own_outlines[0].style_to = style_to;
        auto const skeleton = skeleton_of_lines(drawing, options);
        std::size_t follow = 0;
        for (auto const second : skeleton.system_of[0])
            for (std::size_t b = 0; second != kNoSystem && b < skeleton.system_of[second].size();
                 ++b)
                if (auto const third = skeleton.system_of[second][b]; third != kNoSystem)
                    follow += skeleton.systems[third].is_in_siblings_style;
        return follow;
    };
    EXPECT_EQ(following(StyleScope::Siblings), 0u);
    EXPECT_GE(following(StyleScope::Deeper), 50u);
    drawing.own_outlines[0].style_to = StyleScope::Deeper;
    auto const skeleton = skeleton_of_lines(drawing, options);
    auto const source = skeleton.at(drawing.own_outlines[0].branch).value();
    auto const own = seen_on(skeleton.systems[skeleton.system_of[source.system][source.branch]]);
    // On the third level, the position of the first branches, as a share of their parents' lengths,
    // must be the same as for the source.
    double first = 0;
    double angle_deg = 0;
    double count = 0;
    for (auto const second : skeleton.system_of[0])
        for (std::size_t b = 0; second != kNoSystem && b < skeleton.system_of[second].size(); ++b) {
            auto const third = skeleton.system_of[second][b];
            if (third == kNoSystem || skeleton.systems[second].branches[b].model)
                continue;
            auto const has = seen_on(skeleton.systems[third]);
            first += has.places.front() / has.length;
            angle_deg += has.angle_deg;
            count += 1;
        }
    EXPECT_NEAR(first / count, own.places.front() / own.length, 0.03);
    EXPECT_NEAR(angle_deg / count, own.angle_deg, 0.15 * own.angle_deg);
    check_plant(make_tree(skeleton).plant);
}

TEST(DeeperLevels, AStyleIsCarriedAmongThem)
{
    auto drawing = lobed_crown(7);
    ASSERT_TRUE(add_own_outline(drawing, limb()));
    auto const skeleton = skeleton_of_lines(drawing);
    auto const at = skeleton.at(drawing.own_outlines[0].branch).value();
    auto const below = skeleton.system_of[at.system][at.branch];
    auto const& children = skeleton.systems[below].branches;
    auto const name = [&](std::size_t b) { return skeleton.path_of({ below, b }); };
    ASSERT_GE(children.size(), 4u);
    auto const twig = twig_on(children[0]);
    ASSERT_TRUE(add_own_branch(drawing, twig, StyleScope::None, {}, Search::AnyLevel));
    ASSERT_EQ(drawing.own_branches[0].branch, name(0));
    auto const source = skeleton_of_lines(drawing);
    auto const carried
        = copied_by(source, std::vector { twig[0], children[1].path.curve.at(0.9) }).value();
    EXPECT_EQ(carried.at(name(1)), name(0));
    for (auto const& [target, from] : carried)
        EXPECT_EQ(parent_in(target), drawing.own_outlines[0].branch) << "of this level alone";
    ASSERT_TRUE(choose_styles(drawing.styles, carried, source));
    auto const styled = skeleton_of_lines(drawing);
    auto const target = styled.at(name(1)).value();
    EXPECT_EQ(styled.systems[target.system].branches[target.branch].style_from, name(0));
    EXPECT_GE(styled.branches_on(target), 1u);
    ChosenStyles styles;
    EXPECT_FALSE(choose_styles(styles, { { first_bump(source), name(0) } }, source))
        << "from a deeper level";
}

class DeeperEdits : public ::testing::Test {
protected:
    using Part = DrawTree::Part;

    static scene::Scene draw(scene::Scene const& before, Part part, std::vector<Vec2> const& points)
    {
        return draw_on(before,
                       { .part = part, .stroke = stroke_of(points), .search = Search::AnyLevel });
    }

    static OutlinedTree const& tree(scene::Scene const& scene)
    {
        return *outlined_tree(*scene.drawn);
    }

    // Returns a scene with an outlined limb, a twig on a branch of the limb, and a twig on that
    // twig.
    static scene::Scene three_levels()
    {
        auto const lines = lobed_crown(7);
        auto scene = draw(draw(draw({}, Part::Trunk, lines.trunk), Part::Outline, lines.outline[0]),
                          Part::OwnOutline, limb());
        auto const skeleton = skeleton_of(tree(scene)).value();
        auto const at = skeleton.at(tree(scene).own_outlines[0].branch).value();
        auto const& child = skeleton.systems[skeleton.system_of[at.system][at.branch]].branches[0];
        auto const twig = twig_on(child);
        scene = draw(scene, Part::OwnBranch, twig);
        Vec2 const from = twig[1];
        Vec2 const way = 0.5 * (twig[2] - twig[1]);
        return draw(scene, Part::OwnBranch, { from, from + turned(way, -0.9) });
    }
};

TEST_F(DeeperEdits, StayWithTheirParents)
{
    auto const lines = lobed_crown(7);
    auto const before = three_levels();
    ASSERT_EQ(tree(before).own_branches.size(), 2u);
    EXPECT_TRUE(
        tree(before).own_branches[1].branch.starts_with(tree(before).own_branches[0].branch + "/"));
    EXPECT_EQ(count_without_effect(tree(before)).value(), 0u);
    for (double const size : { 0.98, 1.02 }) {
        Similarity const way { .turn = Vec2(size, 0.005) };
        auto const after = draw(before, Part::Outline, way.points(lines.outline[0]));
        EXPECT_EQ(count_without_effect(tree(after)).value(), 0u);
        for (std::size_t i = 0; i < 2; ++i)
            EXPECT_EQ(tree(after).own_branches[i].branch, tree(before).own_branches[i].branch);
        EXPECT_EQ(draw(after, Part::Outline, lines.outline[0]).base->node_position_mm,
                  before.base->node_position_mm)
            << "and back";
    }
    auto form = tree(before).form;
    form.levels = 1;
    auto const flat = scene::apply_edit(before, FormTree { before.state.active, form }).value();
    EXPECT_EQ(count_without_effect(tree(flat)).value(), 0u);
    form.levels = 2;
    EXPECT_EQ(scene::apply_edit(flat, FormTree { flat.state.active, form })->base->node_position_mm,
              before.base->node_position_mm);
}

// If a new crown lacks the limb, the twigs must wait. If the first twig is erased, the second must
// wait. A crown with the limb must restore both twigs.
TEST_F(DeeperEdits, WaitForTheirParents)
{
    auto const lines = lobed_crown(7);
    auto const before = three_levels();
    auto const narrow = draw(before, Part::Outline, ellipse(16, 60).outline[0]);
    EXPECT_EQ(count_without_effect(tree(narrow)).value(), 3u);
    auto const again = draw(narrow, Part::Outline, lines.outline[0]);
    EXPECT_EQ(count_without_effect(tree(again)).value(), 0u);
    auto const erased = scene::apply_edit(before,
                                          EraseTreePart { before.state.active, Part::OwnBranch,
                                                          tree(before).own_branches[0].id })
                            .value();
    EXPECT_EQ(tree(erased).own_branches.size(), 1u);
    EXPECT_EQ(count_without_effect(tree(erased)).value(), 1u);
    auto const without
        = scene::apply_edit(before, EraseTreePart { before.state.active, Part::Outline }).value();
    auto const crown = draw(without, Part::Outline, lines.outline[0]);
    EXPECT_EQ(count_without_effect(tree(crown)).value(), 0u);
    EXPECT_EQ(crown.base->node_position_mm, before.base->node_position_mm);
}

} // namespace
} // namespace tractus::silhouette
