#include "app/window/view_curves.h"

#include "app/methods/silhouettes/outline_tool.h"
#include "app/window/palette.h"
#include "tests/app/window/small_state.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace tractus::window {

namespace {

bool starts_at(render::Curve const& curve, Vec3f const& position_mm)
{
    return curve.points.front().position_mm.isApprox(position_mm);
}

// Returns a copy of the curve with the given begin and unit, since g++ 14 warns of a dangling
// reference here.
render::Curve find(std::vector<render::Curve> const& curves, Vec3f const& begin_mm,
                   render::Curve::WidthUnit unit)
{
    auto const found = std::ranges::find_if(curves, [&](auto const& curve) {
        return curve.width_unit == unit && starts_at(curve, begin_mm);
    });
    EXPECT_NE(found, curves.end());
    return found == curves.end() ? curves.front() : *found;
}

} // namespace

TEST(PadCurves, HaveAGridAtTheSurface)
{
    auto const curves = pad_live_curves(small_state());
    auto const in_grid = std::ranges::count_if(curves, [](auto const& curve) {
        return curve.points.size() == 2 && curve.points[0].color == theme::palette().grid
            && curve.points[0].position_mm.z() == 150 && curve.points[1].position_mm.z() == 150;
    });
    EXPECT_EQ(in_grid, 11 + 7) << "every 20 mm of 200 by 150";
}

TEST(PadCurves, FadeStrokesWithTheDepthBelowTheSurface)
{
    auto const curves = pad_stroke_curves(small_state());
    auto const stroke = find(curves, { -60, -40, 20 }, render::Curve::WidthUnit::Millimetres);
    EXPECT_TRUE(stroke.fades);
    EXPECT_EQ(stroke.points[0].color, theme::palette().stroke);
    EXPECT_EQ(stroke.points[0].width, 6);
    auto const fade = pad_fade(small_state());
    EXPECT_EQ(fade.from_mm, 150) << "above the surface nothing is faded";
    EXPECT_EQ(fade.range_mm, 300);
}

TEST(PadCurves, ShowWhereTheEraserWasButNotAsInk)
{
    auto state = small_state();
    auto const places = [&] {
        return find(pad_live_curves(state), { 0, 30, 150 }, render::Curve::WidthUnit::Millimetres)
            .points;
    };
    EXPECT_EQ(places()[0].color, theme::palette().ink);
    state.live_ink[0].look = tools::InkStyle::Look::Eraser;
    EXPECT_NE(places()[0].color, theme::palette().ink);
    EXPECT_NE(places()[0].color, theme::palette().pad_background) << "it is seen";
}

TEST(PadCurves, DashWhatWasRefused)
{
    auto state = small_state();
    auto const before = pad_live_curves(state).size();
    view::RefusedStroke refused { .why = "nothing is selected" };
    for (int i = 0; i <= 40; ++i)
        refused.ink.points.push_back({ { static_cast<float>(i), 50, 150 }, 5 });
    state.refused = refused;
    auto const dashed = pad_live_curves(state);
    ASSERT_EQ(dashed.size(), before + 5) << "40 mm in dashes and gaps of 4";
    auto const first = find(dashed, { 0, 50, 150 }, render::Curve::WidthUnit::Pixels);
    EXPECT_TRUE(first.points.back().position_mm.isApprox(Vec3f(4, 50, 150)));
    EXPECT_NE(first.points[0].color, theme::palette().ink);
    // The outline tool draws on the upright sheet. The refused stroke was not drawn there, so it is
    // not shown.
    state.hand = silhouette::OutlineTool {};
    EXPECT_EQ(pad_live_curves(state).size(), before);
}

TEST(PadCurves, ShowTheBranchesThatTheInkWouldMove)
{
    auto state = small_state();
    state.preview = { { .points_mm = { { 0, 0, 200 }, { 0, 100, 400 } },
                        .width_mm = 15,
                        .state = tools::SkeletonLine::State::Assigned } };
    auto const curves = pad_preview_curves(state);
    auto const moved = find(curves, { 0, 0, 80 }, render::Curve::WidthUnit::Pixels);
    EXPECT_TRUE(moved.points.back().position_mm.isApprox(Vec3f(0, 40, 160)));
    EXPECT_EQ(preview_curves(state).front().points[0].color, theme::palette().assigned);
}

TEST(PadCurves, DropALineFromThePenToTheFloor)
{
    auto const curves = pad_live_curves(small_state());
    auto const drop = find(curves, { 40, 30, 150 }, render::Curve::WidthUnit::Pixels);
    EXPECT_EQ(drop.points.back().position_mm, Vec3f(40, 30, 0));
}

