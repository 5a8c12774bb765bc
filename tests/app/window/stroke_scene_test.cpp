#include "app/window/stroke_scene.h"

#include "app/window/orbit.h"
#include "app/window/palette.h"
#include "tests/app/window/small_state.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <set>
#include <string>

namespace tractus::window {

namespace {

constexpr float kWidth_px = 800;
constexpr float kHeight_px = 600;

view::DrawnCurveView curve_through(std::vector<Vec3f> const& points_mm)
{
    view::DrawnCurveView curve { .name = "a curve" };
    for (auto const& point_mm : points_mm)
        curve.line.points.push_back({ point_mm, 2 });
    return curve;
}

// Returns a state with three curves: one to the right, one to the back, and one upwards.
view::WindowState state_with_curves()
{
    auto state = small_state();
    state.curves = { curve_through({ { 0, 0, 0 }, { 100, 0, 0 } }),
                     curve_through({ { 0, 0, 100 }, { 0, 70, 100 } }),
                     curve_through({ { -50, 0, 0 }, { -50, 0, 100 }, { -50, 0, 200 } }) };
    return state;
}

PictureProjection seen_from(view::WindowState const& state, render::ViewAngles const& angles)
{
    return { render::framing_camera(strokes_box(state), angles,
                                    static_cast<double>(kWidth_px / kHeight_px)),
             { kWidth_px, kHeight_px } };
}

std::size_t flat_lines(std::vector<render::Curve> const& curves)
{
    return static_cast<std::size_t>(std::ranges::count_if(
        curves, [](auto const& curve) { return curve.look == render::Curve::Look::Flat; }));
}

} // namespace

TEST(StrokeScene, HasGroundWithoutAnyCurve)
{
    auto const state = small_state();
    EXPECT_TRUE(highlighted_curves(state, {}).empty());
    EXPECT_TRUE(highlighted_curves(state, 3).empty());
    EXPECT_TRUE(stroke_curves(state, {}).empty());
    EXPECT_GT(ground_curves(state, {}).size(), 10u);
    EXPECT_GE(strokes_box(state).max_mm.z(), state.volume_mm.max_mm.z());
    EXPECT_GE(strokes_box(state).max_mm.x(), state.volume_mm.max_mm.x());
    view::WindowState const nothing;
    EXPECT_GT((strokes_box(nothing).max_mm - strokes_box(nothing).min_mm).minCoeff(), 0);
    EXPECT_FALSE(ground_curves(nothing, {}).empty());
    EXPECT_FALSE(curve_at(state.curves, seen_from(state, {}), { 400, 300 }, 1000));
}

TEST(StrokeScene, HighlightsThePickedOneElseTheSelectedElseTheNewest)
{
    auto state = state_with_curves();
    EXPECT_EQ(highlighted_curves(state, {}), (std::vector<std::size_t> { 2 }));
    state.curves[0].is_selected = true;
    state.curves[1].is_selected = true;
    EXPECT_EQ(highlighted_curves(state, {}), (std::vector<std::size_t> { 0, 1 }));
    EXPECT_EQ(highlighted_curves(state, 2), (std::vector<std::size_t> { 2 }));
    EXPECT_EQ(highlighted_curves(state, 3), (std::vector<std::size_t> { 0, 1 }))
        << "there is no such curve any more";
}

TEST(StrokeScene, DrawsEachCurveInItsColourAndTheHighlightedOnesWider)
{
    auto const state = state_with_curves();
    auto const curves = stroke_curves(state, { 1 });
    ASSERT_EQ(curves.size(), 6u) << "each with a dot at its start";
    std::set<float> reds;
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(curves[2 * i].points.front().color, curve_color(i));
        ASSERT_EQ(curves[2 * i + 1].points.size(), 1u);
        EXPECT_EQ(curves[2 * i + 1].points[0].position_mm,
                  state.curves[i].line.points.front().position_mm);
        reds.insert(curve_color(i).x());
    }
    EXPECT_EQ(reds.size(), 3u);
    EXPECT_GT(curves[2].points[0].width, 1.5f * curves[0].points[0].width);
    EXPECT_EQ(curve_color(0), curve_color(theme::palette().curves.size()));
}

TEST(StrokeScene, DropsALineFromTheHighlightedCurvesStart)
{
    auto const state = state_with_curves();
    auto const with = ground_curves(state, { 1 });
    auto const without = ground_curves(state, {});
    ASSERT_EQ(with.size(), without.size() + 1);
    EXPECT_EQ(with.back().points.front().position_mm, Vec3f(0, 0, 100));
    EXPECT_EQ(with.back().points.back().position_mm, Vec3f(0, 0, 0));
    EXPECT_EQ(flat_lines(with), with.size());
}

