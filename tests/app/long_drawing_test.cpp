#include "app/session_plant.h"
#include "app/station_desk.h"
#include "tests/app/simple_rig.h"

#include <filesystem>
#include <fmt/core.h>
#include <gtest/gtest.h>
#include <set>
#include <unistd.h>

namespace tractus {
namespace {

namespace fs = std::filesystem;

// A hand that has drawn for hours, and a session that keeps it.
class LongDrawing : public testing::Test {
protected:
    LongDrawing()
        : station_(new_station())
        , desk_(station_, session_at(path_), ".")
    {
    }
    ~LongDrawing() override { fs::remove(path_); }

    // So many strokes, each for the next branch; every one is seen, and most of them end within a
    // frame of another's beginning.
    void draw(std::size_t strokes)
    {
        for (std::size_t i = 0; i < strokes; ++i, now_ms_ += 1000) {
            draw_across(station_, now_ms_);
            desk_.show(station_, at_ms(now_ms_));
        }
    }

    fs::path const path_
        = fs::temp_directory_path() / fmt::format("tractus_long_{}.tractus", ::getpid());
    std::int64_t now_ms_ = 1000;
    Station station_;
    StationDesk desk_;

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

void add_places(std::set<void const*>& places, std::vector<Association> const& associations)
{
    for (auto const& association : associations)
        places.insert(association.stroke.tips.data());
}

TEST_F(LongDrawing, HoldsEachStrokeOnceHoweverOftenItIsCopied)
{
    constexpr std::size_t kStrokes = 150;
    draw(kStrokes);
    EXPECT_TRUE(station_.strokes().empty());
    EXPECT_EQ(station_.counts().strokes, kStrokes);
    std::set<void const*> places;
    auto const& session = desk_.keeper().session();
    add_places(places, session.scene().associations);
    add_places(places, station_.scene().associations);
    for (auto const& [step, edit, made] : session.contents().edits)
        if (auto const* const associate = std::get_if<Associate>(&edit))
            places.insert(associate->stroke.tips.data());
    EXPECT_EQ(places.size(), kStrokes);
    EXPECT_EQ(station_.scene().associations.size(), kStrokes);
    EXPECT_EQ(read_session(path_).value().last_step(), kStrokes) << "no lost edit";
}

TEST_F(LongDrawing, ShowsAndGrowsWhatStillCounts)
{
    draw(30);
    EXPECT_EQ(desk_.view().state().strokes.size(), 3u) << "one for each of the three branches";
    EXPECT_EQ(shaping_associations(station_.scene()).size(), 3u);
    desk_.perform(Undo {}, station_);
    EXPECT_EQ(station_.scene().associations.size(), 29u);
    EXPECT_EQ(desk_.view().state().strokes.size(), 3u) << "the one before counts again";
}

TEST_F(LongDrawing, TakesBackEveryStepAndDoesItAgain)
{
    constexpr std::size_t kStrokes = 210; // Farther than scenes are kept.
    draw(kStrokes);
    for (std::size_t left = kStrokes; left-- > 0;) {
        desk_.perform(Undo {}, station_);
        ASSERT_EQ(station_.scene().associations.size(), left);
    }
    for (std::size_t i = 0; i < kStrokes; ++i)
        desk_.perform(Redo {}, station_);
    EXPECT_EQ(station_.scene().associations.size(), kStrokes);
}

} // namespace
} // namespace tractus
