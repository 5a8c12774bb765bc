#include "engine/methods/silhouettes/own_outline.h"

#include "engine/methods/silhouettes/coverage_grid.h"
#include "engine/methods/silhouettes/tree.h"
#include "tests/engine/methods/silhouettes/outlines.h"

#include <algorithm>
#include <cmath>

namespace tractus::silhouette {
namespace {

// Returns an ellipse around the outer part of a branch, with the given number of lobes.
std::vector<Vec2> lobe_around(Branch const& branch, int lobes, double size = 1)
{
    auto const& curve = branch.path.curve;
    Vec2 const way = curve.end - curve.base;
    Vec2 const along = direction_of(way);
    Vec2 const across = turned(along, kPi / 2);
    Vec2 const middle = curve.base + 0.85 * way;
    double const reach = 0.5 * size * way.norm();
    std::vector<Vec2> outline;
    for (int i = 0; i < 120; ++i) {
        double const angle = kPi + i * kPi / 60;
        double const r = reach * (1 + 0.25 * std::fabs(std::cos(0.5 * lobes * angle)));
        outline.emplace_back(middle + r * std::cos(angle) * along
                             + 0.7 * r * std::sin(angle) * across);
    }
    return outline;
}

Skeleton grown(Drawing const& drawing, SkeletonOptions const& options = {})
{
    auto result = infer_skeleton(drawing, options);
    EXPECT_TRUE(result) << result.error().message;
    return result ? *std::move(result) : Skeleton();
}

Drawing with_part(Drawing drawing, std::vector<Vec2> const& part)
{
    auto const added = add_own_outline(drawing, part);
    EXPECT_TRUE(added) << added.error().message;
    return drawing;
}

std::string refusal_of(Drawing drawing, std::vector<Vec2> const& part)
{
    auto const added = add_own_outline(drawing, part);
    return added ? "it is taken" : added.error().message;
}

TEST(OwnOutline, IsOfTheBranchThatItLiesAround)
{
    auto const system = grown(lobed_crown(5)).systems[0];
    int found = 0;
    for (std::size_t i = 0; i < system.branches.size(); ++i) {
        auto const& branch = system.branches[i];
        if (branch.origin != Branch::Origin::Bump)
            continue;
        ++found;
        for (double const size : { 0.8, 1.0, 1.2 })
            EXPECT_EQ(branch_in(system, lobe_around(branch, 3, size)), i)
                << name_of(branch) << " " << size;
        EXPECT_EQ(branch_in(system, branch.crown), i) << "as it was inferred";
    }
    EXPECT_GE(found, 4);
}

TEST(OwnOutline, IsNotOneOfTheWholeCrown)
{
    auto const drawing = lobed_crown(5);
    auto const system = grown(drawing).systems[0];
    for (double const size : { 1.05, 0.95, 0.8, 0.72 }) {
        Similarity const smaller { .turn = Vec2(size, 0) };
        EXPECT_FALSE(branch_in(system, smaller.points(drawing.outline[0]))) << size;
    }
    auto const around_trunk = ellipse(12, 40).outline[0];
    EXPECT_FALSE(branch_in(system, around_trunk));
    std::vector<Vec2> const beside { { 200, 0 }, { 220, 0 }, { 220, 20 }, { 200, 20 } };
    EXPECT_FALSE(branch_in(system, beside));
    EXPECT_FALSE(branch_in(system, std::vector<Vec2> { { 1, 1 }, { 2, 2 } }));
    EXPECT_FALSE(branch_in(system, {}));
}

// The branches in the drawn outline must be inferred from it, in the same way as for a crown. All
// other branches must stay.
TEST(OwnOutline, TakesTheInferredOnesPlace)
{
    auto const drawing = lobed_crown(5);
    auto const before = grown(drawing);
    auto const name = std::string("b1");
    auto const i = number_of(before.systems[0], name).value();
    auto const lobe = lobe_around(before.systems[0].branches[i], 5);
    auto const after = grown(with_part(drawing, lobe));
    auto const& branch = after.systems[0].branches[i];
    EXPECT_TRUE(branch.is_outlined());
    auto const below = after.system_of[0][i];
    ASSERT_NE(below, kNoSystem);
    auto const& own = after.systems[below];
    EXPECT_TRUE(own.is_of_own_outline);
    EXPECT_GE(own.coverage_after, 0.85);
    Drawing const alone { { lobe }, branch.path.curve.points(17), {} };
    auto const expected = infer_system(alone, { .outline = { .samples = 160 } }).value();
    EXPECT_EQ(own.bumps.size(), expected.bumps.size());
    EXPECT_GE(own.branches.size(), 5U);
    for (auto const& one : own.branches)
        EXPECT_LE(excursion(lobe, one.path.curve.points(17)), 0.02 * box_of(lobe).diagonal());
    ASSERT_EQ(after.systems[0].branches.size(), before.systems[0].branches.size());
    for (std::size_t k = 0; k < before.systems[0].branches.size(); ++k) {
        auto const& one = before.systems[0].branches[k];
        EXPECT_EQ(name_of(after.systems[0].branches[k]), name_of(one));
        if (k != i && one.model != i) {
            EXPECT_EQ(after.systems[0].branches[k].crown, one.crown) << name_of(one);
        }
    }
}

TEST(OwnOutline, AnotherOneReplacesIt)
{
    auto const drawing = lobed_crown(5);
    auto const system = grown(drawing).systems[0];
    auto const& branch = system.branches[number_of(system, "b2").value()];
    auto const first = with_part(drawing, lobe_around(branch, 3, 1.2));
    auto const second = with_part(first, lobe_around(branch, 5, 0.9));
    ASSERT_EQ(second.own_outlines.size(), 1U);
    EXPECT_EQ(second.own_outlines[0].branch, "b2");
    EXPECT_EQ(second.own_outlines[0].outline, lobe_around(branch, 5, 0.9));
    auto const other = system.branches[number_of(system, "b1").value()];
    EXPECT_EQ(with_part(second, lobe_around(other, 3)).own_outlines.size(), 2U);
}

// Returns the share of an outline that the leaves of a branch cover, seen from the side of the
// drawing.
double filled(Skeleton const& skeleton, std::string const& branch, std::vector<Vec2> const& outline)
{
    auto const tree = make_tree(skeleton);
    auto const& plant = tree.plant;
    Vec2 const foot = skeleton.systems[0].trunk.front();
    double const unit = drawn_height(skeleton) / 8000;
    double const reach = 0.015 * box_of(skeleton.systems[0].outline).diagonal();
    CoverageGrid grid(outline);
    for (auto const& organ : plant.organs) {
        std::size_t axis = 0;
        while (organ.segment >= plant.axes[axis].first_segment + plant.axes[axis].segment_count)
            ++axis;
        auto const& name = tree.axis_names[axis];
        if (name.substr(0, name.find('/')) != branch)
            continue;
        for (auto const& patch : plant.organ_shapes[organ.shape].patches) {
            Vec3 const leaf = organ.position_mm
                + organ.orientation * (double { organ.scale.x() } * patch.at(0.5, 0.5));
            Vec2 const seen = foot + unit * Vec2(leaf.x(), leaf.z());
            std::vector<Vec2> const blur { seen + Vec2(-reach, -reach), seen + Vec2(reach, -reach),
                                           seen + Vec2(reach, reach), seen + Vec2(-reach, reach) };
            grid.cover(grid.cells_of(blur));
        }
    }
    return grid.coverage();
}

TEST(OwnOutline, IsFilledWithLeaves)
{
    auto const drawing = lobed_crown(7);
    auto const before = grown(drawing);
    for (auto const* const name : { "b1", "b2" }) {
        auto const& branch = before.systems[0].branches[number_of(before.systems[0], name).value()];
        auto const lobe = lobe_around(branch, 5, 1.1);
        double const inferred = filled(before, name, lobe);
        double const drawn = filled(grown(with_part(drawing, lobe)), name, lobe);
        EXPECT_GE(drawn, 0.75) << name;
        EXPECT_GE(drawn, inferred + 0.05) << name;
    }
}

// The copies of the branch must have its new shape. They must not be larger than before, and must
// lie within the crown.
TEST(OwnOutline, ItsCopiesFollow)
{
    auto const drawing = lobed_crown(7);
    auto const before = grown(drawing);
    auto const& branches = before.systems[0].branches;
    auto const copy = std::find_if(branches.begin(), branches.end(),
                                   [](Branch const& branch) { return branch.model.has_value(); });
    ASSERT_NE(copy, branches.end());
    auto const after = grown(with_part(drawing, lobe_around(branches[*copy->model], 5)));
    auto const& system = after.systems[0];
    int copies = 0;
    for (std::size_t k = 0; k < branches.size(); ++k) {
        if (branches[k].model != copy->model)
            continue;
        ++copies;
        auto const& follower = system.branches[k];
        ASSERT_EQ(follower.model, copy->model);
        EXPECT_EQ(after.system_of[0][k], after.system_of[0][*copy->model]);
        EXPECT_EQ(follower.crown, follower.from_model.points(system.branches[*copy->model].crown));
        EXPECT_LE(std::fabs(signed_area(follower.crown)),
                  1.001 * std::fabs(signed_area(branches[k].crown)));
        EXPECT_LT((follower.path.curve.base - branches[k].path.curve.base).norm(), 1e-6);
        EXPECT_LE(excursion(system.outline, follower.crown),
                  0.05 * box_of(system.outline).diagonal());
    }
    EXPECT_GE(copies, 1);
}

// If an outline is drawn for a branch that was copied to fill an empty space, the branch must no
// longer be a copy.
TEST(OwnOutline, MakesACopyABranchOfItsOwn)
{
    auto const drawing = lobed_crown(7);
    auto const system = grown(drawing).systems[0];
    std::size_t done = 0;
    for (std::size_t i = 0; i < system.branches.size(); ++i) {
        auto const& branch = system.branches[i];
        if (!branch.model || branch_in(system, branch.crown) != i)
            continue;
        ++done;
        auto const after = grown(with_part(drawing, branch.crown));
        EXPECT_TRUE(after.systems[0].branches[i].is_outlined());
        EXPECT_FALSE(after.systems[0].branches[i].model);
        EXPECT_NE(after.system_of[0][i], after.system_of[0][*branch.model]);
    }
    EXPECT_GE(done, 1U);
}

TEST(OwnOutline, BearsBranchesWhereNoOthersDo)
{
    auto const drawing = lobed_crown(5);
    auto const system = grown(drawing, { .levels = 1 }).systems[0];
    auto const i = number_of(system, "b1").value();
    auto const part = with_part(drawing, lobe_around(system.branches[i], 5));
    auto const skeleton = grown(part, { .levels = 1 });
    EXPECT_EQ(skeleton.systems.size(), 2U);
    EXPECT_GE(skeleton.branches_on({ 0, i }), 5U);
    check_plant(make_tree(skeleton).plant);
}

TEST(OwnOutline, AMovedAndTurnedDrawingHasTheMovedOne)
{
    auto const drawing = lobed_crown(7);
    auto const plain = grown(drawing).systems[0];
    auto const lobe = lobe_around(plain.branches[number_of(plain, "b1").value()], 5);
    Similarity const way { .to = Vec2(12, -345), .turn = Vec2(0.3, -1.7) };
    auto const skeleton = grown(with_part(drawing, lobe));
    auto const other = grown(with_part(moved(drawing, way), way.points(lobe)));
    ASSERT_EQ(skeleton.systems.size(), other.systems.size());
    double const close = 1e-6 * box_of(other.systems[0].outline).diagonal();
    for (std::size_t s = 0; s < skeleton.systems.size(); ++s) {
        ASSERT_EQ(skeleton.systems[s].branches.size(), other.systems[s].branches.size());
        for (std::size_t i = 0; i < skeleton.systems[s].branches.size(); ++i) {
            auto const& a = skeleton.systems[s].branches[i].path.curve;
            auto const& b = other.systems[s].branches[i].path.curve;
            for (double const x : { 0.0, 0.3, 1.0 })
                EXPECT_LT((way.point(a.at(x)) - b.at(x)).norm(), close);
        }
    }
}

// Returns an upper bound of the coverage that the crown loses, as a share of its area. The sum
// consists of the part of each branch's inferred crown outside its new outline, and of the crowns
// of its copies.
double most_lost(BranchingSystem const& before, std::vector<OwnOutline> const& outlines)
{
    double lost = 0;
    for (auto const& own : outlines) {
        auto const i = number_of(before, own.branch).value();
        for (std::size_t k = 0; k < before.branches.size(); ++k) {
            auto const& branch = before.branches[k];
            double const area = std::fabs(signed_area(branch.crown));
            if (k == i || branch.model == i)
                lost += k == i ? 2 * area / 3 : area;
        }
    }
    return lost / signed_area(before.outline);
}

TEST(OwnOutline, RandomOnesMakePlants)
{
    int taken = 0;
    for (std::uint32_t number = 0; number < 60; ++number) {
        Random random({ 41, 3, number });
        auto drawing = lobed_crown(3 + static_cast<int>(number % 8));
        auto const before = grown(drawing).systems[0];
        for (int part = 0; part < 3; ++part) {
            auto const& branch = before.branches[random.next_u32() % before.branches.size()];
            auto stroke = lobe_around(branch, 1 + static_cast<int>(random.next_u32() % 7),
                                      random.uniform(0.2, 2));
            for (auto& point : stroke)
                point += random.uniform(0, 6) * Vec2(random.uniform(-1, 1), random.uniform(-1, 1));
            taken += add_own_outline(drawing, stroke).has_value();
        }
        auto const skeleton = grown(drawing);
        check_plant(make_tree(skeleton).plant);
        constexpr double kCells = 0.02; // Tolerance, since areas are counted in cells.
        EXPECT_GE(skeleton.systems[0].coverage_after,
                  before.coverage_after - most_lost(before, drawing.own_outlines) - kCells)
            << number;
    }
    EXPECT_GE(taken, 60);
}

// Lines that have no meaning where they are drawn must be refused, and must not change anything.
TEST(OwnOutline, SaysWhatIsWrong)
{
    auto const drawing = lobed_crown(5);
    EXPECT_NE(refusal_of(drawing, drawing.outline[0]).find("around none of the tree's branches"),
              std::string::npos);
    EXPECT_NE(refusal_of(drawing, {}).find("around none"), std::string::npos);
    EXPECT_NE(refusal_of({ {}, drawing.trunk }, drawing.outline[0]).find("outline"),
              std::string::npos);
    auto waiting = drawing;
    waiting.own_outlines.push_back({ "b99", drawing.outline[0] });
    EXPECT_EQ(grown(waiting).branch_count(), grown(drawing).branch_count());
    waiting.own_outlines[0] = { "b1", { { 200, 0 }, { 220, 0 }, { 220, 20 }, { 200, 20 } } };
    EXPECT_EQ(grown(waiting).branch_count(), grown(drawing).branch_count())
        << "it does not hold the branch";
}

} // namespace
} // namespace tractus::silhouette
