#include "app/view/station_view.h"

#include "app/methods/indicators/indicate_tool.h"
#include "app/tools/branch_previewer.h"
#include "app/tools/draw_in_order_tool.h"
#include "app/tools/draw_tool.h"
#include "app/tools/erase_tool.h"
#include "app/tools/select_tool.h"
#include "app/tools/underground.h"
#include "app/view/orphans.h"
#include "engine/mesh/mesh_measures.h"
#include "engine/plant/join_axes.h"
#include "tests/app/document/step_of.h"
#include "tests/app/drawing_station.h"
#include "tests/app/simple_rig.h"
#include "tests/engine/scene/edits.h"

#include <algorithm>
#include <array>
#include <fmt/core.h>
#include <gtest/gtest.h>
#include <optional>
#include <utility>

namespace tractus::view {
namespace {

// Returns a station that has only the tools of this test. Other tools would need all methods, which
// the build with the thread sanitizer leaves out.
DrawingStation station_on(scene::Scene scene, std::optional<tools::Tool> const& tool = {})
{
    static constexpr std::array kTools { &tools::DrawInOrderTool::kKind, &tools::DrawTool::kKind,
                                         &tools::SelectTool::kKind, &tools::EraseTool::kKind,
                                         &indicators::IndicateTool::kKind };
    return { flat_station(kTools, tool), std::move(scene) };
}

// Begins a curved stroke. A straight stroke would not change the straight trunk.
void begin_stroke(DrawingStation& station)
{
    for (int i = 0; i < 10; ++i)
        station.push(kPen, at_ms(5 * i), pen_report(50 + 5 * i, 50 - 0.4 * i * i, true));
}

void end_stroke(DrawingStation& station)
{
    station.push(kPen, at_ms(60), pen_report(110, 50, false));
}

TEST(StationView, LetsTheBranchFollowThePen)
{
    auto station = station_on(small_scene(), tools::DrawInOrderTool {});
    StationView view(station, station.document());
    view.show(station, station.document());
    EXPECT_TRUE(view.state().preview.empty());
    begin_stroke(station);
    view.show(station, station.document());
    view.settle();
    // The preview has the trunk and the two branches that move with it.
    ASSERT_EQ(view.state().preview.size(), 3u);
    auto const& trunk = view.state().preview.front();
    EXPECT_EQ(trunk.state, tools::SkeletonLine::State::Assigned);
    EXPECT_EQ(trunk.points_mm.size(), 7u);
    auto const revision = view.state().preview_revision;
    auto const skeletons = view.state().skeleton_revision;
    // If nothing new has happened, showing the station again must not change the preview.
    view.show(station, station.document());
    view.settle();
    EXPECT_EQ(view.state().preview_revision, revision);
    end_stroke(station);
    view.show(station, station.document());
    view.settle();
    EXPECT_TRUE(view.state().preview.empty());
    EXPECT_GT(view.state().preview_revision, revision);
    EXPECT_GT(view.state().skeleton_revision, skeletons) << "when the stroke was done";
}

std::size_t in_state(StationView const& view, tools::SkeletonLine::State state)
{
    std::size_t count = 0;
    for (auto const& line : view.state().skeleton)
        count += line.state == state;
    return count;
}

// The skeleton after the pen is lifted must be equal to the one shown while drawing.
TEST(StationView, KeepsTheSkeletonAsStrokesBendIt)
{
    auto station = station_on(small_scene(), tools::DrawInOrderTool {});
    StationView view(station, station.document());
    view.show(station, station.document());
    EXPECT_EQ(in_state(view, tools::SkeletonLine::State::Next), 1u);
    EXPECT_EQ(view.state().skeleton.front().state, tools::SkeletonLine::State::Next) << "the trunk";
    begin_stroke(station);
    view.show(station, station.document());
    view.settle();
    auto const shown = view.state().preview;
    ASSERT_EQ(shown.size(), 3u);
    end_stroke(station);
    view.show(station, station.document());
    view.settle();
    auto const& kept = view.state().skeleton;
    ASSERT_EQ(kept.size(), 3u);
    for (std::size_t i = 0; i < kept.size(); ++i) {
        ASSERT_EQ(kept[i].points_mm.size(), shown[i].points_mm.size());
        for (std::size_t k = 0; k < kept[i].points_mm.size(); ++k)
            EXPECT_LT((kept[i].points_mm[k] - shown[i].points_mm[k]).norm(), 0.5f);
    }
    EXPECT_EQ(kept[0].state, tools::SkeletonLine::State::Assigned)
        << "green, though it is selected, too";
    EXPECT_EQ(in_state(view, tools::SkeletonLine::State::Next), 1u) << "the next branch";
    station.set_tool(at_ms(70), tools::SelectTool {});
    view.show(station, station.document());
    EXPECT_EQ(in_state(view, tools::SkeletonLine::State::Next), 0u);
}

// A refused stroke stays visible beside the reason, until the next stroke begins.
TEST(StationView, KeepsARefusedStrokeInSight)
{
    // No branch is selected, so the stroke is refused.
    auto station = station_on(small_scene(), tools::DrawTool {});
    StationView view(station, station.document());
    auto const draw = [&] {
        begin_stroke(station);
        end_stroke(station);
        view.show(station, station.document());
    };
    draw();
    auto const drawn = station.strokes();
    ASSERT_EQ(drawn.size(), 1u);
    ASSERT_FALSE(drawn[0].refusal.empty());
    view.tell(drawn[0]);
    ASSERT_TRUE(view.state().refused);
    EXPECT_EQ(view.state().refused->why, drawn[0].refusal);
    EXPECT_EQ(view.state().refused->surface, tools::Surface::Space);
    EXPECT_EQ(view.state().refused->ink.points.size(), drawn[0].stroke.tips.size());
    auto const revision = view.state().live_revision;
    view.show(station, station.document());
    EXPECT_TRUE(view.state().refused) << "nothing has happened";
    for (int i = 0; i < 5; ++i)
        station.push(kPen, at_ms(200 + 5 * i), pen_report(50 + 5 * i, 50, true));
    view.show(station, station.document());
    EXPECT_FALSE(view.state().refused);
    EXPECT_GT(view.state().live_revision, revision);
    document::DrawnStroke const done { drawn[0].stroke, drawn[0].tool };
    view.tell(drawn[0]);
    view.tell(done);
    EXPECT_FALSE(view.state().refused) << "the last one was not";
}

TEST(StationView, ShowsWhatPropagationShapes)
{
    auto scene = small_scene();
    select(scene, { segments_of(scene.base->axes[0]) });
    scene
        = scene::apply_edit(scene,
                            scene::Associate { .stroke = stroke_through(
                                                   { { 0, 0, 0 }, { 0, 0, 30 }, { 40, 0, 60 } }),
                                               .propagation = variation::Propagation::Descendants })
              .value();
    auto station = station_on(scene, tools::DrawTool {});
    StationView const view(station, station.document());
    EXPECT_EQ(in_state(view, tools::SkeletonLine::State::Assigned), 2u)
        << "both branches of the trunk";
}

TEST(StationView, PreviewsWhatTheStrokeWillBe)
{
    auto station = station_on(small_scene(), tools::DrawInOrderTool {});
    StationView view(station, station.document());
    begin_stroke(station);
    view.show(station, station.document());
    view.settle();
    auto const preview = view.state().preview.front().points_mm;
    station.finish();
    ASSERT_EQ(station.scene().associations.size(), 1u);
    tools::Tool const tool = tools::DrawInOrderTool {};
    auto const& ink = station.scene().associations[0].what.stroke.tips.vector();
    auto const lines = tools::branch_previewer()->show(
        { std::make_shared<scene::Scene const>(small_scene()), tool, ink, 9 });
    ASSERT_FALSE(lines.empty());
    for (std::size_t i = 0; i < preview.size(); ++i)
        EXPECT_TRUE(lines.front().points_mm[i].isApprox(preview[i], 1e-4f)) << i;
}

TEST(StationView, PreviewsNothingForAPenThatShapesNothing)
{
    for (auto const& tool :
         { tools::Tool(tools::SelectTool {}), tools::Tool(indicators::IndicateTool {}),
           tools::Tool(tools::DrawTool {}) /* Nothing is selected. */ }) {
        auto station = station_on(small_scene(), tool);
        StationView view(station, station.document());
        begin_stroke(station);
        view.show(station, station.document());
        EXPECT_FALSE(view.state().live_ink.empty());
        EXPECT_TRUE(view.state().preview.empty());
    }
}

// While a stroke is being erased, the preview must show its branch unbent. This must also work for
// the pen's other end while the current tool draws.
TEST(StationView, LetsTheBranchGoBackWhileItsStrokeIsErased)
{
    auto station = station_on(small_scene(), tools::DrawInOrderTool {});
    StationView view(station, station.document());
    begin_stroke(station);
    end_stroke(station);
    view.show(station, station.document());
    auto const erase = [&](int number) {
        auto report = pen_report(80 + number, 40, true);
        report[1] = std::byte { 0x38 }; // The flags "in range", "eraser" and "invert".
        station.push(kPen, at_ms(300 + 5 * number), report);
    };
    for (int i = 0; i < 15; ++i)
        erase(i);
    view.show(station, station.document());
    view.settle();
    ASSERT_EQ(view.state().live_ink.size(), 1u);
    EXPECT_EQ(view.state().live_ink[0].look, tools::InkStyle::Look::Eraser);
    EXPECT_EQ(view.state().live_ink[0].points[0].width_mm, 2 * tools::EraseTool::kRadius_mm);
    ASSERT_FALSE(view.state().preview.empty());
    for (auto const& point : view.state().preview.front().points_mm)
        EXPECT_LT(point.head<2>().norm(), 1e-3) << "the trunk is straight as the model has it";
}

TEST(StationView, ShowsAStrokeOfSeveralBranchesTwiceOnlyWhereTheyDiffer)
{
    auto scene = small_scene();
    select(scene, { segments_of(scene.base->axes[1]), segments_of(scene.base->axes[2]) });
    scene = scene::apply_edit(std::move(scene),
                              scene::Associate { stroke_through({ { 0, 0, 0 }, { 0, 40, 60 } }) })
                .value();
    auto const shown = [](scene::Scene const& shown_scene) {
        auto const station = station_on(shown_scene);
        return StationView(station, station.document()).state().strokes.size();
    };
    EXPECT_EQ(shown(scene), 1u);
    EXPECT_EQ(shown(scene::apply_edit(scene,
                                      scene::EraseTips { scene::numbered({ 0, 1 }), { { 9, 10 } } })
                        .value()),
              1u);
    EXPECT_EQ(
        shown(scene::apply_edit(scene, scene::EraseTips { scene::numbered({ 1 }), { { 9, 10 } } })
                  .value()),
        2u);
}

// Returns a scene with a trunk. Each segment of the trunk has a branch with a twig of a hundred
// segments.
scene::Scene bushy_scene(int branches)
{
    auto model = small_model();
    model.source.text = "Lsystem: 1\nderivation length: 100\nAxiom: ";
    for (int i = 0; i < branches; ++i)
        model.source.text += "F(10)[+(60)F(8)[+(50)A]F(8)]";
    // After its last branch, the trunk continues to a tip of its own.
    model.source.text += "F(10)\nA --> F(1)A\nendlsystem\n";
    return scene::apply_edit({}, model).value();
}

TEST(StationView, LeavesTheTwigsOfLargePlantsOutOfTheSkeleton)
{
    auto const small = station_on(bushy_scene(100), {});
    EXPECT_EQ(StationView(small, small.document()).state().skeleton.size(), 1u + 2 * 100);
    auto const large = station_on(bushy_scene(500), {});
    EXPECT_EQ(StationView(large, large.document()).state().skeleton.size(), 1u + 500);
}

TEST(StationView, ListsWhatHasLostItsBranch)
{
    auto bare = small_model();
    bare.source.text = "Lsystem: 1\nderivation length: 1\nAxiom: F(10)\nA --> A\nendlsystem\n";
    bare.drawn = scene::Drawn::Keep;
    std::vector<scene::Edit> edits { small_model(), scene::Select { { { 0, 1, 2 } } },
                                     scene::Associate {
                                         stroke_through({ { 0, 0, 0 }, { 10, 5, 100 } }) } };
    auto station = station_on(scene::fold(edits).value(), {});
    StationView view(station, station.document());
    EXPECT_TRUE(view.state().orphans.empty());
    station.document().make(document::step_of({ bare }));
    view.show(station, station.document());
    ASSERT_EQ(view.state().orphans.size(), 1u);
    EXPECT_EQ(view.state().orphans[0].name, "stroke 3") << "the third edit's";
    EXPECT_EQ(view.state().orphans[0].place, "up to segment 3 of stem 1");
    auto const edits_away = edits_without_orphans(station.scene());
    ASSERT_EQ(edits_away.size(), 1u);
    EXPECT_TRUE(scene::apply_edit(station.scene(), edits_away[0]).value().associations.empty());
    EXPECT_NE(view.state().status.find("has lost 1 of the branches"), std::string::npos);
    station.document().begin_again("");
    view.show(station, station.document());
    EXPECT_TRUE(view.state().orphans.empty());
}

TEST(StationView, ShowsTheSurfaceMoveUnderAPenThatRests)
{
    DrawingStation station(station::Station::create(simple_rig(), {}).value(), small_scene());
    StationView view(station, station.document());
    auto const move_surface = [&](int from_ms, int counts) {
        for (int i = 0; i < 10; ++i)
            station.push(kHeight, at_ms(from_ms + 10 * i), height_report(counts));
        view.show(station, station.document());
    };
    move_surface(0, 1000);
    station.push(kPen, at_ms(100), pen_report(50, 50, false));
    view.show(station, station.document());
    auto const before = view.state().live_revision;
    double const low_mm = view.state().surface_height_mm;
    EXPECT_NEAR(static_cast<double>(view.state().pen.tip_mm.z()), low_mm, 1e-4);

    move_surface(200, 2000); // The resting pen sends no reports, but must still count as in range.
    EXPECT_TRUE(view.state().pen.in_range);
    EXPECT_GT(view.state().surface_height_mm, low_mm + 10);
    EXPECT_NEAR(static_cast<double>(view.state().pen.tip_mm.z()), view.state().surface_height_mm,
                1e-4);
    EXPECT_GT(view.state().live_revision, before);
}

TEST(StationView, GrowsACollectionOneByOne)
{
    auto const station = station_on(small_scene(), {});
    StationView view(station, station.document());
    view.collect({ 3, {} });
    EXPECT_EQ(view.state().collection_wanted, 3u);
    view.settle();
    ASSERT_EQ(view.state().collection.size(), 3u);
    for (std::uint64_t i = 0; i < 3; ++i) {
        EXPECT_EQ(view.state().collection[i].seed, i + 1);
        EXPECT_GT(view.state().collection[i].mesh->triangle_count(), 0u);
        EXPECT_LT(view.state().collection[i].mesh->triangle_count(),
                  view.state().plant->triangle_count());
    }
    auto const revision = view.state().collection_revision;
    view.collect({ 0, {} });
    view.settle();
    EXPECT_TRUE(view.state().collection.empty());
    EXPECT_GT(view.state().collection_revision, revision);
}

// Returns the height of the top of a mesh above the ground.
double height_of(mesh::Mesh const& mesh)
{
    return mesh::bounds(mesh).max_mm.z();
}

TEST(StationView, GrowsIndividualsAsFarAsIsAsked)
{
    auto const station = station_on(small_scene(), {});
    StationView view(station, station.document());
    view.collect({ 12, { .size = 0.4 } });
    view.settle();
    ASSERT_EQ(view.state().collection.size(), 12u);
    auto const heights = [&] {
        std::pair extremes { 1e9, 0.0 };
        for (auto const& one : view.state().collection)
            extremes = { std::min(extremes.first, height_of(*one.mesh)),
                         std::max(extremes.second, height_of(*one.mesh)) };
        return extremes;
    };
    auto const [least, most] = heights();
    EXPECT_GT(most, 1.4 * least);
    EXPECT_EQ(view.state().individuality.size, 0.4);
    view.collect({ 12, {} });
    view.settle();
    auto const [lower, higher] = heights();
    EXPECT_LT(higher, 1.2 * lower) << "growth alone";
}

TEST(StationView, ShowsAndCountsWhatGrowthTakesBelowTheGround)
{
    auto scene = small_scene();
    scene::SetGrowth growth;
    growth.parameters.prevailing = Vec3(60, 0, -60);
    growth.parameters.strength = 0;
    scene = scene::apply_edit(scene, growth).value();
    auto const station = station_on(scene, {});
    StationView view(station, station.document());
    view.settle();
    auto const& state = view.state();
    ASSERT_FALSE(state.underground_mm.empty());
    for (auto const& line_mm : state.underground_mm)
        EXPECT_LT(line_mm.back().z(), 0);
    auto const segments = scene.base->segment_count();
    EXPECT_EQ(state.underground,
              fmt::format("growth takes {} of {} segments below the ground",
                          state.underground_mm.size(), segments));
    ASSERT_FALSE(state.layers.empty());
    EXPECT_EQ(state.layers.back().layer, &tools::kGrownUndergroundLayer);
    EXPECT_EQ(state.layers.back().lines_mm.size(), state.underground_mm.size());
    auto const revision = state.plant_revision;
    view.set_along_ground(true);
    view.settle();
    EXPECT_GT(state.plant_revision, revision);
    EXPECT_TRUE(state.underground_mm.empty());
    EXPECT_EQ(state.underground, "");
    EXPECT_TRUE(std::ranges::none_of(state.layers, [](ShownLayer const& shown) {
        return shown.layer == &tools::kGrownUndergroundLayer;
    }));
    view.set_along_ground(false);
    view.settle();
    EXPECT_FALSE(state.underground_mm.empty());
}

} // namespace
} // namespace tractus::view
