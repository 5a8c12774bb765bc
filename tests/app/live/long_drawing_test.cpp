#include "app/live/station_controller.h"
#include "app/plants/session_plant.h"
#include "app/station/ink_line.h"
#include "tests/app/session/same_edit.h"
#include "tests/app/simple_rig.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fmt/core.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace tractus {
namespace {

namespace fs = std::filesystem;

// A hand that has drawn for hours, and a session that keeps it.
class LongDrawing : public testing::Test {
protected:
    LongDrawing()
        : station_(new_station())
        , controller_(station_, session_at(path_), ".")
    {
    }
    ~LongDrawing() override { fs::remove(path_); }

    // So many strokes, each for the next branch; every one is seen, and most of them end within a
    // frame of another's beginning.
    void draw(std::size_t strokes)
    {
        for (std::size_t i = 0; i < strokes; ++i, now_ms_ += 1000) {
            draw_across(station_, now_ms_);
            controller_.show(station_, at_ms(now_ms_));
            controller_.settle(station_, at_ms(now_ms_));
        }
    }

    fs::path const path_
        = fs::temp_directory_path() / fmt::format("tractus_long_{}.tractus", ::getpid());
    std::int64_t now_ms_ = 1000;
    Station station_;
    StationController controller_;

private:
    static Session session_at(fs::path const& path)
    {
        fs::remove(path);
        return begin_session(path, { small_model() }).value();
    }

    static Station new_station()
    {
        StationOptions options;
        options.scripted_height = ScriptedHeight {
            .scenario = { .kind = HeightScenario::Kind::Constant, .constant_mm = 100 },
            .first_pen = {},
            .last_pen = {},
        };
        options.scene = small_scene();
        return Station::create(std::vector { simple_pen() }, options).value();
    }
};

std::ptrdiff_t strokes_in_memory(Scene const& scene)
{
    return std::count_if(
        scene.associations.begin(), scene.associations.end(),
        [](Association const& association) { return association.stroke.tips.is_in_memory(); });
}

bool is_ink_of(Stroke const& stroke, InkLine const& shown)
{
    auto const ink = thinned(ink_line(stroke.tips.in_memory().value(), {}));
    return std::equal(ink.points.begin(), ink.points.end(), shown.points.begin(),
                      shown.points.end(), [](InkLine::Point const& a, InkLine::Point const& b) {
                          return a.position_mm == b.position_mm && a.width_mm == b.width_mm;
                      });
}

TEST_F(LongDrawing, LeavesWhatIsKeptToTheFile)
{
    constexpr std::size_t kStrokes = 150;
    draw(kStrokes);
    EXPECT_TRUE(station_.strokes().empty());
    EXPECT_EQ(station_.counts().strokes, kStrokes);
    EXPECT_EQ(strokes_in_memory(controller_.keeper().session().scene()), 0);
    EXPECT_EQ(strokes_in_memory(station_.scene()), 0);
    EXPECT_EQ(station_.scene().associations.size(), kStrokes);
    EXPECT_EQ(read_session(path_).value().last_step(), kStrokes) << "no lost edit";
}

TEST_F(LongDrawing, ReadsStrokesBackThatCountAgain)
{
    draw(1);
    Stroke const first { station_.scene().associations[0].stroke.tips.vector() };
    draw(6); // Three branches: numbers 3 and 6 are the trunk's, too.
    EXPECT_FALSE(station_.scene().associations[0].stroke.tips.is_in_memory());
    controller_.keeper().make({ [](Scene const&) -> Result<WantedStep::Change> {
        return WantedStep::Change { { DeleteStroke { { 3, 6 } } }, "" };
    } });
    controller_.settle(station_, at_ms(now_ms_));
    ASSERT_EQ(station_.scene().associations.size(), 5u);
    auto const& shown = controller_.view().state().strokes;
    ASSERT_EQ(shown.size(), 3u);
    EXPECT_TRUE(is_ink_of(first, shown[0]));
    EXPECT_TRUE(same(station_.scene().associations[0].stroke, first));
}

TEST_F(LongDrawing, ReadsAStrokeBackThatWasErasedInPart)
{
    auto const make = [&](Edit const& edit) {
        controller_.keeper().make({ [=](Scene const&) -> Result<WantedStep::Change> {
            return WantedStep::Change { { edit }, "" };
        } });
        controller_.settle(station_, at_ms(now_ms_));
    };
    draw(1);
    auto const count = station_.scene().associations[0].stroke.tips.size();
    make(EraseTips { { 0 }, { { 3, 5 } } });
    make(EraseTips { { 0 }, { { 0, 0 } } });
    Stroke const rest { station_.scene().associations[0].stroke.tips.vector() };
    EXPECT_EQ(rest.tips.size(), count - 4);
    draw(6); // Three branches: numbers 3 and 6 are the trunk's, too.
    EXPECT_FALSE(station_.scene().associations[0].stroke.tips.is_in_memory());
    make(DeleteStroke { { 3, 6 } });
    ASSERT_EQ(controller_.view().state().strokes.size(), 3u);
    EXPECT_TRUE(is_ink_of(rest, controller_.view().state().strokes[0]));
    EXPECT_TRUE(same(station_.scene().associations[0].stroke, rest));
}

TEST_F(LongDrawing, ShowsAStrokeAsDoneOnlyWhenItIsKept)
{
    draw_across(station_, now_ms_);
    controller_.show(station_, at_ms(now_ms_));
    EXPECT_FALSE(controller_.keeper().is_settled());
    EXPECT_TRUE(controller_.view().state().strokes.empty());
    EXPECT_EQ(controller_.view().state().live_ink.size(), 1u) << "the ink stays meanwhile";
    draw_across(station_, now_ms_ + 1000); // It ends before the first one is kept.
    EXPECT_EQ(station_.counts().strokes, 1u);
    controller_.settle(station_, at_ms(now_ms_ + 2000));
    EXPECT_EQ(read_session(path_).value().last_step(), 2u);
    EXPECT_EQ(controller_.view().state().strokes.size(), 2u);
    EXPECT_TRUE(controller_.view().state().live_ink.empty());
}

TEST_F(LongDrawing, ShowsAndGrowsWhatStillCounts)
{
    draw(30);
    EXPECT_EQ(controller_.view().state().strokes.size(), 3u)
        << "one for each of the three branches";
    EXPECT_EQ(shaping_associations(station_.scene()).size(), 3u);
    controller_.perform(Undo {}, station_);
    controller_.settle(station_, at_ms(now_ms_));
    EXPECT_EQ(station_.scene().associations.size(), 29u);
    EXPECT_EQ(controller_.view().state().strokes.size(), 3u) << "the one before counts again";
}

TEST_F(LongDrawing, TakesBackEveryStepAndDoesItAgain)
{
    constexpr std::size_t kStrokes = 210; // Farther than scenes are kept.
    draw(kStrokes);
    for (std::size_t left = kStrokes; left-- > 0;) {
        controller_.perform(Undo {}, station_);
        ASSERT_TRUE(controller_.finish(station_, at_ms(now_ms_)));
        ASSERT_EQ(station_.scene().associations.size(), left);
    }
    for (std::size_t i = 0; i < kStrokes; ++i)
        controller_.perform(Redo {}, station_);
    ASSERT_TRUE(controller_.finish(station_, at_ms(now_ms_)));
    EXPECT_EQ(station_.scene().associations.size(), kStrokes);
}

} // namespace
} // namespace tractus
