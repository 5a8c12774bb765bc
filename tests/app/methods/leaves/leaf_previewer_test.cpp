#include "app/methods/leaves/leaf_previewer.h"

#include "app/methods/leaves/leaf_line_tool.h"
#include "engine/scene/paper.h"
#include "tests/app/small_model.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <memory>
#include <vector>

namespace tractus::leaf {
namespace {

// Returns the first `places` points of a spindle-shaped outline, 80 mm long.
Stroke spindle(std::size_t places)
{
    std::vector<Vec3> line;
    for (int i = 0; i <= 80; ++i) {
        double const t = i <= 40 ? i / 40.0 : (80 - i) / 40.0;
        double const side = i <= 40 ? 1 : -1;
        line.emplace_back(side * 20 * std::sin(t * kPi), -40 + 80 * t, 120);
    }
    line.resize(std::min(places, line.size()));
    return stroke_through(line);
}

scene::Scene scene_with(scene::Scene const& scene, Stroke const& stroke)
{
    tools::Tool const tool = LeafLineTool {};
    return scene::apply_edits(scene, tool.edits_for(stroke, scene).value()).value();
}

std::vector<tools::SkeletonLine> preview_of(scene::Scene const& scene, Stroke const& stroke)
{
    tools::Tool const tool = LeafLineTool {};
    auto const ink = stroke.tips.in_memory().value();
    auto const shared = std::make_shared<scene::Scene const>(scene);
    return leaf_previewer()->show({ shared, tool, ink, 9 });
}

// Converts a position in the plant's frame to the sheet. The result changes when the plant's base
// moves on the sheet.
Vec2 on_paper_mm(Vec3 const& plant_mm, scene::Scene const& scene)
{
    return scene::paper_of(scene.state).sheet_of_world(scene.placement.world_of_plant(plant_mm));
}

// Returns the distance of a point on the sheet from the nearest vertex of the plant's polygons.
double from_corners_mm(Vec2 const& sheet_mm, scene::Scene const& scene)
{
    double least = std::numeric_limits<double>::infinity();
    for (auto const& corner : scene.base->polygon_vertices_mm)
        least = std::min(least, (on_paper_mm(corner, scene) - sheet_mm).norm());
    return least;
}

// Expects the preview shown before the pen is lifted to be equal to the resulting plant.
void expect_as_drawn(scene::Scene const& before, Stroke const& stroke)
{
    auto const lines = preview_of(before, stroke);
    auto const after = scene_with(before, stroke);
    ASSERT_GT(lines.size(), 2u);
    ASSERT_GT(lines[0].points_mm.size(), 10u);
    for (auto const& point : lines[0].points_mm)
        EXPECT_LT(from_corners_mm(on_paper_mm(point.cast<double>(), before), after), 0.05);
}

TEST(LeafPreviewer, ShowsTheLeafBeforeThePenIsLifted)
{
    auto const outlined = scene_with({}, spindle(81));
    expect_as_drawn(outlined, stroke_through({ { 0, -60, 120 }, { 0, 0, 120 }, { 0, 39, 120 } }));
    expect_as_drawn(outlined, stroke_through({ { 0, -10, 120 }, { 12, 3, 120 } }));
}

TEST(LeafPreviewer, ClosesAnOutlineThatComesBack)
{
    auto const almost = preview_of({}, spindle(74));
    ASSERT_FALSE(almost.empty());
    auto const whole = preview_of({}, spindle(81));
    ASSERT_FALSE(whole.empty());
    auto const highest = [](tools::SkeletonLine const& line) {
        float most = -1e9f;
        for (auto const& point : line.points_mm)
            most = std::max(most, point.z());
        return most;
    };
    EXPECT_NEAR(highest(almost[0]), highest(whole[0]), 0.1f * std::fabs(highest(whole[0])));
}

} // namespace
} // namespace tractus::leaf
