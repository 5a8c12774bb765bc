#include "engine/methods/silhouettes/chosen_style.h"

#include "engine/methods/silhouettes/own_branch.h"
#include "engine/methods/silhouettes/own_outline.h"
#include "engine/methods/silhouettes/tree.h"
#include "engine/methods/silhouettes/tree_edits.h"
#include "engine/scene/scene.h"
#include "tests/engine/methods/silhouettes/refined.h"

#include <algorithm>
#include <set>

namespace tractus::silhouette {
namespace {

// Returns the drawing of a crown whose right limb has an outline of its own.
Drawing with_limb()
{
    auto drawing = lobed_crown(7);
    auto const added = add_own_outline(drawing, limb());
    EXPECT_TRUE(added) << added.error().message;
    return drawing;
}

BranchingSystem const* system_of(Skeleton const& skeleton, std::string const& path)
{
    auto const at = skeleton.at(path);
    if (!at)
        return nullptr;
    auto const below = skeleton.system_of[at->system][at->branch];
    return below == kNoSystem ? nullptr : &skeleton.systems[below];
}

// Returns the path of the trunk's last branch that fits.
template<typename Fits> std::string find_branch(Skeleton const& skeleton, Fits const& fits)
{
    auto const& branches = skeleton.systems[0].branches;
    auto const found = std::find_if(branches.rbegin(), branches.rend(), [&](Branch const& branch) {
        return branch.origin != Branch::Origin::Apex && fits(branch);
    });
    EXPECT_NE(found, branches.rend());
    return found == branches.rend() ? std::string() : name_of(*found);
}

bool has_copies(Skeleton const& skeleton, Branch const& branch)
{
    auto const& branches = skeleton.systems[0].branches;
    return std::any_of(branches.begin(), branches.end(), [&](Branch const& copy) {
        return copy.model && &branches[*copy.model] == &branch;
    });
}

// Returns the ends of the branches on a branch as points of the drawing's plane. The branches of a
// copy are returned in the positions of the copy.
std::vector<Vec2> ends_on(Skeleton const& skeleton, std::string const& path)
{
    auto const& branch = skeleton.systems[0].branches[skeleton.at(path)->branch];
    std::vector<Vec2> ends;
    if (auto const* const system = system_of(skeleton, path))
        for (auto const& child : system->branches)
            ends.push_back(branch.model ? branch.from_model.point(child.path.curve.end)
                                        : child.path.curve.end);
    return ends;
}

TEST(ChosenStyle, IsTheSourcesOnTheTargetAlone)
{
    auto drawing = with_limb();
    auto const plain = skeleton_of_lines(drawing);
    auto const source = drawing.own_outlines[0].branch;
    // The target is a branch that has copies. The copies must keep their own style.
    auto const target = find_branch(plain, [&](Branch const& branch) {
        return !branch.is_refined() && has_copies(plain, branch);
    });
    drawing.styles[target] = source;
    auto const styled = skeleton_of_lines(drawing);
    for (auto const& branch : plain.systems[0].branches) {
        auto const name = name_of(branch);
        EXPECT_EQ(ends_on(styled, name) == ends_on(plain, name), name != target) << name;
    }
    auto const own = seen_on(*system_of(styled, source));
    auto const has = seen_on(*system_of(styled, target));
    double const spacing
        = (own.places.back() - own.places.front()) / static_cast<double>(own.places.size() - 1);
    double const reach = (own.places.back() - own.places.front()) / own.length * has.length;
    EXPECT_NEAR(static_cast<double>(has.places.size()), std::max(reach / spacing, 1.0) + 1, 0.75);
    EXPECT_NEAR(has.places.front() / has.length, own.places.front() / own.length, 0.03);
    EXPECT_NEAR(has.angle_deg, own.angle_deg, 0.2 * own.angle_deg);
    check_plant(make_tree(styled).plant);
}

// A branch without drawn branches also has a style. A copy can be a source or a target.
TEST(ChosenStyle, GoesFromAndToAnyBranch)
{
    auto drawing = lobed_crown(7);
    auto const plain = skeleton_of_lines(drawing);
    auto const is_copy = [](Branch const& branch) { return branch.model.has_value(); };
    auto const copy = find_branch(plain, is_copy);
    auto const bump = find_branch(
        plain, [](Branch const& branch) { return branch.origin == Branch::Origin::Bump; });
    for (auto const& [target, source] : { std::pair(copy, bump), std::pair(bump, copy) }) {
        drawing.styles = { { target, source } };
        auto const styled = skeleton_of_lines(drawing);
        auto const at = *styled.at(target);
        EXPECT_FALSE(styled.systems[0].branches[at.branch].model);
        EXPECT_EQ(styled.systems[0].branches[at.branch].style_from, source);
        EXPECT_TRUE(system_of(styled, target)->is_in_siblings_style);
        EXPECT_NE(ends_on(styled, target), ends_on(plain, target));
        EXPECT_EQ(ends_on(styled, source), ends_on(plain, source));
        check_plant(make_tree(styled).plant);
    }
}

// All siblings follow one branch. A chosen sibling can nevertheless follow another one.
TEST(ChosenStyle, GoesBeforeThatOfSiblings)
{
    auto drawing = with_limb();
    Similarity const mirror { .turn = Vec2(-1, 0), .mirrors = true };
    std::vector<Vec2> smooth; // An outline without lobes, in which few branches are inferred.
    for (int i = 0; i < 60; ++i)
        smooth.push_back(mirror.point(
            Vec2(52, -18) + 28 * Vec2(std::cos(i * kPi / 30), 0.8 * std::sin(i * kPi / 30))));
    ASSERT_TRUE(add_own_outline(drawing, smooth));
    drawing.own_outlines[0].style_to = StyleScope::Siblings;
    auto const all = skeleton_of_lines(drawing);
    auto const target = find_branch(all, [](Branch const& branch) { return !branch.is_refined(); });
    drawing.styles[target] = drawing.own_outlines[1].branch;
    auto const chosen = skeleton_of_lines(drawing);
    for (auto const& branch : all.systems[0].branches) {
        auto const name = name_of(branch);
        EXPECT_EQ(ends_on(chosen, name) == ends_on(all, name), name != target) << name;
    }
}

// The distances and positions of a style must not depend on other branches: sources keep their own
// branches.
TEST(ChosenStyle, IsThereWhereBranchesBearNoOthers)
{
    auto drawing = with_limb();
    auto const plain = skeleton_of_lines(drawing, { .levels = 1 });
    auto const target
        = find_branch(plain, [](Branch const& branch) { return !branch.is_refined(); });
    drawing.styles[target] = drawing.own_outlines[0].branch;
    auto const styled = skeleton_of_lines(drawing, { .levels = 1 });
    EXPECT_EQ(styled.systems.size(), plain.systems.size() + 1);
    EXPECT_TRUE(system_of(styled, target));
    drawing.styles = { { target, "nothing" }, { "none", target } };
    EXPECT_EQ(skeleton_of_lines(drawing, { .levels = 1 }).systems.size(), plain.systems.size())
        << "they wait";
}

TEST(ChosenStyle, IsCarriedByALine)
{
    auto const drawing = with_limb();
    auto const skeleton = skeleton_of_lines(drawing);
    auto const source = drawing.own_outlines[0].branch;
    auto const& branches = skeleton.systems[0].branches;
    Vec2 const from = branches[skeleton.at(source)->branch].path.curve.at(0.8);
    for (auto const& branch : branches) {
        auto const target = name_of(branch);
        if (branch.origin == Branch::Origin::Apex || target == source)
            continue;
        std::vector const line { from, branch.path.curve.at(0.9) };
        auto const carried = copied_by(skeleton, line).value();
        EXPECT_EQ(carried.at(target), source) << target;
        // The line must cross exactly those branches that are reported.
        for (auto const& other : branches) {
            auto const way = other.path.curve.points(17);
            bool crosses = false;
            for (std::size_t i = 0; i + 1 < way.size(); ++i)
                crosses = crosses || do_cross(line[0], line[1], way[i], way[i + 1]);
            bool const is_other = other.origin != Branch::Origin::Apex && name_of(other) != source;
            EXPECT_TRUE(!is_other || !crosses || carried.contains(name_of(other)))
                << name_of(other);
        }
        EXPECT_LT(carried.size(), branches.size() - 2);
    }
    auto const alone
        = copied_by(skeleton, std::vector { from, Vec2(from + Vec2(0.1, 0.1)) }).value();
    EXPECT_EQ(alone, (ChosenStyles { { source, "" } }));
    EXPECT_FALSE(copied_by(skeleton, std::vector { Vec2(0, 0), from })) << "from the trunk";
}

TEST(ChosenStyle, IsWhatASourceHasItself)
{
    auto drawing = with_limb();
    auto const skeleton = skeleton_of_lines(drawing);
    auto const a = drawing.own_outlines[0].branch;
    std::vector<std::string> names;
    for (auto const& branch : skeleton.systems[0].branches)
        if (!branch.is_refined() && branch.origin == Branch::Origin::Bump)
            names.push_back(name_of(branch));
    ASSERT_GE(names.size(), 3u);
    ChosenStyles styles;
    ASSERT_TRUE(choose_styles(styles, { { names[0], a } }, skeleton));
    ASSERT_TRUE(choose_styles(styles, { { names[1], names[0] }, { a, names[0] } }, skeleton));
    EXPECT_EQ(styles, (ChosenStyles { { names[0], a }, { names[1], a } })) << "no circle";
    ASSERT_TRUE(choose_styles(styles, { { a, names[2] } }, skeleton));
    EXPECT_EQ(source_of(styles, names[1]), names[2]) << "what it is given later, too";
    ASSERT_TRUE(choose_styles(styles, { { a, "" } }, skeleton));
    EXPECT_EQ(source_of(styles, names[1]), a);
}

TEST(ChosenStyle, RefusesWhatHasNone)
{
    auto drawing = with_limb();
    auto const flat = skeleton_of_lines(drawing, { .levels = 1 });
    auto const a = drawing.own_outlines[0].branch;
    auto const plain = find_branch(flat, [](Branch const& branch) { return !branch.is_refined(); });
    auto const said = [&](ChosenStyles const& chosen) {
        ChosenStyles styles;
        auto const done = choose_styles(styles, chosen, flat);
        EXPECT_TRUE(styles.empty());
        return done ? std::string("it is taken") : done.error().message;
    };
    EXPECT_NE(said({ { a, plain } }).find("bears no branches"), std::string::npos);
    EXPECT_NE(said({ { "b99", a } }).find("no branch b99"), std::string::npos);
    EXPECT_NE(said({ { a, "b99" } }).find("no branch b99"), std::string::npos);
    EXPECT_NE(said({ { plain, "" } }).find("no other one's style"), std::string::npos);
    EXPECT_NE(said({}).find("no branch is chosen"), std::string::npos);
}

class ChosenStyleEdits : public ::testing::Test {
protected:
    using Part = DrawTree::Part;

