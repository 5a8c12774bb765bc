#include "app/controllers/replay_window.h"
#include "app/methods/all_methods.h"

#include "app/batch/session_plant.h"
#include "tests/app/simulated_drawing.h"

#include <filesystem>
#include <fmt/core.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace tractus::controllers {
namespace {

namespace fs = std::filesystem;

class ReplayedWindow : public testing::Test {
protected:
    ReplayWindow open(fs::path const& pictures = ".") const
    {
        auto window = ReplayWindow::create(log_, { .methods = methods::all_methods() },
                                           small_scene(), pictures)
                          .value();
        window.settle();
        return window;
    }

    // Plays the recording to its end at normal speed, and calls `seen` for each frame.
    template<typename Seen> static void play(ReplayWindow& window, Seen const& seen)
    {
        for (int frame = 0; frame < 10'000 && window.state().playing; ++frame) {
            window.advance(std::chrono::milliseconds(33));
            window.settle();
            seen(window.state());
        }
    }

    static void play(ReplayWindow& window)
    {
        play(window, [](view::WindowState const&) {});
    }

    drivers::Log log_ = recorded_log();
};

TEST_F(ReplayedWindow, BeginsWithThePlantAsItIs)
{
    auto const window = open();
    ASSERT_NE(window.state().plant, nullptr);
    EXPECT_GT(window.state().plant->triangle_count(), 0u);
    EXPECT_TRUE(window.state().strokes.empty());
    EXPECT_EQ(window.state().skeleton.size(), 3u);
    EXPECT_TRUE(window.state().playing);
    EXPECT_EQ(window.state().progress, 0);
}

TEST_F(ReplayedWindow, ShowsInkThenStrokesAndChangesThePlantAfterEach)
{
    auto window = open();
    bool has_shown_ink = false;
    auto plants = window.state().plant_revision;
    auto const before = plants;
    std::size_t strokes = 0;
    play(window, [&](view::WindowState const& state) {
        has_shown_ink |= !state.live_ink.empty() && state.pen.touching;
        if (state.strokes.size() != strokes) {
            EXPECT_GT(state.plant_revision, plants);
        }
        strokes = state.strokes.size();
        plants = state.plant_revision;
    });
    EXPECT_TRUE(has_shown_ink);
    EXPECT_EQ(window.state().strokes.size(), 1u); // Strokes that select a branch are not shown.
    EXPECT_EQ(window.state().plant_revision, before + 3);
    EXPECT_EQ(window.state().layers.size(), 1u);
    EXPECT_EQ(window.state().progress, 1);
    EXPECT_FALSE(window.state().playing);
}

TEST_F(ReplayedWindow, ColoursTheBranchThatIsSelectedAndThenAssigned)
{
    auto window = open();
    bool was_selected = false;
    play(window, [&](view::WindowState const& state) {
        was_selected |= state.skeleton.front().state == tools::SkeletonLine::State::Selected;
    });
    EXPECT_TRUE(was_selected);
}

TEST_F(ReplayedWindow, StandsStillWhilePaused)
{
    auto window = open();
    window.advance(std::chrono::milliseconds(500));
    window.perform(view::SetPlaying { false });
    auto const progress = window.state().progress;
    window.advance(std::chrono::seconds(1));
    EXPECT_EQ(window.state().progress, progress);
    window.perform(view::SetPlaying { true });
    window.advance(std::chrono::milliseconds(100));
    EXPECT_GT(window.state().progress, progress);
}

TEST_F(ReplayedWindow, KeepsTheSpeedWithinItsLimits)
{
    auto window = open();
    window.perform(view::SetSpeed { 100 });
    EXPECT_EQ(window.state().speed, 4);
    window.perform(view::SetSpeed { 0 });
    EXPECT_EQ(window.state().speed, 0.25);
}

TEST_F(ReplayedWindow, PlaysAgainFromTheBeginning)
{
    auto window = open();
    play(window);
    window.perform(view::Restart {});
    EXPECT_TRUE(window.state().playing);
    EXPECT_EQ(window.state().progress, 0);
    window.settle();
    EXPECT_TRUE(window.state().strokes.empty());
    EXPECT_TRUE(window.state().layers.empty());
    EXPECT_EQ(window.state().status, "The hand begins again");
    play(window);
    EXPECT_EQ(window.state().strokes.size(), 1u);
    // At the end of the recording, playing starts again from the beginning.
    window.perform(view::SetPlaying { true });
    window.settle();
    EXPECT_TRUE(window.state().strokes.empty());
}

TEST_F(ReplayedWindow, ShowsAnotherPlantForTheNextSeed)
{
    auto window = open();
    play(window);
    auto const before = window.state().plant_revision;
    auto const seed = window.state().seed;
    window.perform(view::NextVariation {});
    window.settle();
    EXPECT_EQ(window.state().plant_revision, before + 1);
    EXPECT_EQ(window.state().seed, seed + 1);
}

TEST_F(ReplayedWindow, KeepsWhatIsDrawnInASession)
{
    auto const path
        = fs::temp_directory_path() / fmt::format("tractus_replay_{}.tractus", ::getpid());
    fs::remove(path);
    auto window
        = ReplayWindow::create(
              log_, { .methods = methods::all_methods() }, {}, ".",
              batch::begin_session(path, { small_model() }, methods::all_methods().edits).value())
              .value();
    play(window);
    EXPECT_EQ(session::read_session(path, methods::all_methods().edits)->last_step(),
              3u); // The step that selects a branch is counted, too.
    EXPECT_EQ(window.state().layers.size(), 1u);
    window.perform(view::Undo {});
    window.settle();
    EXPECT_TRUE(window.state().layers.empty());
    window.perform(view::Restart {});
    window.settle();
    EXPECT_TRUE(window.state().strokes.empty());
    play(window);
    EXPECT_EQ(window.state().strokes.size(), 1u);
    EXPECT_EQ(session::read_session(path, methods::all_methods().edits)->last_step(), 6u)
        << "beginning again is a step in place of undone ones";
    fs::remove(path);
}

TEST_F(ReplayedWindow, SavesAPictureUnderANameOfItsOwn)
{
    auto const folder
        = fs::temp_directory_path() / ("tractus_window_test_" + std::to_string(::getpid()));
    fs::create_directories(folder);
    auto window = open(folder);
    window.perform(view::SavePicture { render::Image(4, 3) });
    window.settle();
    ASSERT_EQ(std::distance(fs::directory_iterator(folder), {}), 1);
    auto const saved = fs::directory_iterator(folder)->path();
    EXPECT_EQ(saved.filename().string().rfind("small-", 0), 0u) << saved;
    EXPECT_EQ(saved.extension(), ".png");
    EXPECT_EQ(window.state().status, "Saved " + saved.string());
    fs::remove_all(folder);
}

TEST_F(ReplayedWindow, SaysWhyAPictureWasNotSaved)
{
    auto window = open("/proc/nowhere");
    window.perform(view::SavePicture { render::Image(4, 3) });
    window.settle();
    EXPECT_NE(window.state().status.find("cannot make the folder /proc/nowhere"),
              std::string::npos);
}

} // namespace
} // namespace tractus::controllers
