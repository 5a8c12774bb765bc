#include "app/batch/session_plant.h"
#include "app/controllers/station_controller.h"
#include "app/view/ink_line.h"
#include "tests/app/document/step_of.h"
#include "tests/app/flat_station.h"
#include "tests/app/full_disk.h"
#include "tests/app/session/same_edit.h"
#include "tests/engine/scene/edits.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fmt/core.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace tractus::controllers {
namespace {

namespace fs = std::filesystem;

// Fixture with a session of many strokes, as if a hand had drawn for hours.
class LongDrawing : public testing::Test {
protected:
    LongDrawing()
        : controller_(station_, session_at(path_), {}, ".")
    {
    }
    ~LongDrawing() override { fs::remove(path_); }

    // Draws strokes, each for the next branch, until all of them are shown. Most strokes end within
    // a frame of the beginning of the next one.
    void draw(std::size_t strokes)
    {
        for (std::size_t i = 0; i < strokes; ++i, now_ms_ += 1000) {
            draw_across(station_, now_ms_);
            controller_.show(station_, at_ms(now_ms_));
            controller_.settle(station_, at_ms(now_ms_));
        }
    }

    // Returns the scene that is shown.
    scene::Scene const& scene() const { return *controller_.view().grown_scene(); }

    fs::path const path_ = fs::temp_directory_path()
        / fmt::format("tractus_long_{}_{}.tractus", ::getpid(),
                      testing::UnitTest::GetInstance()->current_test_info()->name());
    std::int64_t now_ms_ = 1000;
    station::Station station_ = flat_station();
    StationController controller_;

private:
    static session::Session session_at(fs::path const& path)
    {
        fs::remove(path);
        return batch::begin_session(path, { small_model() }, scene::core_edit_kinds()).value();
    }
};

std::ptrdiff_t strokes_in_memory(scene::Scene const& scene)
{
    return std::count_if(scene.associations.begin(), scene.associations.end(),
                         [](auto const& drawn) { return drawn.what.stroke.tips.is_in_memory(); });
}

bool is_ink_of(Stroke const& stroke, view::InkLine const& shown)
{
    auto const ink = view::thinned(view::ink_line(stroke.tips.in_memory().value(), {}));
    return std::equal(ink.points.begin(), ink.points.end(), shown.points.begin(),
                      shown.points.end(),
                      [](view::InkLine::Point const& a, view::InkLine::Point const& b) {
                          return a.position_mm == b.position_mm && a.width_mm == b.width_mm;
                      });
}

TEST_F(LongDrawing, LeavesWhatIsKeptToTheFile)
{
    constexpr std::size_t kStrokes = 150;
    draw(kStrokes);
    EXPECT_EQ(station_.counts().strokes, kStrokes);
    EXPECT_EQ(strokes_in_memory(controller_.document().session().scene()), 0);
    EXPECT_EQ(strokes_in_memory(scene()), 0);
    EXPECT_EQ(scene().associations.size(), kStrokes);
    EXPECT_EQ(session::read_session(path_, scene::core_edit_kinds()).value().last_step(), kStrokes)
        << "no lost edit";
}

TEST_F(LongDrawing, ReadsStrokesBackThatCountAgain)
{
    draw(1);
    Stroke const first { scene().associations[0].what.stroke.tips.vector() };
    // The plant has three branches, so strokes 3 and 6 shape the trunk again, as stroke 0 did.
    draw(6);
    EXPECT_FALSE(scene().associations[0].what.stroke.tips.is_in_memory());
    controller_.document().make(
        document::step_of({ scene::DeleteStroke { scene::numbered({ 3, 6 }) } }));
    controller_.settle(station_, at_ms(now_ms_));
    ASSERT_EQ(scene().associations.size(), 5u);
    auto const& shown = controller_.view().state().strokes;
    ASSERT_EQ(shown.size(), 3u);
    EXPECT_TRUE(is_ink_of(first, shown[0]));
    EXPECT_TRUE(session::same(scene().associations[0].what.stroke, first));
}

TEST_F(LongDrawing, ReadsAStrokeBackThatWasErasedInPart)
{
    auto const make = [&](scene::Edit const& edit) {
        controller_.document().make(document::step_of({ edit }));
        controller_.settle(station_, at_ms(now_ms_));
    };
    draw(1);
    auto const count = scene().associations[0].what.stroke.tips.size();
    make(scene::EraseTips { scene::numbered({ 0 }), { { 3, 5 } } });
    make(scene::EraseTips { scene::numbered({ 0 }), { { 0, 0 } } });
    Stroke const rest { scene().associations[0].what.stroke.tips.vector() };
    EXPECT_EQ(rest.tips.size(), count - 4);
    // The plant has three branches, so strokes 3 and 6 shape the trunk again, as stroke 0 did.
    draw(6);
    EXPECT_FALSE(scene().associations[0].what.stroke.tips.is_in_memory());
    make(scene::DeleteStroke { scene::numbered({ 3, 6 }) });
    ASSERT_EQ(controller_.view().state().strokes.size(), 3u);
    EXPECT_TRUE(is_ink_of(rest, controller_.view().state().strokes[0]));
    EXPECT_TRUE(session::same(scene().associations[0].what.stroke, rest));
}

TEST_F(LongDrawing, ShowsInkUntilTheStrokeIsInThePlant)
{
    draw_across(station_, now_ms_);
    controller_.show(station_, at_ms(now_ms_));
    auto const& state = controller_.view().state();
    EXPECT_GE(state.live_ink.size() + state.strokes.size(), 1u) << "it is seen all the time";
    // The second stroke may end before the first one is saved.
    draw_across(station_, now_ms_ + 1000);
    controller_.show(station_, at_ms(now_ms_));
    EXPECT_GE(state.live_ink.size() + state.strokes.size(), 2u);
    controller_.settle(station_, at_ms(now_ms_ + 2000));
    EXPECT_EQ(session::read_session(path_, scene::core_edit_kinds()).value().last_step(), 2u);
    EXPECT_EQ(state.strokes.size(), 2u);
    EXPECT_TRUE(state.live_ink.empty());
    EXPECT_EQ(state.unsaved_steps, 0u);
}

TEST_F(LongDrawing, ANewStationLosesNothingThatAFullDiskCouldNotKeep)
{
    draw(1);
    {
        FullDisk const disk(1);
        draw(1);
        EXPECT_EQ(controller_.view().state().unsaved_steps, 1u);
        EXPECT_NE(controller_.view().state().trouble.find("is not kept"), std::string::npos);
        station_ = flat_station(); // Recalibrating also creates a new station.
        controller_.show_again(station_, "");
        draw(1);
        EXPECT_FALSE(controller_.finish(station_, at_ms(now_ms_)));
        EXPECT_EQ(scene().associations.size(), 3u);
    }
    ASSERT_TRUE(controller_.finish(station_, at_ms(now_ms_)));
    EXPECT_EQ(controller_.view().state().unsaved_steps, 0u);
    EXPECT_EQ(session::read_session(path_, scene::core_edit_kinds()).value().last_step(), 3u);
}

TEST_F(LongDrawing, ShowsAndGrowsWhatStillCounts)
{
    draw(30);
    EXPECT_EQ(controller_.view().state().strokes.size(), 3u)
        << "one for each of the three branches";
    EXPECT_EQ(scene::shaping_associations(scene()).size(), 3u);
    controller_.perform(view::Undo {}, station_);
    controller_.settle(station_, at_ms(now_ms_));
    EXPECT_EQ(scene().associations.size(), 29u);
    EXPECT_EQ(controller_.view().state().strokes.size(), 3u) << "the one before counts again";
}

TEST_F(LongDrawing, TakesBackEveryStepAndDoesItAgain)
{
    constexpr std::size_t kStrokes = 210; // More steps than the number of scenes that are kept.
    draw(kStrokes);
    for (std::size_t left = kStrokes; left-- > 0;) {
        controller_.perform(view::Undo {}, station_);
        controller_.settle(station_, at_ms(now_ms_));
        ASSERT_EQ(scene().associations.size(), left);
    }
    for (std::size_t i = 0; i < kStrokes; ++i)
        controller_.perform(view::Redo {}, station_);
    ASSERT_TRUE(controller_.finish(station_, at_ms(now_ms_)));
    EXPECT_EQ(scene().associations.size(), kStrokes);
}

} // namespace
} // namespace tractus::controllers
