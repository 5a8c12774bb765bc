#include "engine/methods/silhouettes/own_branch.h"
#include "engine/methods/silhouettes/tree_edits.h"
#include "engine/scene/scene.h"
#include "tests/engine/methods/silhouettes/outlines.h"

#include <cmath>

namespace tractus::silhouette {
namespace {

class OwnBranchEdits : public ::testing::Test {
protected:
    using Part = DrawTree::Part;

    static scene::Scene draw(scene::Scene const& before, Part part, std::vector<Vec2> const& points,
                             StyleScope style_to = StyleScope::None)
    {
        return draw_on(before, { .part = part, .stroke = stroke_of(points), .style_to = style_to });
    }

    static scene::Scene tree(Drawing const& lines)
    {
        return draw(draw({}, Part::Trunk, lines.trunk), Part::Outline, lines.outline[0]);
    }

    static OutlinedTree const& drawing(scene::Scene const& scene)
    {
        return *outlined_tree(*scene.drawn);
    }

    static BranchingSystem on_trunk(scene::Scene const& scene)
    {
        return skeleton_of(drawing(scene)).value().systems[0];
    }

    static std::vector<Vec2> twig_on(Branch const& branch)
    {
        auto const& curve = branch.path.curve;
        Vec2 const from = curve.at(0.6);
        Vec2 const way = 0.3 * branch.path.length * direction_of(curve.at(0.65) - from);
        return { from, from + 0.5 * turned(way, 0.6), from + turned(way, 0.9) };
    }

    // Returns the index of the bump branch whose end is nearest to `end`.
    static std::size_t nearest_bump(BranchingSystem const& system, Vec2 const& end)
    {
        std::size_t nearest = 0;
        double least = 1e300;
        for (std::size_t i = 0; i < system.branches.size(); ++i) {
            auto const& branch = system.branches[i];
            double const far = (branch.path.curve.end - end).norm();
            if (branch.origin != Branch::Origin::Bump || far >= least)
                continue;
            least = far;
            nearest = i;
        }
        return nearest;
    }

    // Returns the scene after a line is drawn on each bump branch.
    static scene::Scene twigs_on(scene::Scene scene)
    {
        auto const system = on_trunk(scene);
        for (auto const& branch : system.branches)
            if (branch.origin == Branch::Origin::Bump)
                scene = draw(scene, Part::OwnBranch, twig_on(branch));
        return scene;
    }
};

TEST_F(OwnBranchEdits, MakeTheTreeOfTheirLines)
{
    auto const before = tree(lobed_crown(5));
    auto const line = twig_on(on_trunk(before).branches[1]);
    auto const scene = draw(before, Part::OwnBranch, line, StyleScope::Siblings);
    auto lines = lobed_crown(5);
    ASSERT_TRUE(add_own_branch(lines, line, StyleScope::Siblings));
    auto const skeleton = infer_skeleton(lines).value();
    auto const made = make_tree(skeleton, tree_options({}, drawn_height(skeleton) / 0.1));
    EXPECT_EQ(scene.base->node_position_mm, made.plant.node_position_mm);
    EXPECT_NE(scene.base->node_position_mm, before.base->node_position_mm);
    ASSERT_EQ(drawing(scene).own_branches.size(), 1U);
    EraseTreePart const erase { scene.state.active, Part::OwnBranch,
                                drawing(scene).own_branches[0].id };
    EXPECT_EQ(scene::apply_edit(scene, erase)->base->node_position_mm,
              before.base->node_position_mm);
    EXPECT_FALSE(scene::apply_edit(before, erase)) << "there is none";
}

// If the crown is redrawn slightly differently, the parent branch of a line must be found again by
// the place where it ends.
TEST_F(OwnBranchEdits, StayWithTheirParents)
{
    std::size_t drawn = 0;
    std::size_t kept = 0;
    for (int const lobes : { 4, 5, 6, 7, 9 }) {
        auto const lines = lobed_crown(lobes);
        auto const before = twigs_on(tree(lines));
        auto const had = on_trunk(before);
        for (double const size : { 0.97, 0.985, 1.015, 1.03 }) {
            Similarity const way { .turn = size * Vec2(std::cos(0.01), std::sin(0.01)) };
            auto const after = draw(before, Part::Outline, way.points(lines.outline[0]));
            auto const has = on_trunk(after);
            for (std::size_t i = 0; i < drawing(before).own_branches.size(); ++i) {
                ++drawn;
                auto const& own = drawing(after).own_branches[i];
                auto const parent = number_of(has, own.branch);
                if (!parent)
                    continue;
                ++kept;
                auto const was = number_of(had, drawing(before).own_branches[i].branch).value();
                Vec2 const end = way.point(had.branches[was].path.curve.end);
                EXPECT_EQ(name_of(has.branches[nearest_bump(has, end)]), own.branch)
                    << "it has moved to another one";
            }
        }
    }
    EXPECT_GE(drawn, 100U);
    EXPECT_GE(static_cast<double>(kept), 0.95 * static_cast<double>(drawn));
}

// A branch whose parent is missing must wait. A crown that has the parent again must restore it.
TEST_F(OwnBranchEdits, WaitForTheirParents)
{
    auto const before = twigs_on(tree(lobed_crown(5)));
    EXPECT_EQ(count_without_effect(drawing(before)).value(), 0U);
    auto const count = drawing(before).own_branches.size();
    auto const narrow = draw(before, Part::Outline, ellipse(16, 60).outline[0]);
    EXPECT_EQ(drawing(narrow).own_branches.size(), count);
    EXPECT_GE(count_without_effect(drawing(narrow)).value(), count / 2);
    auto const again = draw(narrow, Part::Outline, lobed_crown(5).outline[0]);
    EXPECT_EQ(count_without_effect(drawing(again)).value(), 0U);
    auto form = drawing(before).form;
    form.patterns[0] = Pattern::Spiral;
    auto const formed = scene::apply_edit(before, FormTree { before.state.active, form }).value();
    for (std::size_t i = 0; i < count; ++i)
        EXPECT_EQ(drawing(formed).own_branches[i].branch, drawing(before).own_branches[i].branch);
}

} // namespace
} // namespace tractus::silhouette
