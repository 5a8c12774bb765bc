#include "app/methods/all_methods.h"
#include "app/methods/pictures/picture_tool.h"
#include "app/session/edit_record.h"
#include "app/tools/tool.h"
#include "engine/scene/picture_ground.h"
#include "tests/app/methods/pictures/small_picture.h"
#include "tests/app/small_model.h"

#include <cmath>
#include <gtest/gtest.h>

namespace tractus::pictures {
namespace {

// The picture is 200 mm wide with its middle at (10, 20). It shows level ground, seen by a
// horizontal camera 1.6 m above the ground with a field of view of 53 degrees. seen_mm() gives the
// position of a point in the picture.
constexpr double kCamera_m = 1.6;
constexpr double kWidth_mm = 200;
Vec2 const kMiddle_mm(10, 20);

Vec2 seen_mm(double right_m, double ahead_m, double up_m)
{
    return kMiddle_mm + kWidth_mm * Vec2(right_m, up_m - kCamera_m) / ahead_m;
}

scene::BackPicture picture(scene::PictureGround const& ground)
{
    return { .place = { .x_mm = kMiddle_mm.x(), .y_mm = kMiddle_mm.y(), .width_mm = kWidth_mm },
             .ground = ground };
}

scene::PictureGround known_at(double right_m, double ahead_m, double height_m)
{
    auto const place = picture({}).place;
    return { .horizon = 0,
             .measured = scene::PictureGround::Measured {
                 .foot = scene::on_picture(place, seen_mm(right_m, ahead_m, 0)),
                 .top = scene::on_picture(place, seen_mm(right_m, ahead_m, height_m)),
                 .height_m = height_m } };
}

TEST(PictureGround, GivesPlacesAndSizesAsACameraSeesThem)
{
    auto const shown = picture(known_at(-2, 12, 1.8));
    for (double const right_m : { -8.0, 0.0, 5.0 })
        for (double const ahead_m : { 6.0, 12.0, 40.0 }) {
            auto const place
                = scene::place_on_ground(shown, seen_mm(right_m, ahead_m, 0)).value().value();
            EXPECT_NEAR(place.right_m, right_m, 1e-9);
            EXPECT_NEAR(place.behind_m, ahead_m - 12, 1e-9);
            double const tall_mm
                = (seen_mm(right_m, ahead_m, 9) - seen_mm(right_m, ahead_m, 0)).y();
            EXPECT_NEAR(tall_mm * place.m_per_mm, 9, 1e-9);
        }
}

TEST(PictureGround, WithoutAHorizonIsAllOfOneDistance)
{
    auto ground = known_at(-2, 12, 1.8);
    ground.horizon.reset();
    auto const place = scene::place_on_ground(picture(ground), seen_mm(3, 30, 0)).value().value();
    EXPECT_EQ(place.behind_m, 0);
    EXPECT_NEAR(place.m_per_mm, 12 / kWidth_mm, 1e-9);
    EXPECT_FALSE(scene::place_on_ground(picture({}), Vec2(0, 0)).value());
    EXPECT_FALSE(scene::place_on_ground(picture({ .horizon = 0.1 }), Vec2(0, 0)).value());
}

TEST(PictureGround, RefusesWhatIsNotOnTheGround)
{
    EXPECT_FALSE(scene::place_on_ground(picture(known_at(0, 12, 1.8)), kMiddle_mm + Vec2(5, 3)));
    EXPECT_FALSE(scene::check_ground(known_at(0, 12, -1)));
    EXPECT_FALSE(scene::check_ground(known_at(0, 12, 500)));
    auto above = known_at(0, 12, 1.8);
    above.horizon = -0.4;
    EXPECT_FALSE(scene::check_ground(above));
}

scene::Scene with_view()
{
    auto const place = picture({}).place;
    return scene::apply_edit(small_scene(), scene::LayPicture { "oak.png", small_png(), place })
        .value();
}

Stroke line_mm(Vec2 const& from, Vec2 const& to)
{
    return stroke_through({ { from.x(), from.y(), 80 }, { to.x(), to.y(), 80 } });
}

scene::Scene ground_after(scene::Scene const& scene, Stroke const& stroke, double height_m = 1.8)
{
    PictureTool const tool { .does = PictureTool::Does::Ground, .height_m = height_m };
    auto const edits = tools::Tool(tool).edits_for(stroke, scene);
    EXPECT_TRUE(edits) << edits.error().message;
    return edits ? scene::apply_edits(scene, *edits).value() : scene;
}

TEST(PictureTool, TakesTheHorizonAndAKnownHeight)
{
    auto scene = ground_after(with_view(), line_mm({ -60, 19 }, { 90, 21 }));
    ASSERT_TRUE(scene.state.picture->ground.horizon);
    EXPECT_NEAR(*scene.state.picture->ground.horizon, 0, 1e-12);
    // A reference line of 1.8 m, drawn once from its top down and once from its base up.
    auto const foot = seen_mm(-2, 12, 0);
    auto const top = seen_mm(-2, 12, 1.8);
    auto const up = ground_after(scene, line_mm(foot, top));
    auto const down = ground_after(scene, line_mm(top, foot));
    EXPECT_EQ(up.state.picture->ground, down.state.picture->ground);
    EXPECT_NEAR(
        scene::place_on_ground(*up.state.picture, seen_mm(4, 24, 0)).value().value().behind_m, 12,
        1e-6);
    // When the picture is moved and enlarged, its ground moves with it.
    auto moved = up.state.picture->place;
    moved.x_mm += 30;
    moved.width_mm *= 2;
    auto const other = scene::apply_edit(up, scene::PlacePicture { moved }).value();
    Vec2 const there = Vec2(moved.x_mm, moved.y_mm) + 2 * (seen_mm(4, 24, 0) - kMiddle_mm);
    EXPECT_NEAR(scene::place_on_ground(*other.state.picture, there).value().value().right_m, 4,
                1e-6);
    EXPECT_EQ(PictureTool::kKind.describe(PictureTool { .does = PictureTool::Does::Ground }, up),
              "A tree's foot says where it stands now, and its outline how tall it is");
}

TEST(PictureTool, RefusesADotAndAHeightAboveTheHorizon)
{
    auto const tool = tools::Tool(PictureTool { .does = PictureTool::Does::Ground });
    EXPECT_FALSE(tool.edits_for(line_mm({ 0, 0 }, { 1, 1 }), with_view()));
    auto const scene = ground_after(with_view(), line_mm({ -60, 20 }, { 90, 20 }));
    auto const refused = tool.edits_for(line_mm({ 0, 30 }, { 0, 60 }), scene);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("below the horizon"), std::string::npos);
    EXPECT_FALSE(tool.edits_for(line_mm({ 0, -30 }, { 0, 60 }), small_scene()));
}

TEST(PictureTool, KeepsTheGroundInItsRecord)
{
    scene::SetPictureGround const edit { known_at(-2, 12, 1.8) };
    auto const again
        = session::edit_of(session::record_of(edit), methods::all_methods().edits).value();
    EXPECT_EQ(again.get<scene::SetPictureGround>()->ground, edit.ground);
    auto const none = session::edit_of(session::record_of(scene::SetPictureGround {}),
                                       methods::all_methods().edits)
                          .value();
    EXPECT_EQ(none.get<scene::SetPictureGround>()->ground, scene::PictureGround {});
}

} // namespace
} // namespace tractus::pictures
