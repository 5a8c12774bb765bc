#include "engine/methods/silhouettes/tree_edits.h"

#include "engine/scene/paper.h"
#include "engine/scene/scene.h"
#include "engine/scene/varied_scene.h"
#include "tests/engine/methods/silhouettes/outlines.h"

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

namespace tractus::silhouette {
namespace {

// Returns a crown of five lobes with a trunk whose base is at (0, -90).
Drawing crown()
{
    return lobed_crown(5);
}

DrawTree trunk()
{
    return { .part = DrawTree::Part::Trunk,
             .stroke = stroke_of(crown().trunk),
             .stands_at_mm = { 30, 0, 0 } };
}

DrawTree outline(scene::ItemId plant = 0)
{
    return { .part = DrawTree::Part::Outline,
             .stroke = stroke_of(crown().outline[0]),
             .plant = plant };
}

DrawTree branch(scene::ItemId plant)
{
    return { .part = DrawTree::Part::Branch,
             .stroke = stroke_of({ { 0, -10 }, { 25, 5 }, { 45, 10 }, { 60, 12 } }),
             .plant = plant };
}

scene::Scene drawn(scene::Edit const& edit, scene::Scene const& before = {})
{
    auto scene = scene::apply_edit(before, edit);
    EXPECT_TRUE(scene) << scene.error().message;
    return scene.value_or(scene::Scene {});
}

scene::Scene drawn_tree()
{
    auto const stem = drawn(trunk());
    return drawn(outline(stem.state.active), stem);
}

std::string refusal(scene::Edit const& edit, scene::Scene const& before = {})
{
    auto const scene = scene::apply_edit(before, edit);
    return scene ? std::string() : scene.error().message;
}

// The tree must be the one that `tractus silhouette` makes from the same lines.
TEST(DrawTree, IsTheTreeOfItsLines)
{
    auto const scene = drawn_tree();
    ASSERT_EQ(scene.plants.size(), 1u);
    auto const skeleton = infer_skeleton(crown()).value();
    auto const tree = make_tree(skeleton, tree_options({}, drawn_height(skeleton) / 0.1));
    EXPECT_EQ(scene.base->node_position_mm, tree.plant.node_position_mm);
    EXPECT_EQ(scene.base->organs.size(), tree.plant.organs.size());
}

TEST(DrawTree, StandsUnderItsInk)
{
    auto const stem = drawn(trunk());
    auto const whole = drawn_tree();
    for (auto const* const scene : { &stem, &whole }) {
        auto const paper = scene::paper_of(scene->state);
        EXPECT_EQ(paper.base_mm, Vec2(0, -90));
        EXPECT_EQ(scene->placement.origin_mm, Vec3(30, 0, 0));
        auto const& axis = scene->base->axes[0];
        Vec3 const first_mm = scene->placement.world_of_plant(scene->base->positions(axis)[0]);
        EXPECT_LT((paper.sheet_of_world(first_mm) - Vec2(0, -90)).norm(), 0.01);
        double off_mm = 0;
        for (auto const& node_mm : scene->base->positions(axis))
            off_mm = std::max(
                off_mm,
                std::fabs(paper.sheet_of_world(scene->placement.world_of_plant(node_mm)).x()));
        EXPECT_LT(off_mm, 0.5) << "the trunk was drawn straight up";
    }
    Bounds seen_mm;
    for (auto const& node_mm : whole.base->node_position_mm)
        seen_mm.add(whole.placement.world_of_plant(node_mm.cast<double>()));
    auto const box = box_of(crown().outline[0]);
    EXPECT_NEAR(seen_mm.max_mm.z(), box.high.y() + 90, 20) << "as high as drawn, but for twigs";
    EXPECT_NEAR(seen_mm.max_mm.x() - 30, box.high.x(), 12);
}

// If the trunk is redrawn 12 mm further right, the plant must move there. If the plant was moved by
// hand before, it must stay where it is.
TEST(DrawTree, MovesThePlantWithItsFoot)
{
    auto scene = drawn_tree();
    auto const plant = scene.state.active;
    auto moved = trunk();
    moved.plant = plant;
    moved.stroke = stroke_of({ { 12, -80 }, { 10, 40 } });
    scene = drawn(moved, scene);
    EXPECT_EQ(scene.placement.origin_mm, Vec3(42, 0, 0));
    EXPECT_EQ(scene::paper_of(scene.state).base_mm, Vec2(12, -80));
    scene = drawn(scene::MovePlant { plant, { -50, 20, 0 } }, scene);
    scene = drawn(outline(plant), scene);
    EXPECT_EQ(scene.placement.origin_mm, Vec3(-50, 20, 0));
}

TEST(DrawTree, LetsADrawnBranchTakeTheBumpsPlace)
{
    auto const before = drawn_tree();
    auto const after = drawn(branch(before.state.active), before);
    auto const branches = [](scene::Scene const& scene) {
        auto const skeleton = skeleton_of(*outlined_tree(*scene.drawn)).value();
        std::map<std::string, Branch::Origin> result;
        for (auto const& one : skeleton.systems[0].branches)
            if (one.origin == Branch::Origin::Bump || one.origin == Branch::Origin::Drawn)
                result[name_of(one)] = one.origin;
        return result;
    };
    auto const expected = branches(before);
    auto const given = branches(after);
    ASSERT_EQ(given.size(), expected.size()) << "it takes the place of one";
    int drawn_ones = 0;
    for (auto const& [name, origin] : given) {
        EXPECT_TRUE(expected.contains(name)) << name << ": and that one's name";
        drawn_ones += origin == Branch::Origin::Drawn;
    }
    EXPECT_EQ(drawn_ones, 1);
}

// Seen from the side of the drawing, points of the drawn branch must lie on the plant's branch.
TEST(DrawTree, FollowsADrawnBranch)
{
    auto const stroke = branch(0).stroke;
    auto drawing = crown();
    drawing.branches.push_back({});
    for (auto const& tip : stroke.tips)
        drawing.branches[0].emplace_back(tip.position_mm.head<2>());
    auto const system = infer_system(drawing).value();
    auto const found
        = std::find_if(system.branches.begin(), system.branches.end(),
                       [](Branch const& one) { return one.origin == Branch::Origin::Drawn; });
    ASSERT_NE(found, system.branches.end());
    auto const curve = found->path.curve.points(65);
    for (auto const& point : drawing.branches[0]) {
        double least = std::numeric_limits<double>::max();
        for (auto const& at : curve)
            least = std::min(least, (at - point).norm());
        EXPECT_LT(least, 1.5) << point.transpose();
    }
    EXPECT_EQ(found->path.side, Side::Right);
}

TEST(DrawTree, AddsTreesBesideEachOther)
{
    auto const first = drawn_tree();
    auto second = outline();
    second.stands_at_mm = { -60, 0, 0 };
    auto const both = drawn(second, first);
    ASSERT_EQ(both.plants.size(), 2u);
    EXPECT_EQ(both.plants[0], first.plants[0]) << "the first is not built again";
    EXPECT_EQ(both.placement.origin_mm, Vec3(-60, 0, 0));
    EXPECT_EQ(both.placement.scale, first.placement.scale);
}

// Returns the outline as a hand redraws it, with waves of at most 3 % of its diagonal.
std::vector<Vec2> wavered(std::vector<Vec2> const& outline, std::uint32_t number)
{
    Random random({ 31, 7, number });
    double const most_mm = 0.03 * box_of(outline).diagonal();
    std::vector<Vec2> result;
    std::array<double, 6> phase {};
    for (auto& one : phase)
        one = random.uniform(0, 2 * kPi);
    for (std::size_t i = 0; i < outline.size(); ++i) {
        double const at = 2 * kPi * static_cast<double>(i) / static_cast<double>(outline.size());
        Vec2 const way(std::sin(2 * at + phase[0]) + std::sin(3 * at + phase[1])
                           + std::sin(5 * at + phase[2]),
                       std::sin(2 * at + phase[3]) + std::sin(3 * at + phase[4])
                           + std::sin(5 * at + phase[5]));
        result.push_back(outline[i] + most_mm / (3 * std::sqrt(2.0)) * way);
    }
    return result;
}

// Returns the tips of the branches that strokes shape, by the ids of the strokes.
std::map<scene::ItemId, Vec3> shaped_tips_mm(scene::Scene const& scene)
{
    std::map<scene::ItemId, Vec3> tips_mm;
    auto const& plant = *scene.base;
    for (auto const& [id, association, at] : scene.associations)
        if (!association.is_orphaned)
            tips_mm[id] = plant.node_position_mm[nodes_of(plant, association.path.back()).tip];
    return tips_mm;
}

// Branches on which with_strokes() draws its twenty strokes: those that end in bumps of the
// outline, or any branches.
enum class On { Bumps, All };
scene::Scene with_strokes(scene::Scene scene, On on, std::uint32_t number)
{
    auto const skeleton = skeleton_of(*outlined_tree(*scene.drawn)).value();
    auto const tree = make_tree(skeleton, tree_options({}, drawn_height(skeleton) / 0.1));
    std::vector<AxisId> choice;
    for (AxisId axis = 1; axis < tree.plant.axes.size(); ++axis) {
        auto const& name = tree.axis_names[axis];
        bool const is_of_bump = name[0] == 'b' && name.find('/') == std::string::npos;
        if (on == On::All || is_of_bump)
            choice.push_back(axis);
    }
    Random random({ 31, 8, number });
    std::vector<scene::Edit> strokes;
    for (int i = 0; i < 20; ++i) {
        auto const& axis = scene.base->axes[choice[random.next_u32() % choice.size()]];
        std::vector<SegmentId> path(axis.segment_count);
        std::iota(path.begin(), path.end(), axis.first_segment);
        strokes.push_back(scene::select_paths(scene, { path }));
        strokes.push_back(scene::Associate { stroke_of({ { 0, 0 }, { 10, 5 }, { 20, 20 } }) });
    }
    return scene::apply_edits(scene, strokes).value();
}

struct Kept {
    int strokes = 0;
    int of = 0;
    // Number of strokes that moved to another branch: the tip is near the old tip of that branch.
    int moved = 0;
};

// Compares only heights and distances from the trunk, since all branches are rearranged around it.
bool is_nearer_to_another(Vec3 const& now_mm, Vec3 const& own_mm,
                          std::map<scene::ItemId, Vec3> const& before)
{
    auto const far_mm = [&](Vec3 const& tip_mm) {
        return (Vec2(now_mm.head<2>().norm(), now_mm.z())
                - Vec2(tip_mm.head<2>().norm(), tip_mm.z()))
            .norm();
    };
    return std::any_of(before.begin(), before.end(), [&](auto const& other) {
        return other.second != own_mm && far_mm(other.second) < 0.5 * far_mm(own_mm);
    });
}

// Counts the strokes that stay on their branches when the outline of a tree is redrawn ten times.
// Each time, the first outline is redrawn.
Kept kept_on(On on, std::uint32_t number)
{
    auto const drawing = lobed_crown(3 + static_cast<int>(number));
    auto edit = outline();
    edit.stroke = stroke_of(drawing.outline[0]);
    auto const scene = with_strokes(drawn(edit), on, number);
    auto const before = shaped_tips_mm(scene);
    Kept kept;
    for (std::uint32_t change = 0; change < 10; ++change) {
        edit.plant = scene.state.active;
        edit.stroke = stroke_of(wavered(drawing.outline[0], 100 * number + change));
        auto const after = shaped_tips_mm(drawn(edit, scene));
        kept.of += static_cast<int>(before.size());
        for (auto const& [id, tip_mm] : before) {
            auto const found = after.find(id);
            if (found == after.end())
                continue;
            ++kept.strokes;
            kept.moved += is_nearer_to_another(found->second, tip_mm, before);
        }
    }
    return kept;
}

Kept kept_on_ten_trees(On on)
{
    Kept all;
    for (std::uint32_t number = 0; number < 10; ++number) {
        auto const kept = kept_on(on, number);
        all.strokes += kept.strokes;
        all.of += kept.of;
        all.moved += kept.moved;
    }
    return all;
}

// A hundred redrawn outlines: ten for each of ten trees, with twenty strokes on each tree.
TEST(DrawTree, KeepsStrokesOnBranchesOfBumps)
{
    auto const kept = kept_on_ten_trees(On::Bumps);
    EXPECT_GE(kept.strokes, 0.95 * kept.of) << "of " << kept.of;
    EXPECT_LE(kept.moved, 0.04 * kept.of) << "of " << kept.of;
}

// Most branches are not drawn, and are rearranged. Strokes on branches that no longer exist must
// wait, and at most 4 % of the strokes may move to another branch.
TEST(DrawTree, LetsStrokesOnAddedBranchesWait)
{
    auto const kept = kept_on_ten_trees(On::All);
    EXPECT_GE(kept.strokes, 0.15 * kept.of) << "of " << kept.of;
    EXPECT_LE(kept.moved, 0.04 * kept.of) << "of " << kept.of;
}

TEST(FormTree, ArrangesTheTreeAnew)
{
    auto const before = drawn_tree();
    TreeForm form;
    form.patterns[0] = Pattern::Whorls;
    form.leaves = 5;
    auto const after = drawn(FormTree { before.state.active, form }, before);
    EXPECT_NE(after.base->node_position_mm, before.base->node_position_mm);
    EXPECT_EQ(after.state.plants[0]->paper_mm, before.state.plants[0]->paper_mm);
    EXPECT_EQ(drawn(FormTree { before.state.active, {} }, after).base->node_position_mm,
              before.base->node_position_mm);
}

TEST(FormTree, SaysHowManyBranchesAWhorlHas)
{
    auto const before = drawn_tree();
    TreeForm form;
    form.patterns[0] = Pattern::Whorls;
    auto const threes = drawn(FormTree { before.state.active, form }, before);
    form.patterns[0] = Pattern::whorls_of(6);
    auto const sixes = drawn(FormTree { before.state.active, form }, before);
    EXPECT_NE(sixes.base->node_position_mm, threes.base->node_position_mm);
    EXPECT_NE(scene::Edit(FormTree { 1, form }).describe().find("whorls of 6 around the trunk"),
              std::string::npos);
    form.patterns[2].whorl = 13;
    auto const refused = scene::apply_edit(before, FormTree { before.state.active, form });
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().message, "the branches of a whorl cannot be 13: give 2 to 12");
}

TEST(DrawTree, SaysWhatIsWrong)
{
    auto const tree = drawn_tree();
    auto const plant = tree.state.active;
    EXPECT_NE(refusal(branch(0)).find("draw a trunk or a crown first"), std::string::npos);
    EXPECT_NE(refusal(outline(77), tree).find("there is no plant"), std::string::npos);
    auto dot = trunk();
    dot.stroke = stroke_of({ { 0, 0 }, { 1, 0 } });
    EXPECT_NE(refusal(dot).find("shorter than 5 mm"), std::string::npos);
    auto open = outline(plant);
    open.stroke = stroke_of({ { -50, 0 },
                              { -40, 30 },
                              { -20, 40 },
                              { 0, 45 },
                              { 20, 40 },
                              { 40, 30 },
                              { 45, 10 },
                              { 50, 0 } });
    EXPECT_NE(refusal(open, tree).find("open"), std::string::npos);
    auto far = trunk();
    far.plant = plant;
    far.stroke = stroke_of({ { 300, 0 }, { 300, 100 } });
    EXPECT_NE(refusal(far, tree).find("outside of the outline"), std::string::npos);
    auto unscaled = trunk();
    unscaled.scale = 0;
    EXPECT_FALSE(refusal(unscaled).empty());
    TreeForm form;
    form.density = std::nan("");
    EXPECT_NE(refusal(FormTree { plant, form }, tree).find("density"), std::string::npos);
    form = {};
    form.levels = 4;
    EXPECT_NE(refusal(FormTree { plant, form }, tree).find("levels"), std::string::npos);
}

// With another seed, everything that was drawn must stay: the trunk, and the extent of the crown.
TEST(DrawTree, LeavesToChanceWhatWasNotDrawn)
{
    auto const first = drawn(trunk());
    auto const tree = drawn(outline(first.state.active), first);
    ASSERT_TRUE(scene::has_sources_that_vary(tree));
    auto const one = scene::varied(tree, { .seed = 5, .plant = 1 }).value();
    auto const again = scene::varied(tree, { .seed = 5, .plant = 1 }).value();
    auto const other = scene::varied(tree, { .seed = 5, .plant = 2 }).value();
    EXPECT_EQ(one.base->node_position_mm, again.base->node_position_mm);
    EXPECT_NE(one.base->node_position_mm, other.base->node_position_mm);
    auto const trunk_of = [](scene::Scene const& scene) {
        auto const nodes = scene.base->positions(scene.base->axes[0]);
        return std::vector<Vec3>(nodes.begin(), nodes.end());
    };
    EXPECT_EQ(trunk_of(one).back(), trunk_of(tree).back());
    auto const box_of_plant = [](scene::Scene const& scene) { return bounds(*scene.base); };
    auto const whole = box_of_plant(tree);
    EXPECT_NEAR(box_of_plant(one).max_mm.z(), whole.max_mm.z(), 0.05 * whole.max_mm.z());
}

} // namespace
} // namespace tractus::silhouette
