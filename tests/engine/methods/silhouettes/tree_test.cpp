#include "engine/methods/silhouettes/tree.h"

#include "engine/methods/silhouettes/tree_preset.h"
#include "tests/engine/methods/silhouettes/outlines.h"

#include <fmt/format.h>
#include <map>
#include <set>

namespace tractus::silhouette {
namespace {

Skeleton skeleton_of(Drawing const& drawing, int levels = 2)
{
    auto result = infer_skeleton(drawing, { .levels = levels });
    EXPECT_TRUE(result) << result.error().message;
    return result ? *std::move(result) : Skeleton();
}

TEST(SilhouetteTree, IsAPlantWithANameForEachAxis)
{
    auto const skeleton = skeleton_of(lobed_crown(7));
    auto const tree = make_tree(skeleton);
    check_plant(tree.plant);
    EXPECT_EQ(tree.axis_names.size(), tree.plant.axes.size());
    std::set<std::string> const names(tree.axis_names.begin(), tree.axis_names.end());
    EXPECT_EQ(names.size(), tree.axis_names.size());
    EXPECT_GT(tree.plant.axes.size(), 200U);
    EXPECT_EQ(tree.plant.organs.size(), 2 * tree.sprays);
    EXPECT_EQ(tree.leaves, tree.sprays * 24);
    EXPECT_EQ(tree.element_count(), tree.plant.axes.size() + tree.sprays + tree.leaves);
    ASSERT_EQ(tree.arrangements.size(), 2U);
    for (auto const& placed : tree.arrangements[0])
        EXPECT_TRUE(names.contains(placed.name)) << placed.name;
}

TEST(SilhouetteTree, IsAsTallAsAsked)
{
    auto const tree = make_tree(skeleton_of(ellipse(40, 80)), { .height_mm = 3000 });
    auto const box = bounds(tree.plant);
    EXPECT_NEAR(box.max_mm.z(), 3000, 150);
    EXPECT_NEAR(box.min_mm.z(), 0, 50);
}

// Every axis must begin at a point of its parent.
TEST(SilhouetteTree, BranchesStandOnTheirParents)
{
    auto const tree = make_tree(skeleton_of(star(7, 40, 100)));
    auto const& plant = tree.plant;
    for (auto const& axis : plant.axes) {
        if (axis.parent_segment == kNone)
            continue;
        auto const tip = nodes_of(plant, axis.parent_segment).tip;
        EXPECT_LT((plant.node_position_mm[axis.first_node] - plant.node_position_mm[tip]).norm(),
                  0.02 * 8000);
    }
}

TEST(SilhouetteTree, TheSameSeedGivesTheSameTree)
{
    auto const skeleton = skeleton_of(lobed_crown(8));
    auto const one = make_tree(skeleton);
    auto const again = make_tree(skeleton);
    auto const other = make_tree(skeleton, { .seed = 2 });
    EXPECT_EQ(one.plant.node_position_mm, again.plant.node_position_mm);
    EXPECT_NE(one.plant.node_position_mm, other.plant.node_position_mm);
    ASSERT_EQ(one.plant.organs.size(), again.plant.organs.size());
    for (std::size_t i = 0; i < one.plant.organs.size(); ++i)
        EXPECT_EQ(one.plant.organs[i].position_mm, again.plant.organs[i].position_mm);
}

// How well foliage fills an outline, counted in cells of 3 % of the diagonal and seen from the side
// of the drawing.
struct Fit {
    double filled = 0; // Share of the outline's cells that show foliage.
    // Share of the foliage's cells that are outside by more than 2 % of the diagonal.
    double outside = 0;
};

Fit fit_of(Drawing const& drawing, Pattern pattern = Pattern::Even)
{
    auto const skeleton = skeleton_of(drawing);
    TreeOptions options;
    options.levels[0].pattern = pattern;
    auto const tree = make_tree(skeleton, options);
    auto const& outline = skeleton.systems[0].outline;
    auto const& trunk = skeleton.systems[0].trunk;
    auto const box = box_of(outline);
    double const low = std::min(box.low.y(), trunk.front().y());
    double const unit = (std::max(box.high.y(), trunk.front().y()) - low) / 8000;
    CoverageGrid grid(outline);
    double const reach = 0.015 * box.diagonal();
    double outside = 0;
    double leaves = 0;
    for (auto const& organ : tree.plant.organs) {
        auto const& shape = tree.plant.organ_shapes[organ.shape];
        for (auto const& patch : shape.patches) {
            Vec3 const leaf = organ.position_mm
                + organ.orientation * (double { organ.scale.x() } * patch.at(0.5, 0.5));
            Vec2 const seen = trunk.front() + unit * Vec2(leaf.x(), leaf.z());
            std::vector<Vec2> const blur { seen + Vec2(-reach, -reach), seen + Vec2(reach, -reach),
                                           seen + Vec2(reach, reach), seen + Vec2(-reach, reach) };
            grid.cover(grid.cells_of(blur));
            leaves += 1;
            outside += !is_inside(outline, seen)
                && distance_to_outline(outline, seen) > 0.02 * box.diagonal();
        }
    }
    return { grid.coverage(), outside / leaves };
}

TEST(SilhouetteTree, FillsItsOutline)
{
    for (auto const& [name, drawing] :
         { std::pair("crown", lobed_crown(7)), std::pair("ellipse", ellipse(40, 80)),
           std::pair("column", ellipse(14, 90)) }) {
        auto const fit = fit_of(drawing);
        EXPECT_GE(fit.filled, 0.9) << name;
        EXPECT_LE(fit.outside, 0.02) << name;
    }
}

// Branches of the drawing snap to nodes. The tree must still fill its outline, and the branches
// must still end inside.
TEST(SilhouetteTree, FillsItsOutlineWithWholeNodes)
{
    for (Pattern const pattern : { Pattern::Spiral, Pattern::TwoRows, Pattern::Decussate,
                                   Pattern::Whorls, Pattern::Horizontal })
        for (auto const& [name, drawing] :
             { std::pair("crown", lobed_crown(7)), std::pair("eleven", lobed_crown(11)),
               std::pair("ellipse", ellipse(40, 80)) }) {
            SCOPED_TRACE(fmt::format("{}, {}", name, describe(pattern)));
            auto const fit = fit_of(drawing, pattern);
            EXPECT_GE(fit.filled, 0.9);
            EXPECT_LE(fit.outside, 0.02);
        }
}

// Each node of the trunk except the last must have a complete whorl. The end of the trunk itself
// does not count as a branch.
TEST(SilhouetteTree, ItsWhorlsAreWhole)
{
    auto const skeleton = skeleton_of(lobed_crown(9));
    for (Pattern const pattern : { Pattern::Decussate, Pattern::Whorls, Pattern::Horizontal })
        for (std::uint64_t seed = 1; seed <= 12; ++seed) {
            TreeOptions options { .seed = seed };
            options.levels[0].pattern = pattern;
            std::map<double, std::size_t> at;
            auto const tree = make_tree(skeleton, options);
            for (auto const& branch : tree.arrangements.front())
                if (branch.name != "apex")
                    ++at[branch.place.u];
            ASSERT_GT(at.size(), 4u);
            for (auto const& [u, size] : at)
                if (u < at.rbegin()->first) {
                    EXPECT_EQ(size, node_size(pattern)) << describe(pattern) << " at " << u;
                }
        }
}

TEST(SilhouetteTreeCorpus, FillsThePublishedOutlines)
{
    REQUIRE_CORPUS();
    for (auto const& [name, drawing, expected] : published_outlines()) {
        auto const fit = fit_of(drawing);
        EXPECT_GE(fit.filled, name == "figure-of-eight" ? 0.86 : 0.9) << name;
        EXPECT_LE(fit.outside, name == "star-5" ? 0.03 : 0.02) << name;
    }
}

// A branch at the very end of its parent must be attached to the parent's last segment, not to
// another axis.
TEST(SilhouetteTreeCorpus, IsAPlantInEveryReadyForm)
{
    REQUIRE_CORPUS();
    for (auto const& [name, drawing, expected] : published_outlines())
        for (auto const& ready : tree_presets()) {
            SCOPED_TRACE(fmt::format("{}, {}", name, ready.name));
            auto const skeleton = skeleton_of(drawing, ready.form.levels);
            auto form = ready.form;
            for (bool const whole : { true, false }) {
                form.has_whole_nodes = whole;
                check_plant(make_tree(skeleton, tree_options(form, 8000)).plant);
            }
        }
}

} // namespace
} // namespace tractus::silhouette