TEST(PadCurves, LeaveThePenOutWhenItIsAway)
{
    auto state = small_state();
    auto const with_pen = pad_live_curves(state).size();
    state.pen.in_range = false;
    EXPECT_EQ(pad_live_curves(state).size(), with_pen - 3);
}

TEST(PadCurves, PutTheSkeletonIntoTheVolume)
{
    auto const curves = pad_skeleton_curves(small_state());
    auto const branch = find(curves, { 0, 0, 80 }, render::Curve::WidthUnit::Pixels);
    EXPECT_TRUE(branch.points.back().position_mm.isApprox(Vec3f(-80, 0, 160)));
}

TEST(SkeletonCurves, ShowEachStateInItsColour)
{
    auto const curves = skeleton_curves(small_state());
    EXPECT_EQ(find(curves, { 0, 0, 0 }, render::Curve::WidthUnit::Pixels).points[0].color,
              theme::palette().unselected);
    auto const colored = [&](Vec3f const& color) {
        return std::ranges::count_if(
            curves, [&](auto const& curve) { return curve.points[0].color == color; });
    };
    EXPECT_EQ(colored(theme::palette().selected), 1);
    EXPECT_EQ(colored(theme::palette().assigned), 1);
    EXPECT_EQ(colored(theme::palette().undetermined), 0);

    auto const states = skeleton_states(small_state());
    EXPECT_TRUE(states.selected && states.assigned && states.layers.size() == 1);
    EXPECT_FALSE(states.undetermined);
    auto const bare = skeleton_states({});
    EXPECT_FALSE(bare.selected || bare.assigned || !bare.layers.empty());
}

TEST(SkeletonCurves, DrawIndicatorsAsArrows)
{
    auto const curves = skeleton_curves(small_state());
    auto const arrow = find(curves, { -150, 0, 60 }, render::Curve::WidthUnit::Pixels);
    EXPECT_EQ(arrow.end, render::Curve::End::Arrow);
    EXPECT_EQ(arrow.points[0].color, theme::palette().indicator);
}

TEST(LayerCurves, DashAndDotByTheirPattern)
{
    static constexpr tools::Layer kDashed {
        .label = "dashed",
        .style = { .pattern = tools::LayerStyle::Pattern::Dashed, .width_mm = 1 },
        .lines = nullptr
    };
    auto state = small_state();
    state.strokes.clear();
    // Dashes of 4 mm alternate with gaps of 2.4 mm around a corner: dashes from 0 to 4, 6.4 to
    // 10.4, and 12.8 to 16 mm.
    state.layers = { { &kDashed, { { { 0, 0, 0 }, { 8, 0, 0 }, { 8, 8, 0 } } } } };
    auto const curves = pad_stroke_curves(state);
    ASSERT_EQ(curves.size(), 3u);
    EXPECT_TRUE(curves[0].points.back().position_mm.isApprox(Vec3f(4, 0, 0), 1e-5f));
    EXPECT_TRUE(curves[1].points.front().position_mm.isApprox(Vec3f(6.4f, 0, 0), 1e-5f));
    EXPECT_TRUE(curves[1].points[1].position_mm.isApprox(Vec3f(8, 0, 0), 1e-5f)) << "the corner";
    EXPECT_TRUE(curves[2].points.back().position_mm.isApprox(Vec3f(8, 8, 0), 1e-5f));
    auto const in_skeleton = skeleton_curves(state);
    EXPECT_TRUE(in_skeleton.back().points.back().position_mm.isApprox(Vec3f(20, 20, 0), 1e-5f))
        << "in the plant's frame, which is shown at 0.4";
}

TEST(PadCurves, LayTheSheetOnTheSurfaceForToolsThatDrawOnPaper)
{
    auto state = small_state();
    EXPECT_TRUE(pad_of_world(state).matrix().isIdentity());
    state.hand = silhouette::OutlineTool {};
    state.paper = { .base_mm = { 10, -60 }, .world_point_mm = { 30, 5, 0 } };
    auto const T_pad_world = pad_of_world(state);
    EXPECT_TRUE((T_pad_world * Vec3f(30, 5, 0)).isApprox(Vec3f(10, -60, 150), 1e-5f))
        << "the plant's base lies on the surface where it was drawn";
    EXPECT_TRUE((T_pad_world * Vec3f(40, 5, 100)).isApprox(Vec3f(20, 40, 150), 1e-5f))
        << "up in the world is away from the user";
    EXPECT_TRUE((T_pad_world * Vec3f(30, -5, 0)).isApprox(Vec3f(10, -60, 160), 1e-5f))
        << "what is nearer to the user is nearer to the eye";
}

} // namespace tractus::window
