#include "engine/methods/silhouettes/bump_touch.h"

#include "engine/base/random.h"
#include "engine/methods/silhouettes/own_outline.h"
#include "tests/engine/methods/silhouettes/refined.h"

#include <array>
#include <set>

namespace tractus::silhouette {
namespace {

using Kind = BumpTouch::Kind;
using Part = DrawTree::Part;

// Direction of the first lobe of lobed_crown(5), which is on the right, and the angle between its
// lobes.
constexpr double kFirst_deg = -25;
constexpr double kStep_deg = 57.5;
Vec2 lobe(int number)
{
    return 62 * turned(Vec2::UnitX(), radians(kFirst_deg + kStep_deg * number));
}
Vec2 notch_after(int number)
{
    Vec2 const way = turned(Vec2::UnitX(), radians(kFirst_deg + kStep_deg * (number + 0.5)));
    auto const outline = lobed_crown(5).outline[0];
    return *std::max_element(outline.begin(), outline.end(), [&](auto const& a, auto const& b) {
        return direction_of(a).dot(way) < direction_of(b).dot(way);
    });
}

BranchingSystem system_of(Drawing const& drawing)
{
    auto system = infer_system(drawing);
    EXPECT_TRUE(system) << system.error().message;
    return system.value_or(BranchingSystem {});
}

// Returns the number of bump branches that end within the disc of a lobe.
std::size_t ends_in(BranchingSystem const& system, Vec2 const& middle, double radius = 30)
{
    return static_cast<std::size_t>(
        std::count_if(system.branches.begin(), system.branches.end(), [&](Branch const& branch) {
            return branch.origin == Branch::Origin::Bump
                && (branch.path.curve.end - middle).norm() <= radius;
        }));
}

Drawing touched_crown(std::vector<BumpTouch> touches)
{
    auto drawing = lobed_crown(5);
    for (auto const& touch : touches) {
        auto const added = add_touch(drawing, touch);
        EXPECT_TRUE(added) << added.error().message;
    }
    return drawing;
}

TEST(BumpTouch, SplitsABumpWhereTheRayThroughItLeaves)
{
    auto const before = system_of(lobed_crown(5));
    ASSERT_EQ(ends_in(before, lobe(1)), 1u);
    auto const after = system_of(touched_crown({ { Kind::Split, lobe(1) } }));
    EXPECT_EQ(after.bumps.size(), before.bumps.size() + 1);
    EXPECT_EQ(ends_in(after, lobe(1)), 2u);
    EXPECT_EQ(after.touches_taken, 1u);
    std::vector<Bump> halves;
    for (auto const& bump : after.bumps)
        if (bump.touch)
            halves.push_back(bump);
    ASSERT_EQ(halves.size(), 2u);
    EXPECT_EQ(halves[0].arc.last, halves[1].arc.first);
    // The lobe is symmetric about the ray from the origin through the lobe's middle.
    Vec2 const ray = direction_of(lobe(1));
    EXPECT_LT(std::fabs(cross(ray, after.outline[halves[0].arc.last])), 3) << "a sample's step";
    EXPECT_LT(cross(ray, halves[0].end) * cross(ray, halves[1].end), 0);
    EXPECT_NEAR(halves[0].end.dot(ray), halves[1].end.dot(ray), 3);
    for (auto const& half : halves)
        EXPECT_TRUE(is_inside(after.outline, half.end));
    // Each half is about a quarter of the lobe's circle. So the radius of its ends must be that of
    // the lobe.
    double const radius = 1.12 * 62 * std::sin(radians(kStep_deg) / 2);
    EXPECT_NEAR(halves[0].radius, radius, 0.15 * radius);
}

TEST(BumpTouch, SplitsWhereItIsTouched)
{
    Vec2 const ray = direction_of(lobe(1));
    for (double const side_mm : { -12.0, 12.0 }) {
        Vec2 const place = lobe(1) + side_mm * turned(ray, kPi / 2);
        auto const system = system_of(touched_crown({ { Kind::Split, place } }));
        for (std::size_t i = 0; i + 1 < system.bumps.size(); ++i)
            if (system.bumps[i].touch && system.bumps[i + 1].touch) {
                double const off = cross(ray, system.outline[system.bumps[i].arc.last]);
                EXPECT_GT(off * side_mm, 0);
                EXPECT_GT(std::fabs(off), 4);
            }
    }
}

TEST(BumpTouch, JoinsTwoBumpsByTheNotchBetweenThem)
{
    auto const before = system_of(lobed_crown(5));
    auto const after = system_of(touched_crown({ { Kind::Join, notch_after(0) } }));
    EXPECT_EQ(after.bumps.size(), before.bumps.size() - 1);
    EXPECT_EQ(ends_in(before, lobe(0)) + ends_in(before, lobe(1)), 2u);
    EXPECT_EQ(ends_in(after, lobe(0), 40) + ends_in(after, lobe(1), 40), 2u)
        << "one in reach of both";
    Vec2 const ray = direction_of(notch_after(0));
    for (auto const& bump : after.bumps)
        if (bump.touch) {
            EXPECT_LT(std::fabs(cross(ray, bump.end)), 4);
            EXPECT_TRUE(is_inside(after.outline, bump.end));
        }
}

// After a touch and its opposite, the system must be equal to the original, to the last bit.
TEST(BumpTouch, IsTakenBackByItsOpposite)
{
    auto const before = system_of(lobed_crown(5));
    auto drawing = touched_crown({ { Kind::Split, lobe(1) } });
    auto const halves = system_of(drawing);
    for (auto const& bump : halves.bumps)
        if (bump.touch) {
            ASSERT_TRUE(add_touch(drawing, { Kind::Join, halves.outline[bump.arc.last] }));
            break;
        }
    EXPECT_TRUE(drawing.touches.empty());
    drawing = touched_crown({ { Kind::Join, notch_after(0) }, { Kind::Split, notch_after(0) } });
    EXPECT_TRUE(drawing.touches.empty());
    EXPECT_EQ(system_of(drawing).bumps.size(), before.bumps.size());
}

TEST(BumpTouch, SplitsHalvesAgain)
{
    auto drawing = touched_crown({ { Kind::Split, lobe(3) } });
    auto const halves = system_of(drawing);
    for (auto const& bump : halves.bumps)
        if (bump.touch) {
            ASSERT_TRUE(add_touch(drawing, { Kind::Split, bump.end }));
            break;
        }
    auto const system = system_of(drawing);
    EXPECT_EQ(system.touches_taken, 2u);
    EXPECT_EQ(ends_in(system, lobe(3), 36), 3u);
}

TEST(BumpTouch, IsOfTheSmallestOutlineThatHasABumpThere)
{
    auto drawing = lobed_crown(5);
    ASSERT_TRUE(add_own_outline(drawing, limb()));
    auto const path = drawing.own_outlines[0].branch;
    auto const before = skeleton_of_lines(drawing);
    auto const below = before.system_of[0][before.at(path)->branch];
    auto const& system = before.systems[below];
    auto const bump = std::find_if(system.bumps.begin(), system.bumps.end(),
                                   [](Bump const& one) { return one.role == Role::Lateral; });
    ASSERT_NE(bump, system.bumps.end());
    ASSERT_TRUE(add_touch(drawing, { Kind::Split, bump->end }));
    EXPECT_EQ(drawing.touches[0].branch, path);
    auto const after = skeleton_of_lines(drawing);
    EXPECT_EQ(after.systems[0].bumps.size(), before.systems[0].bumps.size());
    auto const again = after.system_of[0][after.at(path)->branch];
    EXPECT_EQ(after.systems[again].bumps.size(), system.bumps.size() + 1);
    EXPECT_EQ(count_unmatched_touches(drawing, after), 0u);
    drawing.own_outlines.clear();
    EXPECT_EQ(count_unmatched_touches(drawing, skeleton_of_lines(drawing)), 1u);
    drawing.touches.clear();
    ASSERT_TRUE(add_touch(drawing, { Kind::Split, bump->end }, {}, Search::OnTrunk));
    EXPECT_EQ(drawing.touches[0].branch, "");
}

TEST(BumpTouch, IsRefusedWhereNoBumpIs)
{
    auto const refusal = [](BumpTouch const& touch) {
        auto drawing = lobed_crown(5);
        auto const added = add_touch(drawing, touch);
        return added ? std::string() : added.error().message;
    };
    EXPECT_NE(refusal({ Kind::Split, { 0, -20 } }).find("on no bump"), std::string::npos);
    EXPECT_NE(refusal({ Kind::Split, { 300, 0 } }).find("on no bump"), std::string::npos);
    EXPECT_NE(refusal({ Kind::Join, lobe(1) }).find("where two bumps meet"), std::string::npos);
    auto leaf = lobed_crown(5);
    leaf.is_leaf = true;
    auto const added = add_touch(leaf, { Kind::Split, lobe(1) });
    ASSERT_FALSE(added);
    EXPECT_NE(added.error().message.find("is a leaf"), std::string::npos);
}

// Returns the crown as redrawn, displaced by waves of at most `most` of its diagonal.
std::vector<Vec2> redrawn(std::vector<Vec2> outline, double most, std::uint32_t number)
{
    Random random({ 77, 1, number });
    double const diagonal = box_of(outline).diagonal();
    std::array<Vec2, 4> waves;
    std::array<double, 4> phases {};
    for (std::size_t k = 0; k < waves.size(); ++k) {
        waves[k] = turned(Vec2::UnitX(), random.uniform(0, 2 * kPi));
        phases[k] = random.uniform(0, 2 * kPi);
    }
    double const size = random.uniform(0, most) * diagonal / static_cast<double>(waves.size());
    auto const n = static_cast<double>(outline.size());
    for (std::size_t i = 0; i < outline.size(); ++i)
        for (std::size_t k = 0; k < waves.size(); ++k)
            outline[i] += size
                * std::sin(2 * kPi * static_cast<double>(i * (k + 1)) / n + phases[k]) * waves[k];
    return outline;
}

class BumpTouchEdits : public ::testing::Test {
protected:
    static scene::Scene touch(scene::Scene const& before, Part part, Vec2 const& place)
    {
        return draw_on(before,
                       { .part = part,
                         .stroke = stroke_of({ place, place + Vec2(0.2, 0.1) }),
                         .search = Search::AnyLevel });
    }
    static OutlinedTree const& drawing(scene::Scene const& scene)
    {
        return *outlined_tree(*scene.drawn);
    }
    static std::set<std::string> names_in(scene::Scene const& scene, Vec2 const& middle,
                                          double radius)
    {
        std::set<std::string> names;
        auto const skeleton = skeleton_of(drawing(scene)).value();
        for (auto const& branch : skeleton.systems[0].branches)
            if (branch.origin == Branch::Origin::Bump
                && (branch.path.curve.end - middle).norm() <= radius)
                names.insert(name_of(branch));
        return names;
    }
};

// For 100 redrawn crowns that differ by at most 3 % from the first one, splits, joins and names of
// bumps must stay.
TEST_F(BumpTouchEdits, OutlastACrownThatIsDrawnAnew)
{
    auto const both = touch(touch(lobed_tree(), Part::Split, lobe(1)), Part::Join, notch_after(3));
    auto const halves = names_in(both, lobe(1), 32);
    auto const joined = names_in(both, notch_after(3), 22);
    ASSERT_EQ(halves.size(), 2u);
    ASSERT_EQ(joined.size(), 1u);
    int stay = 0;
    constexpr int kTimes = 100;
    for (std::uint32_t i = 0; i < kTimes; ++i) {
        auto const again
            = draw_on(both,
                      { .part = Part::Outline,
                        .stroke = stroke_of(redrawn(lobed_crown(5).outline[0], 0.03, i)) });
        stay += count_without_effect(drawing(again)).value() == 0
            && names_in(again, lobe(1), 38) == halves
            && names_in(again, notch_after(3), 28) == joined;
    }
    EXPECT_GE(stay, 95);
}

TEST_F(BumpTouchEdits, WaitForTheirBumps)
{
    auto const split = touch(lobed_tree(), Part::Split, lobe(1));
    auto const narrow = draw_on(
        split, { .part = Part::Outline, .stroke = stroke_of(ellipse(16, 60).outline[0]) });
    EXPECT_EQ(count_without_effect(drawing(narrow)).value(), 1u);
    auto const again = draw_on(
        narrow, { .part = Part::Outline, .stroke = stroke_of(lobed_crown(5).outline[0]) });
    EXPECT_EQ(count_without_effect(drawing(again)).value(), 0u);
    auto const bare
        = scene::apply_edit(split, EraseTreePart { split.state.active, Part::Outline }).value();
    EXPECT_EQ(count_without_effect(drawing(bare)).value(), 1u);
}

TEST_F(BumpTouchEdits, AreErasedOrTakenBack)
{
    auto const before = lobed_tree();
    auto const split = touch(before, Part::Split, lobe(1));
    EXPECT_NE(split.base->node_position_mm, before.base->node_position_mm);
    ASSERT_EQ(drawing(split).touches.size(), 1u);
    auto const erased = scene::apply_edit(split,
                                          EraseTreePart { split.state.active, Part::Split,
                                                          drawing(split).touches[0].id })
                            .value();
    EXPECT_EQ(erased.base->axes.size(), before.base->axes.size());
    auto const joined = touch(before, Part::Join, notch_after(0));
    auto const again = touch(joined, Part::Split, notch_after(0));
    EXPECT_TRUE(drawing(again).touches.empty());
    EXPECT_EQ(again.base->axes.size(), before.base->axes.size());
}

// The tree must be the one that the same touches give without a document, except for names.
TEST_F(BumpTouchEdits, MakeTheTreeOfTheirLines)
{
    auto const scene = touch(lobed_tree(), Part::Split, lobe(1));
    auto const skeleton = skeleton_of_lines(touched_crown({ { Kind::Split, lobe(1) } }));
    auto const made = make_tree(skeleton, tree_options({}, drawn_height(skeleton) / 0.1));
    EXPECT_EQ(scene.base->axes.size(), made.plant.axes.size());
}

// An outline and a stroke on one half of a bump must follow the name of that half.
TEST_F(BumpTouchEdits, CarryWhatIsDrawnOnHalves)
{
    auto scene = touch(lobed_tree(), Part::Split, lobe(1));
    auto const skeleton = skeleton_of(drawing(scene)).value();
    auto const name = *names_in(scene, lobe(1), 32).begin();
    auto const& branch = skeleton.systems[0].branches[skeleton.at(name)->branch];
    Vec2 const from = branch.path.curve.at(0.7);
    scene = draw_on(scene,
                    { .part = Part::OwnBranch,
                      .stroke = stroke_of({ from, from + Vec2(2, 4), from + Vec2(5, 9) }) });
    ASSERT_EQ(drawing(scene).own_branches[0].branch, name);
    auto const again
        = draw_on(scene,
                  { .part = Part::Outline,
                    .stroke = stroke_of(redrawn(lobed_crown(5).outline[0], 0.03, 3)) });
    EXPECT_EQ(drawing(again).own_branches[0].branch, name);
    EXPECT_EQ(count_without_effect(drawing(again)).value(), 0u);
}

} // namespace
} // namespace tractus::silhouette
