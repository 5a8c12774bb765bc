#include "app/methods/all_methods.h"
#include "app/view/drawn_curves.h"
#include "engine/methods/self_organising/grown_tree.h"
#include "tests/app/methods/pairs/plant_of_each_method.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace tractus::methods {
namespace {

std::vector<view::DrawnCurveView> curves_of(scene::Scene const& scene)
{
    return view::drawn_curves(scene, {}, all_methods().curves);
}

std::string names_of(scene::Scene const& scene)
{
    std::string names;
    for (auto const& curve : curves_of(scene))
        names += curve.name + "; ";
    return names;
}

scene::Scene scene_of(void (*make)(Steps& steps, double x_mm))
{
    Steps steps(scene::Scene {});
    make(steps, 0);
    return steps.scene();
}

Bounds box_of(scene::Scene const& scene)
{
    Bounds box;
    for (auto const& curve : curves_of(scene))
        for (auto const& point : curve.line.points)
            box.add(point.position_mm.cast<double>());
    return box;
}

void brush_tree(Steps& steps, double x_mm)
{
    self_organising::LifePeriod first { .years = 3 };
    first.stroke = stroke_through({ { x_mm, 0, 0 }, { x_mm, 0, 60 } });
    steps.add(self_organising::PlantTree { .scale = 0.05, .first = first });
    self_organising::LifePeriod next { .years = 1 };
    next.stroke = stroke_through({ { x_mm, 0, 60 }, { x_mm + 30, 0, 90 } });
    steps.add(self_organising::GrowOn { steps.active(), next });
}

} // namespace

TEST(MethodsCurves, AreNamedByWhatTheyDid)
{
    EXPECT_EQ(names_of(scene_of(load_model)), "");
    EXPECT_EQ(names_of(scene_of(grow_along_stroke)), "Along a stroke: the stem; ");
    EXPECT_EQ(names_of(scene_of(draw_tree)), "Outline: trunk; Outline: crown; ");
    EXPECT_EQ(names_of(scene_of(draw_lines)),
              "Line: stem; Line: left boundary; Line: right boundary; Line: inclination line; "
              "Line: inclination line; ");
    EXPECT_EQ(names_of(scene_of(draw_leaf)), "Leaf: margin; Leaf: midrib; ");
    EXPECT_EQ(names_of(scene_of(brush_tree)), "Growth brush: 3 years; Growth brush: 1 year; ");
}

// The curves from which a plant was drawn stand upright where the plant does, and move with it.
TEST(MethodsCurves, GoWithThePlant)
{
    for (auto* const make : { grow_along_stroke, draw_tree, draw_lines, draw_leaf, brush_tree }) {
        auto scene = scene_of(make);
        SCOPED_TRACE(names_of(scene));
        auto const before = box_of(scene);
        ASSERT_FALSE(before.empty());
        EXPECT_GT((before.max_mm - before.min_mm).z(), 50) << "they stand upright";
        Vec3 const by_mm(40, 25, 0);
        scene::MovePlant const move { scene.state.active, scene.drawn->stands_at_mm + by_mm };
        scene = scene::apply_edit(std::move(scene), move).value();
        auto const moved = box_of(scene);
        EXPECT_LT((moved.min_mm - before.min_mm - by_mm).norm(), 1e-3);
        EXPECT_LT((moved.max_mm - before.max_mm - by_mm).norm(), 1e-3);
    }
}

// Only the curves of the active plant are shown, as on the drawing pad.
TEST(MethodsCurves, AreThoseOfTheActivePlant)
{
    Steps steps(scene::Scene {});
    draw_tree(steps, -60);
    auto const tree = steps.active();
    draw_lines(steps, 40);
    EXPECT_EQ(curves_of(steps.scene()).size(), 5u);
    steps.add(scene::ActivatePlant { tree });
    EXPECT_EQ(curves_of(steps.scene()).size(), 2u);
    EXPECT_LT(box_of(steps.scene()).max_mm.x(), 0);
}

// Strokes drawn in space keep their depth: the curves in the view are where the hand drew them.
TEST(MethodsCurves, AreWhereTheHandDrewThem)
{
    auto const scene = scene_of(grow_along_stroke);
    auto const curves = curves_of(scene);
    ASSERT_EQ(curves.size(), 1u);
    auto const& points = curves[0].line.points;
    EXPECT_LT((points.front().position_mm - Vec3f(0, 0, 0)).norm(), 1e-3f);
    EXPECT_LT((points.back().position_mm - Vec3f(0, 20, 150)).norm(), 1e-3f);
    EXPECT_TRUE(std::ranges::any_of(points, [](auto const& point) {
        return (point.position_mm - Vec3f(20, 10, 70)).norm() < 0.1f;
    }));
}

} // namespace tractus::methods
