#include "app/methods/construction_lines/line_curves.h"

#include "app/document/document.h"
#include "app/methods/all_methods.h"
#include "app/methods/construction_lines/line_tool.h"
#include "app/methods/construction_lines/touched_sketch.h"
#include "app/session/edit_record.h"
#include "app/tools/tool.h"
#include "engine/methods/construction_lines/bend_lines.h"
#include "tests/app/small_model.h"

#include <algorithm>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <set>

namespace tractus::lines {
namespace {

// Returns a scene with a frond: a stem of 120 mm, both boundaries, and two inclination lines.
scene::Scene frond_scene()
{
    document::Document document(scene::Scene {}, document::Document::Working::AtOnce);
    for (auto const& stroke :
         { stroke_through({ { 0, -60, 50 }, { 0, 60, 50 } }),
           stroke_through({ { -30, -62, 50 }, { -35, 0, 50 }, { -15, 68, 50 } }),
           stroke_through({ { 25, -58, 50 }, { 30, 10, 50 }, { 22, 70, 50 } }),
           stroke_through({ { -50, -30, 50 }, { 0, -45, 50 }, { 40, -20, 50 } }),
           stroke_through({ { -40, 70, 50 }, { 0, 35, 50 }, { 45, 72, 50 } }) })
        document.draw({ stroke, LineTool { .nodes = 6 } });
    EXPECT_EQ(document.take_finished_strokes().size(), 5u);
    return document.newest()->scene;
}

lines::Construction measured(scene::Scene const& scene)
{
    return lines::construction_of(active_sketch(scene).value().sketch).value();
}

tools::Gizmo::Handle const& handle_that_says(tools::Gizmo const& gizmo, std::string_view beginning)
{
    return *std::find_if(
        gizmo.handles.begin(), gizmo.handles.end(),
        [&](tools::Gizmo::Handle const& handle) { return handle.says.starts_with(beginning); });
}

scene::Scene dragged(scene::Scene const& scene, std::size_t handle, Vec2 const& to)
{
    auto const edits = kLineCurves.drag(scene, handle, to);
    EXPECT_TRUE(edits) << edits.error().message;
    return edits ? scene::apply_edits(scene, *edits).value() : scene;
}

TEST(LineCurves, HaveHandlesOnTheCurves)
{
    auto const scene = frond_scene();
    auto const gizmo = kLineCurves.show(scene);
    ASSERT_TRUE(gizmo);
    EXPECT_EQ(gizmo->handles.size(), 2u * 2 + 2 * 3 + 2 + 1 + 4)
        << "two lines, three places, one layer and its internode, four places of the stem";
    std::set<std::size_t> ids;
    for (auto const& handle : gizmo->handles) {
        EXPECT_TRUE(ids.insert(handle.id).second);
        EXPECT_LE(handle.place.cwiseAbs().maxCoeff(), 1);
        EXPECT_FALSE(handle.says.empty());
    }
    auto const angles = measured(scene).inclinations;
    EXPECT_EQ(handle_that_says(*gizmo, "Line 1, left").says,
              fmt::format("Line 1, left: {:.0f}\u00b0", angles[0].left_deg));
    EXPECT_FALSE(kLineCurves.show(small_scene())) << "of a plant that is drawn otherwise";
}

TEST(LineCurves, SetAnAngleToAWholeDegree)
{
    auto const scene = frond_scene();
    auto const gizmo = kLineCurves.show(scene).value();
    auto const handle = handle_that_says(gizmo, "Line 2, right");
    auto const before = measured(scene).inclinations[1].right_deg;
    auto const after
        = measured(dragged(scene, handle.id, handle.place + Vec2(0.1, 0.3))).inclinations[1];
    EXPECT_GT(after.right_deg, before + 20);
    EXPECT_NEAR(after.right_deg, std::round(after.right_deg), 0.05);
}

TEST(LineCurves, SetASizeToAWholeHundredth)
{
    auto const scene = frond_scene();
    auto const gizmo = kLineCurves.show(scene).value();
    auto const handle = handle_that_says(gizmo, "Size left");
    auto const changed = dragged(scene, handle.id, handle.place + Vec2(-0.05, 0));
    auto const x = lines::size_places(measured(scene))[0];
    double const before = lines::values_at(measured(scene), x).left_size;
    double const after = lines::values_at(measured(changed), x).left_size;
    EXPECT_GT(after, before + 0.05) << "outwards";
    EXPECT_NEAR(100 * after, std::round(100 * after), 0.1);
}

TEST(LineCurves, HaveButtonsForALayersNodes)
{
    auto scene = frond_scene();
    auto const press = [&](char const* sign) {
        auto const gizmo = kLineCurves.show(scene).value();
        auto const handle = std::find_if(
            gizmo.handles.begin(), gizmo.handles.end(),
            [&](tools::Gizmo::Handle const& each) { return std::string_view(each.sign) == sign; });
        ASSERT_TRUE(handle->is_button);
        scene = dragged(scene, handle->id, handle->place);
    };
    press("+");
    EXPECT_EQ(measured(scene).nodes_per_layer[0], 7);
    press("-");
    press("-");
    EXPECT_EQ(measured(scene).nodes_per_layer[0], 5);
    EXPECT_FALSE(kLineCurves.drag(small_scene(), 0, Vec2(0, 0)));
}

// In the gizmo, half the width of the column for the stem's heading stands for 90 degrees.
TEST(LineCurves, BendTheStemToAWholeDegree)
{
    auto const scene = frond_scene();
    auto const gizmo = kLineCurves.show(scene).value();
    auto const stem = handle_that_says(gizmo, "Stem: ");
    EXPECT_EQ(stem.says, "Stem: 0\u00b0");
    auto const changed = dragged(scene, stem.id, Vec2(-0.0441, stem.place.y()));
    auto const headings
        = [&](double x) { return lines::values_at(measured(changed), x).heading_deg; };
    EXPECT_NEAR(headings(0), std::round(90 * 0.0441 / 0.13), 0.3) << "to the left";
    EXPECT_NEAR(headings(0.5), 0, 1);
    EXPECT_EQ(changed.base->organs.size(), scene.base->organs.size());
    auto const far = dragged(scene, stem.id, Vec2(1, stem.place.y()));
    EXPECT_NEAR(lines::values_at(measured(far), 0).heading_deg, -90, 0.5);
}

// Bending the stem must be one step of a session, with a description.
TEST(LineCurves, ABentStemIsKept)
{
    auto const scene = frond_scene();
    auto const handle = handle_that_says(kLineCurves.show(scene).value(), "Stem: ");
    auto const edits = kLineCurves.drag(scene, handle.id, Vec2(-0.05, -0.9)).value();
    ASSERT_EQ(edits.size(), 1u);
    auto const record = session::record_of(edits[0]);
    auto const again = session::edit_of(record, methods::all_methods().edits).value();
    EXPECT_EQ(session::record_of(again).fields, record.fields);
    EXPECT_EQ(again.describe().substr(0, 11), "bends stem ");
    EXPECT_EQ(scene::apply_edits(scene, std::vector { again }).value().base->node_position_mm,
              scene::apply_edits(scene, edits).value().base->node_position_mm);
}

TEST(LineCurves, SetALayersNodesByTheWayFromOneToTheNext)
{
    auto const scene = frond_scene();
    auto const gizmo = kLineCurves.show(scene).value();
    auto const internode = handle_that_says(gizmo, "Layer 1: a node every");
    auto const of = measured(scene);
    double const from = of.inclinations[0].x;
    double const length = of.inclinations[1].x - from;
    auto const nodes_with = [&](double share) {
        double const y = -0.9 + 1.8 * (from + share * length);
        return measured(dragged(scene, internode.id, Vec2(0, y))).nodes_per_layer[0];
    };
    EXPECT_NEAR(internode.place.y(), -0.9 + 1.8 * (from + length / 6), 1e-9);
    EXPECT_EQ(nodes_with(0.25), 4);
    EXPECT_EQ(nodes_with(0.1), 10);
    EXPECT_EQ(nodes_with(2), 1) << "above the layer";
    EXPECT_EQ(nodes_with(-1), lines::kMaxNodesInLayer);
}

// A handle that no longer exists must be refused, whatever its number.
TEST(LineCurves, RefuseHandlesThatNothingHas)
{
    auto const scene = frond_scene();
    for (std::size_t handle = 400; handle < 412; ++handle)
        EXPECT_FALSE(kLineCurves.drag(scene, handle, Vec2(0.3, 0)));
}

} // namespace
} // namespace tractus::lines