    static scene::Scene draw(scene::Scene const& before, Part part, std::vector<Vec2> const& points)
    {
        return draw_on(before, { .part = part, .stroke = stroke_of(points) });
    }

    static OutlinedTree const& tree(scene::Scene const& scene)
    {
        return *outlined_tree(*scene.drawn);
    }

    static scene::Scene with_outlined_limb()
    {
        auto const lines = lobed_crown(7);
        return draw(draw(draw({}, Part::Trunk, lines.trunk), Part::Outline, lines.outline[0]),
                    Part::OwnOutline, limb());
    }
};

TEST_F(ChosenStyleEdits, MakeTheTreeOfTheirChoice)
{
    auto const before = with_outlined_limb();
    auto const skeleton = skeleton_of(tree(before)).value();
    auto const target
        = find_branch(skeleton, [](Branch const& branch) { return !branch.is_refined(); });
    auto const source = tree(before).own_outlines[0].branch;
    ChooseStyles const edit { before.state.active, { { target, source } } };
    auto const after = scene::apply_edit(before, edit).value();
    auto drawing = with_limb();
    drawing.styles[target] = source;
    auto const made = skeleton_of_lines(drawing);
    EXPECT_EQ(after.base->node_position_mm,
              make_tree(made, tree_options({}, drawn_height(made) / 0.1)).plant.node_position_mm);
    EXPECT_NE(after.base->node_position_mm, before.base->node_position_mm);
    ChooseStyles const back { before.state.active, { { target, "" } } };
    EXPECT_EQ(scene::apply_edit(after, back)->base->node_position_mm,
              before.base->node_position_mm);
    EXPECT_FALSE(scene::apply_edit(before, back)) << "it has none";
}

// If the crown changes slightly, chosen styles must stay. If the new crown lacks the branch, they
// must wait.
TEST_F(ChosenStyleEdits, StayWithTheirBranches)
{
    auto const lines = lobed_crown(7);
    auto const before = with_outlined_limb();
    auto const skeleton = skeleton_of(tree(before)).value();
    auto const target = find_branch(skeleton, [](Branch const& branch) {
        return !branch.is_refined() && branch.origin == Branch::Origin::Bump;
    });
    auto const source = tree(before).own_outlines[0].branch;
    auto const chosen
        = scene::apply_edit(before, ChooseStyles { before.state.active, { { target, source } } })
              .value();
    Similarity const larger { .turn = Vec2(1.02, 0.01) };
    auto const redrawn = draw(chosen, Part::Outline, larger.points(lines.outline[0]));
    EXPECT_EQ(tree(redrawn).styles, tree(chosen).styles);
    EXPECT_EQ(count_without_effect(tree(redrawn)).value(), 0u);
    EXPECT_EQ(
        skeleton_of(tree(redrawn))->systems[0].branches[skeleton.at(target)->branch].style_from,
        source);
    auto const narrow = draw(chosen, Part::Outline, ellipse(16, 60).outline[0]);
    EXPECT_EQ(tree(narrow).styles.size(), 1u);
    EXPECT_EQ(count_without_effect(tree(narrow)).value(), 2u) << "the outline and the style";
    auto const erased
        = scene::apply_edit(chosen, EraseTreePart { chosen.state.active, Part::Outline }).value();
    auto const again = draw(erased, Part::Outline, lines.outline[0]);
    EXPECT_EQ(count_without_effect(tree(again)).value(), 0u);
    EXPECT_EQ(again.base->node_position_mm, chosen.base->node_position_mm);
}

} // namespace
} // namespace tractus::silhouette