// When the camera turns, vertical lines must stay vertical, and the front must stay in front.
TEST(StrokeScene, ShowsTheGroundLevelFromEverywhere)
{
    auto const state = state_with_curves();
    for (double const azimuth_rad : { 0.0, 1.0, 3.0, -2.0 }) {
        auto const projection = seen_from(state, { azimuth_rad, 0.3 });
        auto const foot = projection.to_px({ 0, 0, 0 });
        auto const top = projection.to_px({ 0, 0, 100 });
        ASSERT_TRUE(foot && top);
        EXPECT_LT(top->y(), foot->y() - 50);
        EXPECT_NEAR(top->x(), foot->x(), 25);
        auto const front = projection.to_px(front_mm(state));
        ASSERT_TRUE(front);
        // The edge nearer to the camera is lower in the picture.
        bool const is_nearer = std::cos(azimuth_rad) > 0;
        EXPECT_EQ(front->y() > foot->y(), is_nearer) << azimuth_rad;
    }
}

// From every side, each curve must be found where it is seen. No curve may be found far from all of
// them.
TEST(StrokeScene, FindsTheCurveThatIsClicked)
{
    auto const state = state_with_curves();
    for (double const azimuth_rad : { 0.2, 1.1, 2.5, -1.4 })
        for (double const elevation_rad : { 0.1, 0.6, 1.4 }) {
            auto const projection = seen_from(state, { azimuth_rad, elevation_rad });
            for (std::size_t i = 0; i < state.curves.size(); ++i) {
                auto const& points = state.curves[i].line.points;
                Vec3f const middle_mm = 0.3f * points[0].position_mm + 0.7f * points[1].position_mm;
                auto const middle = projection.to_px(middle_mm);
                ASSERT_TRUE(middle);
                EXPECT_EQ(curve_at(state.curves, projection, *middle + Vec2f(2, 1), 14), i)
                    << azimuth_rad << ", " << elevation_rad;
            }
            EXPECT_FALSE(curve_at(state.curves, projection, { 3, 3 }, 14));
        }
}

TEST(StrokeScene, LooksFromTheOtherSideAfterHalfATurn)
{
    auto const state = state_with_curves();
    auto const before = seen_from(state, { 0, 0.2 });
    auto const behind = seen_from(state, { kPi, 0.2 });
    auto const& end_mm = state.curves[0].line.points.back().position_mm;
    EXPECT_GT(before.to_px(end_mm)->x(), before.to_px({ 0, 0, 0 })->x());
    EXPECT_LT(behind.to_px(end_mm)->x(), behind.to_px({ 0, 0, 0 })->x());
}

TEST(StrokeScene, FramesEveryCurve)
{
    auto const state = state_with_curves();
    for (double const azimuth_rad : { 0.0, 0.8, 2.2, -2.9 }) {
        auto const projection = seen_from(state, { azimuth_rad, 0.22 });
        for (auto const& curve : state.curves)
            for (auto const& point : curve.line.points) {
                auto const px = projection.to_px(point.position_mm);
                ASSERT_TRUE(px);
                EXPECT_GE(px->minCoeff(), 0);
                EXPECT_LE(px->x(), kWidth_px);
                EXPECT_LE(px->y(), kHeight_px);
            }
    }
}

TEST(StrokeScene, NumbersAThousandCurvesWithoutOverlap)
{
    auto state = small_state();
    for (int i = 0; i < 1000; ++i) {
        auto const angle = static_cast<float>(i) * 2.4f;
        auto const reach = std::sqrt(static_cast<float>(i)) * 3;
        Vec3f const start_mm(reach * std::cos(angle), reach * std::sin(angle), 10);
        state.curves.push_back(curve_through({ start_mm, start_mm + Vec3f(0, 0, 40) }));
    }
    auto const projection = seen_from(state, { 0.4, 0.3 });
    Vec2f const label_px(40, 22);
    auto const labels = curve_labels(state.curves, { 17 }, projection, label_px);
    ASSERT_GT(labels.size(), 20u);
    EXPECT_EQ(labels[0].curve, 17u) << "the highlighted one first";
    EXPECT_EQ(labels[1].curve, 999u) << "then the newest";
    for (std::size_t i = 0; i < labels.size(); ++i)
        for (std::size_t j = i + 1; j < labels.size(); ++j) {
            Vec2f const apart = (labels[i].corner_px - labels[j].corner_px).cwiseAbs();
            ASSERT_TRUE(apart.x() >= label_px.x() || apart.y() >= label_px.y());
        }
    EXPECT_LE(ground_curves(state, highlighted_curves(state, {})).size(), 80u);
}

TEST(StrokeScene, LeavesOutWhatIsBehindTheCamera)
{
    render::Camera camera;
    camera.eye_mm = { 0, -100, 0 };
    camera.target_mm = { 0, 0, 0 };
    PictureProjection const projection(camera, { kWidth_px, kHeight_px });
    EXPECT_FALSE(projection.to_px({ 0, -200, 0 }));
    auto const middle = projection.to_px({ 0, 0, 0 });
    ASSERT_TRUE(middle);
    EXPECT_TRUE(middle->isApprox(Vec2f(kWidth_px / 2, kHeight_px / 2), 1e-4f));
    std::vector<view::DrawnCurveView> const curves { curve_through(
        { { 0, -300, 0 }, { 0, -200, 0 } }) };
    EXPECT_FALSE(curve_at(curves, projection, { kWidth_px / 2, kHeight_px / 2 }, 5000));
}

} // namespace tractus::window
