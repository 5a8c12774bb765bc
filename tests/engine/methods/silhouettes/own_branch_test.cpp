#include "engine/methods/silhouettes/own_branch.h"

#include "engine/methods/silhouettes/own_outline.h"
#include "engine/methods/silhouettes/tree.h"
#include "tests/engine/methods/silhouettes/outlines.h"

#include <algorithm>
#include <cmath>

namespace tractus::silhouette {
namespace {

Skeleton refined(Drawing const& drawing, SkeletonOptions const& options = {})
{
    auto result = infer_skeleton(drawing, options);
    EXPECT_TRUE(result) << result.error().message;
    return result ? *std::move(result) : Skeleton();
}

// Returns a curved line that begins at `place` on a branch and leads to its left. Its length is a
// share of the branch's length.
std::vector<Vec2> twig_on(Branch const& branch, double place, double share = 0.35)
{
    auto const& curve = branch.path.curve;
    Vec2 const from = curve.at(place);
    Vec2 const along = direction_of(curve.at(place + 0.05) - from);
    std::vector<Vec2> line;
    for (int i = 0; i <= 20; ++i) {
        double const far = share * branch.path.length * i / 20;
        double const bend = 0.3 * std::sin(kPi * i / 20);
        line.emplace_back(from + far * turned(along, radians(50) + bend));
    }
    return line;
}

Drawing with_twig(Drawing drawing, std::vector<Vec2> const& line,
                  StyleScope style_to = StyleScope::None)
{
    auto const added = add_own_branch(drawing, line, style_to);
    EXPECT_TRUE(added) << added.error().message;
    return drawing;
}

Branch const& drawn_on(Skeleton const& skeleton, std::size_t parent)
{
    static Branch const none;
    auto const below = skeleton.system_of[0][parent];
    if (below != kNoSystem)
        for (auto const& branch : skeleton.systems[below].branches)
            if (branch.is_stroke())
                return branch;
    ADD_FAILURE() << "nothing was drawn on branch " << parent;
    return none;
}

TEST(OwnBranch, IsOfTheBranchThatItBeginsOn)
{
    auto const drawing = lobed_crown(5);
    auto const system = refined(drawing).systems[0];
    int found = 0;
    for (std::size_t i = 0; i < system.branches.size(); ++i) {
        auto const& branch = system.branches[i];
        if (branch.origin != Branch::Origin::Bump)
            continue;
        ++found;
        EXPECT_EQ(parent_of(system, twig_on(branch, 0.7)), i) << name_of(branch);
    }
    EXPECT_GE(found, 4);
    EXPECT_FALSE(parent_of(system, std::vector<Vec2> { { 0, 0 }, { 20, 10 } })) << "on the trunk";
    EXPECT_FALSE(parent_of(system, std::vector<Vec2> { { 200, 0 }, { 220, 10 } })) << "beside it";
    EXPECT_FALSE(parent_of(system, system.branches[0].crown)) << "it comes back";
    auto refused = drawing;
    auto const answer = add_own_branch(refused, { { 0, 0 }, { 20, 10 } }, StyleScope::None);
    ASSERT_FALSE(answer);
    EXPECT_NE(answer.error().message.find("begins on none"), std::string::npos);
}

// In the skeleton and in the plant, every node of the branch must lie on the stroke, in the plane
// of the drawing.
TEST(OwnBranch, RunsAsItWasDrawn)
{
    auto const drawing = lobed_crown(5);
    auto const before = refined(drawing);
    auto const parent = *number_of(before.systems[0], "b1");
    auto const line = twig_on(before.systems[0].branches[parent], 0.6);
    auto const skeleton = refined(with_twig(drawing, line));
    auto const& branch = drawn_on(skeleton, parent);
    EXPECT_EQ(branch.stroke, line);
    EXPECT_LT((branch.path.curve.base - line.front()).norm(),
              before.systems[0].branches[parent].path.length / 63);
    EXPECT_LT((branch.path.curve.end - line.back()).norm(), 1e-9);
    auto const tree = make_tree(skeleton);
    check_plant(tree.plant);
    Vec2 const foot = skeleton.systems[0].trunk.front();
    double const unit = drawn_height(skeleton) / 8000;
    int found = 0;
    for (std::size_t a = 0; a < tree.axis_names.size(); ++a) {
        if (tree.axis_names[a] != "b1/" + name_of(branch))
            continue;
        ++found;
        auto const nodes = tree.plant.positions(tree.plant.axes[a]);
        EXPECT_GE(nodes.size(), 17U);
        for (auto const& node : nodes) {
            EXPECT_LT(std::fabs(node.y()), 1e-9);
            Vec2 const seen = foot + unit * Vec2(node.x(), node.z());
            EXPECT_LT(distance_to_line(seen, branch.line(2)), 1e-9);
        }
        Vec2 const end = foot + unit * Vec2(nodes.back().x(), nodes.back().z());
        EXPECT_LT((end - line.back()).norm(), 1e-9);
    }
    EXPECT_EQ(found, 1);
}

// All other branches of the tree must stay. Of the parent's branches, one that ended in the same
// bump must be replaced.
TEST(OwnBranch, TakesThePlaceOfTheOneThatEndsThere)
{
    auto drawing = lobed_crown(7);
    std::vector<Vec2> limb; // An outline of the parent, with bumps of its own.
    for (int i = 0; i < 160; ++i) {
        double const angle = i * kPi / 80;
        double const r = 30 * (1 + 0.25 * std::fabs(std::sin(3.5 * angle)));
        limb.emplace_back(52 + r * std::cos(angle), -18 + 0.8 * r * std::sin(angle));
    }
    ASSERT_TRUE(add_own_outline(drawing, limb));
    auto const before = refined(drawing);
    auto const parent = *number_of(before.systems[0], drawing.own_outlines[0].branch);
    auto const& had = before.systems[before.system_of[0][parent]];
    auto const bump
        = std::find_if(had.branches.begin(), had.branches.end(),
                       [](Branch const& branch) { return branch.origin == Branch::Origin::Bump; });
    ASSERT_NE(bump, had.branches.end());
    auto const& curve = before.systems[0].branches[parent].path.curve;
    std::vector<Vec2> const line { curve.at(0.55), bump->path.curve.end };
    auto const after = refined(with_twig(drawing, line));
    auto const& has = after.systems[after.system_of[0][parent]];
    auto const count = [](BranchingSystem const& system, Branch::Origin origin) {
        return std::count_if(system.branches.begin(), system.branches.end(),
                             [&](Branch const& branch) { return branch.origin == origin; });
    };
    EXPECT_EQ(count(has, Branch::Origin::Drawn), 1);
    EXPECT_EQ(count(has, Branch::Origin::Bump), count(had, Branch::Origin::Bump) - 1);
    ASSERT_EQ(after.systems[0].branches.size(), before.systems[0].branches.size());
    for (std::size_t i = 0; i < before.systems[0].branches.size(); ++i)
        EXPECT_EQ(after.systems[0].branches[i].crown, before.systems[0].branches[i].crown);
}

// If a style gives branches no branches, a parent must have only those drawn on it.
TEST(OwnBranch, StandsWhereNoOthersDo)
{
    auto const drawing = lobed_crown(5);
    auto const system = refined(drawing, { .levels = 1 }).systems[0];
    auto const parent = *number_of(system, "b2");
    auto const one = with_twig(drawing, twig_on(system.branches[parent], 0.5));
    auto const two = with_twig(one, twig_on(system.branches[parent], 0.7));
    EXPECT_EQ(refined(one, { .levels = 1 }).branches_on({ 0, parent }), 1U);
    EXPECT_EQ(refined(two, { .levels = 1 }).branches_on({ 0, parent }), 2U);
    EXPECT_GT(refined(two).branches_on({ 0, parent }), 2U) << "others stand beside them";
    auto waiting = drawing;
    waiting.own_branches.push_back({ "b99", twig_on(system.branches[parent], 0.5) });
    EXPECT_EQ(refined(waiting).branch_count(), refined(drawing).branch_count());
}

// If the drawing is mirrored, moved or rotated, its branch must be transformed in the same way.
TEST(OwnBranch, GoesWithItsDrawing)
{
    auto const drawing = lobed_crown(7);
    auto const system = refined(drawing).systems[0];
    auto const line = twig_on(system.branches[*number_of(system, "b1")], 0.6);
    auto const plain = with_twig(drawing, line);
    auto const has = refined(plain);
    auto const parent = *number_of(has.systems[0], plain.own_branches[0].branch);
    Similarity const turn { .to = Vec2(12, -345), .turn = Vec2(0.3, -1.7) };
    Similarity const mirror { .turn = Vec2(-1, 0), .mirrors = true };
    for (auto const& way : { turn, mirror }) {
        auto const other = with_twig(moved(drawing, way), way.points(line));
        auto const skeleton = refined(other);
        auto const number = *number_of(skeleton.systems[0], other.own_branches[0].branch);
        double const close = 0.005 * box_of(skeleton.systems[0].outline).diagonal();
        auto const& one = has.systems[0].branches[parent].path.curve;
        auto const& same = skeleton.systems[0].branches[number].path.curve;
        EXPECT_LT((way.point(one.end) - same.end).norm(), close);
        EXPECT_EQ(drawn_on(skeleton, number).stroke, way.points(line));
        EXPECT_LT((way.point(drawn_on(has, parent).path.curve.base)
                   - drawn_on(skeleton, number).path.curve.base)
                      .norm(),
                  close);
    }
}

TEST(OwnBranch, RandomOnesMakePlants)
{
    int taken = 0;
    for (std::uint32_t number = 0; number < 40; ++number) {
        Random random({ 43, 3, number });
        auto drawing = lobed_crown(3 + static_cast<int>(number % 8));
        auto const system = refined(drawing).systems[0];
        for (int part = 0; part < 4; ++part) {
            auto const& branch = system.branches[random.next_u32() % system.branches.size()];
            auto line = twig_on(branch, random.uniform(0.1, 0.95), random.uniform(0.01, 1.5));
            for (auto& point : line)
                point += random.uniform(0, 3) * Vec2(random.uniform(-1, 1), random.uniform(-1, 1));
            taken += add_own_branch(drawing, line,
                                    part % 2 == 0 ? StyleScope::None : StyleScope::Siblings)
                         .has_value();
        }
        for (int const levels : { 1, 2 })
            check_plant(make_tree(refined(drawing, { .levels = levels })).plant);
    }
    EXPECT_GE(taken, 60);
}

} // namespace
} // namespace tractus::silhouette
