#include "app/batch/drawing.h"
#include "app/batch/session_plant.h"
#include "app/controllers/station_controller.h"
#include "app/methods/all_methods.h"
#include "app/station/log_replay.h"
#include "tests/app/session/killed_child.h"
#include "tests/app/session/same_edit.h"
#include "tests/app/simulated_drawing.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fmt/core.h>
#include <fstream>
#include <gtest/gtest.h>
#include <random>
#include <thread>
#include <unistd.h>
#include <utility>
#include <vector>

namespace tractus::session {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr int kStrokes = 12;

// Returns a script of kStrokes gestures: the first selects the trunk, the others shape it with
// strokes or lean the plant.
std::string many_strokes()
{
    std::string script = "version = 1\nseed = 3\n"
                         "[[gesture]]\ntool = \"select\"\ntrace = \"axis\"\naxis = 0\n";
    for (int i = 1; i < kStrokes; ++i)
        script += fmt::format("[[gesture]]\ntool = {}\npath = \"line\"\n"
                              "from_mm = [{}, 0, 50]\nto_mm = [40, {}, 120]\n",
                              i % 4 == 3 ? "\"indicate\"" : "\"draw\"\npropagation = \"both\"", i,
                              i + 3);
    return script;
}

// Fixture for killing the program repeatedly while a hand draws. The drawing comes from a recording
// and is kept in a session by the station's controller.
class KilledDrawing : public testing::Test {
protected:
    void SetUp() override
    {
        fs::remove_all(folder_);
        fs::create_directories(folder_);
        auto const write_log = [&](Say const& say) {
            auto const text = recorded(many_strokes());
            std::ofstream(log(), std::ios::binary) << (text ? *text : text.error().message);
            std::ofstream(folder_ / "small.l") << small_model().source.text;
            say(text.has_value());
        };
        ASSERT_EQ(last_said(write_log, kForever), 1);
    }

    void TearDown() override { fs::remove_all(folder_); }

    // Draws frame by frame like the program, but as fast as possible. Reports the number of
    // finished strokes whenever it has increased and all of them are saved.
    void draw_into(fs::path const& path, Say const& say) const
    {
        constexpr Duration kFrame = std::chrono::milliseconds(16);
        auto const edits = batch::growing_plant_edits({ folder_ / "small.l", {} }, {}, 1).value();
        auto session = batch::begin_session(path, edits, methods::all_methods().edits).value();
        auto const log = drivers::read_log(this->log()).value();
        auto replay
            = station::LogReplay::create(log, { .methods = methods::all_methods() }).value();
        auto& station = replay.station();
        controllers::StationController controller(station, std::move(session), {}, folder_);
        int done = -1;
        auto const say_done = [&] {
            auto const strokes = static_cast<int>(station.counts().strokes);
            if (controller.document().is_settled() && controller.view().state().unsaved_steps == 0
                && strokes > done)
                say(done = strokes);
        };
        auto now = replay.begin();
        for (bool goes_on = true; goes_on; now += kFrame) {
            goes_on = replay.advance_to(now);
            controller.show(station, now);
            say_done();
            if (!controller.document().is_settled()) // The wait is shorter than a real frame.
                std::this_thread::sleep_for(std::chrono::microseconds(100));
        }
        // The parent may also kill the process during this call.
        static_cast<void>(controller.finish(station, now));
        say_done();
    }

    // Opens the session to continue the drawing, and reports the number of its strokes: one that
    // selects, and those that shape the trunk or lean the plant.
    static void open_and_count(fs::path const& path, Say const& say)
    {
        auto session = Session::open(path, session_by_the_clock(methods::all_methods().edits, [] {
                                         return scene::LoadOptions {};
                                     }));
        if (!session)
            return;
        auto const& scene = session->scene();
        auto const drawn = scene.associations.size() + scene.indicators.size();
        auto const steps = session->step();
        if (drawn + scene.selection.size() == steps
            && session->append(std::vector<scene::Edit> { scene::Select {} }))
            say(static_cast<int>(steps));
    }

    // True if the contents are the first steps of the whole drawing, complete and unchanged.
    static bool is_beginning_of(std::vector<SessionEdit> const& whole,
                                SessionContents const& contents)
    {
        auto const& edits = contents.edits;
        auto const same_edit = [](SessionEdit const& one, SessionEdit const& other) {
            return one.step == other.step && same(one.edit, other.edit);
        };
        return edits.size() <= whole.size()
            && std::equal(edits.begin(), edits.end(), whole.begin(), same_edit)
            && (edits.size() == whole.size() || whole[edits.size()].step > contents.step);
    }

    fs::path log() const { return folder_ / "hand.tractus-log"; }
    fs::path session() const { return folder_ / "drawn.tractus"; }

    void remove_session() const
    {
        for (auto const& entry : fs::directory_iterator(folder_))
            if (entry.path().string().find(".tractus") != std::string::npos
                && entry.path() != log())
                fs::remove(entry.path());
    }

private:
    fs::path folder_ = fs::temp_directory_path() / fmt::format("tractus_killed_{}", ::getpid());
};

TEST_F(KilledDrawing, LosesNoFinishedStrokeAndOpensAgain)
{
    auto const draw = [&](Say const& say) { draw_into(session(), say); };
    auto const begin = Clock::now();
    ASSERT_EQ(last_said(draw, kForever), kStrokes);
    auto const whole_us
        = std::chrono::duration_cast<std::chrono::microseconds>(Clock::now() - begin).count();
    auto const whole = read_session(session(), methods::all_methods().edits).value().edits;
    ASSERT_EQ(whole.back().step, static_cast<std::size_t>(kStrokes));

    std::mt19937_64 random(7);
    int in_the_middle = 0;
    for (int i = 0; i < 100; ++i) {
        remove_session();
        auto const done = last_said(
            draw, std::chrono::microseconds(random() % static_cast<std::uint64_t>(whole_us)));
        SCOPED_TRACE(fmt::format("{} strokes were done when it was killed", done));
        if (done < 0 && !fs::exists(session()))
            continue; // The drawing had not begun, so there must be no incomplete session file.
        auto const contents = read_session(session(), methods::all_methods().edits);
        ASSERT_TRUE(contents) << contents.error().message;
        // The session may contain more steps than were reported before the process was killed.
        auto const steps = static_cast<int>(contents->step);
        EXPECT_GE(steps, done);
        EXPECT_EQ(contents->last_step(), contents->step);
        EXPECT_TRUE(is_beginning_of(whole, *contents));
        auto const count = [&](Say const& say) { open_and_count(session(), say); };
        EXPECT_EQ(last_said(count, kForever), steps);
        in_the_middle += done > 0 && done < kStrokes;
    }
    RecordProperty("killed_while_drawing", in_the_middle);
    RecordProperty("whole_us", static_cast<int>(whole_us));
}

} // namespace
} // namespace tractus::session
