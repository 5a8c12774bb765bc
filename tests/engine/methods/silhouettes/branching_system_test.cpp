#include "tests/engine/methods/silhouettes/outlines.h"

#include "engine/methods/silhouettes/coverage_grid.h"
#include "engine/methods/silhouettes/skeleton.h"

#include <limits>
#include <set>

namespace tractus::silhouette {
namespace {

BranchingSystem inferred(Drawing const& drawing)
{
    auto result = infer_system(drawing);
    EXPECT_TRUE(result) << result.error().message;
    return result ? *std::move(result) : BranchingSystem();
}

TEST(SilhouetteCoverage, CountsCellsOfAPolygon)
{
    std::vector<Vec2> const square { Vec2(0, 0), Vec2(10, 0), Vec2(10, 10), Vec2(0, 10) };
    CoverageGrid grid(square);
    std::vector<Vec2> const half { Vec2(0, 0), Vec2(10, 0), Vec2(10, 5), Vec2(0, 5) };
    auto const cells = grid.cells_of(half);
    EXPECT_EQ(cells.count, 256U * 128);
    EXPECT_EQ(grid.count_covered(cells), 0U);
    grid.cover(cells);
    EXPECT_EQ(grid.count_covered(cells), cells.count);
    EXPECT_DOUBLE_EQ(grid.coverage(), 0.5);
    EXPECT_TRUE(grid.is_free(Vec2(5, 7)));
    EXPECT_FALSE(grid.is_free(Vec2(5, 3)));
    EXPECT_FALSE(grid.is_inside(Vec2(5, 11)));
    auto const gap = grid.widest_gap(2);
    EXPECT_NEAR(gap.center.y(), 7.5, 0.2);
    EXPECT_NEAR(gap.radius, 2.5, 0.3);
}

// Expects that the crown of each new branch covers at most as much of the existing crowns as the
// filling law allows.
void expect_filled_lawfully(BranchingSystem const& system, std::string const& name)
{
    double const diagonal = box_of(system.outline).diagonal();
    CoverageGrid grid(system.outline);
    // The limit is 60 branches, in addition to the trunk's apex.
    EXPECT_LE(system.branches.size(), 61U) << name;
    std::set<std::string> names;
    for (auto const& branch : system.branches) {
        EXPECT_TRUE(is_inside(system.outline, branch.path.curve.base)) << name;
        EXPECT_LE(excursion(system.outline, branch.path.curve.points(17)), 0.01 * diagonal)
            << name << " " << name_of(branch);
        EXPECT_TRUE(names.insert(name_of(branch)).second) << name << " " << name_of(branch);
        auto const cells = grid.cells_of(branch.crown);
        if (branch.origin == Branch::Origin::Copy || branch.origin == Branch::Origin::Gap) {
            EXPECT_LE(static_cast<double>(grid.count_covered(cells)),
                      0.25 * static_cast<double>(cells.count))
                << name << " " << name_of(branch);
        }
        grid.cover(cells);
    }
    EXPECT_GE(system.coverage_after, system.coverage_before) << name;
}

TEST(SilhouetteSystem, FillsCrownsOfAllKinds)
{
    Drawing column = ellipse(12, 90);
    Drawing steps { { { Vec2(-5, -60), Vec2(5, -60), Vec2(5, -50), Vec2(60, -50), Vec2(35, -20),
                        Vec2(45, -20), Vec2(22, 15), Vec2(30, 15), Vec2(0, 75), Vec2(-30, 15),
                        Vec2(-22, 15), Vec2(-45, -20), Vec2(-35, -20), Vec2(-60, -50),
                        Vec2(-5, -50) } },
                    upright(-75, 60) };
    for (auto const& [name, drawing, least] :
         { std::tuple("column", column, 0.85), std::tuple("steps", steps, 0.85),
           std::tuple("crown", lobed_crown(7), 0.85),
           std::tuple("star", star(5, 40, 100), 0.75) }) {
        auto const system = inferred(drawing);
        EXPECT_GE(system.coverage_after, least) << name;
        expect_filled_lawfully(system, name);
    }
}

TEST(SilhouetteSystem, ATrunkThatForksNowhereGoesOnToItsApex)
{
    auto const system = inferred(star(5, 40, 100));
    ASSERT_TRUE(system.trunk_goes_on_to);
    EXPECT_LT((*system.trunk_goes_on_to - Vec2(0, 97)).norm(), 2);
    ASSERT_TRUE(system.has_apex_branch());
    EXPECT_EQ(name_of(system.branches.back()), "apex");
}

TEST(SilhouetteSystem, RefusesATrunkOutside)
{
    auto drawing = ellipse(40, 60);
    drawing.trunk = { Vec2(100, 0), Vec2(100, 60) };
    auto const result = infer_system(drawing);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().message,
              "the trunk is wholly outside of the outline: draw it into the crown");
    EXPECT_EQ(result.error().fault, Fault::User);
}

TEST(SilhouetteSystem, AMovedAndTurnedDrawingHasTheMovedBranches)
{
    for (auto const& drawing : { lobed_crown(9), ellipse(40, 80) }) {
        Similarity const way { .to = Vec2(12, -345), .turn = Vec2(0.3, -1.7) };
        auto const system = inferred(drawing);
        auto const other = inferred(moved(drawing, way));
        ASSERT_EQ(system.branches.size(), other.branches.size());
        double const close = 1e-6 * box_of(other.outline).diagonal();
        for (std::size_t i = 0; i < system.branches.size(); ++i) {
            auto const& a = system.branches[i].path.curve;
            auto const& b = other.branches[i].path.curve;
            EXPECT_EQ(name_of(system.branches[i]), name_of(other.branches[i]));
            for (double const x : { 0.0, 0.3, 1.0 })
                EXPECT_LT((way.point(a.at(x)) - b.at(x)).norm(), close);
        }
    }
}

TEST(SilhouetteSystem, ACopyIsItsModelSeenFromAnotherPlace)
{
    for (auto const& drawing : { lobed_crown(9), ellipse(40, 80) }) {
        auto const system = inferred(moved(drawing, { .turn = Vec2(0.6, 0.8) }));
        int copies = 0;
        for (auto const& branch : system.branches) {
            if (!branch.model)
                continue;
            ++copies;
            auto const& model = system.branches[*branch.model].path.curve;
            for (double const x : { 0.0, 0.4, 1.0 })
                EXPECT_LT((branch.from_model.point(model.at(x)) - branch.path.curve.at(x)).norm(),
                          1e-6);
        }
        EXPECT_GT(copies, 2);
    }
}

TEST(SilhouetteSkeleton, HasAThousandBranchesOnTwoLevels)
{
    auto const skeleton = infer_skeleton(lobed_crown(11));
    ASSERT_TRUE(skeleton);
    EXPECT_GT(skeleton->branch_count(), 300U);
    for (std::size_t s = 0; s < skeleton->systems.size(); ++s)
        for (std::size_t b = 0; b < skeleton->systems[s].branches.size(); ++b) {
            auto const& model = skeleton->systems[s].branches[b].model;
            EXPECT_EQ(skeleton->system_of[s][b], skeleton->system_of[s][model.value_or(b)]);
        }
}

TEST(SilhouetteSystem, ScribblesDoNotStopIt)
{
    int made = 0;
    for (std::uint32_t i = 0; i < 500; ++i)
        made += infer_system(scribble(i), { .outline = { .samples = 64 } }).has_value();
    EXPECT_GT(made, 300);
}

// Returns the branch with the same origin whose end is nearest to `end`.
Branch const* nearest_to(BranchingSystem const& system, Vec2 const& end)
{
    Branch const* nearest = nullptr;
    for (auto const& branch : system.branches)
        if (branch.origin == Branch::Origin::Bump
            && (!nearest
                || (branch.path.curve.end - end).norm() < (nearest->path.curve.end - end).norm()))
            nearest = &branch;
    return nearest;
}

TEST(SilhouetteSystemCorpus, BranchesAreThoseOfThePublishedOutlines)
{
    REQUIRE_CORPUS();
    for (auto const& [name, drawing, expected] : published_outlines()) {
        auto const system = inferred(drawing);
        double const close = 0.02 * box_of(system.outline).diagonal();
        EXPECT_EQ(system.inside.first, expected["trunk_samples_inside"][0]) << name;
        EXPECT_EQ(system.inside.last, expected["trunk_samples_inside"][1]) << name;
        for (auto const& wanted : expected["branch"]) {
            if (name == "circle")
                // On a circle, the farthest point depends on the positions of the samples.
                continue;
            auto const* const branch = nearest_to(system, point_in(wanted["end"]));
            ASSERT_TRUE(branch) << name;
            EXPECT_LT((branch->path.curve.end - point_in(wanted["end"])).norm(), close) << name;
            EXPECT_LT((branch->path.curve.base - point_in(wanted["base"])).norm(), close) << name;
            EXPECT_LT((branch->path.curve.at(0.5) - point_in(wanted["middle"])).norm(), close)
                << name;
            EXPECT_NEAR(branch->path.length, wanted["length"].get<double>(), close) << name;
            EXPECT_NEAR(branch->cone_deg, wanted["cone_deg"].get<double>(), 4) << name;
            EXPECT_NEAR(signed_area(branch->crown), wanted["crown_area"].get<double>(),
                        0.02 * signed_area(system.outline))
                << name;
            EXPECT_EQ(branch->path.side == Side::Left ? "left" : "right", wanted["side"]) << name;
        }
        bool const is_round = name == "circle" || name == "pear";
        EXPECT_NEAR(system.coverage_before, expected["coverage_before"].get<double>(),
                    is_round ? 1 : 0.02)
            << name;
        EXPECT_GE(system.coverage_after, expected["coverage_after"].get<double>() - 0.02) << name;
        EXPECT_GE(system.coverage_after, name.starts_with("star") ? 0.75 : 0.85) << name;
        expect_filled_lawfully(system, name);
    }
}

} // namespace
} // namespace tractus::silhouette
