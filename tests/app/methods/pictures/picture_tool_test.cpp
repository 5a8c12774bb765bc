#include "app/methods/pictures/picture_tool.h"

#include "app/methods/all_methods.h"
#include "app/session/edit_record.h"
#include "app/tools/tool.h"
#include "app/view/station_view.h"
#include "engine/scene/back_picture.h"
#include "tests/app/document/step_of.h"
#include "tests/app/flat_station.h"
#include "tests/app/methods/pictures/small_picture.h"
#include "tests/app/small_model.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace tractus::pictures {
namespace {

using Does = PictureTool::Does;

scene::Scene with_picture(scene::PicturePlace const& place = {})
{
    return scene::apply_edit(small_scene(), scene::LayPicture { "oak.png", small_png(), place })
        .value();
}

Result<scene::PicturePlace> place_after(Does does, Stroke const& stroke, scene::Scene const& scene)
{
    auto const edits = TRY(tools::Tool(PictureTool { does }).edits_for(stroke, scene));
    return scene::apply_edits(scene, edits).value().state.picture->place;
}

TEST(PictureTool, MovesThePictureAlongWithTheStroke)
{
    auto const scene = with_picture({ .x_mm = 5, .y_mm = -2 });
    auto const place
        = place_after(Does::Move, stroke_through({ { 10, 10, 80 }, { 40, -10, 90 } }), scene);
    ASSERT_TRUE(place);
    EXPECT_EQ(*place, (scene::PicturePlace { .x_mm = 35, .y_mm = -22 }));
}

TEST(PictureTool, SizesAndTurnsItAboutItsMiddle)
{
    auto const scene = with_picture({ .x_mm = 10, .y_mm = 20, .width_mm = 100 });
    auto const sized
        = place_after(Does::Size, stroke_through({ { 30, 20, 0 }, { 10, 60, 0 } }), scene);
    EXPECT_NEAR(sized.value().width_mm, 200, 1e-9) << "twice as far from the middle";
    auto const turned
        = place_after(Does::Turn, stroke_through({ { 30, 20, 0 }, { 10, 60, 0 } }), scene);
    EXPECT_NEAR(turned.value().turn_deg, 90, 1e-9);
    EXPECT_EQ(turned->width_mm, 100);
    for (auto const does : { Does::Size, Does::Turn })
        EXPECT_FALSE(place_after(does, stroke_through({ { 10, 21, 0 }, { 10, 60, 0 } }), scene))
            << "begins at the middle";
}

TEST(PictureTool, LeavesALockedPictureWhereItLies)
{
    auto const scene = with_picture();
    auto const locked
        = scene::apply_edits(scene,
                             tools::Tool(PictureTool { Does::Lock }).edits_for({}, scene).value())
              .value();
    ASSERT_TRUE(locked.state.picture->place.is_locked);
    auto const moved
        = place_after(Does::Move, stroke_through({ { 0, 0, 0 }, { 9, 9, 0 } }), locked);
    ASSERT_FALSE(moved);
    EXPECT_NE(moved.error().message.find("locked"), std::string::npos);
    EXPECT_FALSE(place_after(Does::Lock, {}, locked).value().is_locked);
}

TEST(PictureTool, RefusesWhereThereIsNoPicture)
{
    for (auto const does : { Does::Move, Does::Lock, Does::Remove })
        EXPECT_FALSE(tools::Tool(PictureTool { does })
                         .edits_for(stroke_through({ { 0, 0, 0 }, { 9, 9, 0 } }), small_scene()));
    auto const edits
        = tools::Tool(PictureTool { Does::Remove }).edits_for({}, with_picture()).value();
    EXPECT_EQ(scene::apply_edits(with_picture(), edits).value().state.picture, nullptr);
}

TEST(PictureTool, SetsItsStrengthWhereItLies)
{
    auto const follow = PictureTool::kKind.follow;
    auto const scene = with_picture({ .is_locked = true });
    auto const edits = follow(PictureTool {}, PictureTool { .strength_percent = 80 }, scene);
    ASSERT_EQ(edits.size(), 1u);
    auto const place = scene::apply_edits(scene, edits).value().state.picture->place;
    EXPECT_EQ(place, (scene::PicturePlace { .strength = 0.8, .is_locked = true }));
    EXPECT_TRUE(follow(PictureTool {}, PictureTool {}, scene).empty()) << "it has that strength";
    EXPECT_TRUE(follow(PictureTool {}, PictureTool { .strength_percent = 80 }, {}).empty());
}

TEST(PictureEdits, RefuseWhatCannotBe)
{
    auto const nan = std::numeric_limits<double>::quiet_NaN();
    for (auto const& place :
         { scene::PicturePlace { .width_mm = 0 }, scene::PicturePlace { .width_mm = nan },
           scene::PicturePlace { .x_mm = 1e9 }, scene::PicturePlace { .turn_deg = nan },
           scene::PicturePlace { .strength = 0 }, scene::PicturePlace { .strength = nan } }) {
        EXPECT_FALSE(scene::apply_edit(with_picture(), scene::PlacePicture { place }));
        EXPECT_FALSE(scene::apply_edit({}, scene::LayPicture { "oak.png", small_png(), place }));
    }
    auto const text = scene::apply_edit({}, scene::LayPicture { "oak.txt", "an oak" });
    ASSERT_FALSE(text);
    EXPECT_EQ(text.error().message, "oak.txt is neither a PNG nor a JPEG picture");
    EXPECT_FALSE(scene::apply_edit({}, scene::PlacePicture {}));
    EXPECT_FALSE(scene::apply_edit({}, scene::RemovePicture {}));
    EXPECT_TRUE(
        scene::apply_edit({}, scene::LayPicture { "oak.png", small_png() }).value().plants.empty())
        << "before there is a plant";
}

// A picture's bytes must be stored in EditRecord::numbers: as text in its JSON `fields` they would
// take about half as much space again.
TEST(PictureEdits, KeepTheFileAsItIs)
{
    auto const png = small_png();
    auto const record = session::record_of(scene::LayPicture { "oak.png", png });
    EXPECT_EQ(record.numbers, png);
    EXPECT_LT(record.fields.size(), 200u);
    auto const edit = session::edit_of(record, scene::core_edit_kinds()).value();
    EXPECT_EQ(edit.get<scene::LayPicture>()->file, png);
}

// While the stroke is in progress, the picture must be shown at its resulting position. If the
// stroke is refused, the picture must return to its old position.
TEST(PictureTool, ShowsTheOutcomeWhileThePenMoves)
{
    auto station = station_on(with_picture(), PictureTool {});
    view::StationView view(station, station.document());
    view.show(station, station.document());
    view.settle();
    ASSERT_TRUE(view.state().picture);
    EXPECT_EQ(view.state().picture->image->width(), 40);
    auto const plants = view.state().plant_revision;
    for (int i = 0; i < 10; ++i)
        station.push(kPen, at_ms(5 * i), pen_report(50 + 5 * i, 50, true));
    view.show(station, station.document());
    view.settle();
    EXPECT_NEAR(view.state().picture->place.x_mm, 45, 3);
    EXPECT_EQ(station.document().newest()->scene.state.picture->place.x_mm, 0) << "not drawn yet";
    station.push(kPen, at_ms(60), pen_report(110, 50, false));
    view.show(station, station.document());
    view.settle();
    auto const drawn_mm = station.document().newest()->scene.state.picture->place.x_mm;
    EXPECT_NEAR(drawn_mm, 45, 3);
    EXPECT_EQ(view.state().picture->place.x_mm, drawn_mm);
    EXPECT_LE(view.state().plant_revision, plants + 1) << "the plant is not grown at each move";
}

TEST(PictureTool, GivesALockedPictureBack)
{
    auto station = station_on(with_picture({ .is_locked = true }), PictureTool {});
    view::StationView view(station, station.document());
    view.show(station, station.document());
    view.settle();
    for (int i = 0; i < 10; ++i)
        station.push(kPen, at_ms(5 * i), pen_report(50 + 5 * i, 50, true));
    view.show(station, station.document());
    view.settle();
    EXPECT_EQ(view.state().picture->place.x_mm, 0);
}

} // namespace
} // namespace tractus::pictures
