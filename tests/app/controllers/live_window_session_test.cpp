#include "app/batch/session_plant.h"
#include "app/controllers/recent_drawings.h"
#include "tests/app/controllers/live_window_devices.h"

#include <cstdlib>
#include <filesystem>
#include <fmt/core.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace tractus::controllers {
namespace {

namespace fs = std::filesystem;

// Returns options for a window whose session is continued if the file exists.
LiveWindowOptions options_with_session(fs::path const& path)
{
    auto options = live_options();
    options.session = fs::exists(path)
        ? session::Session::open(
              path,
              session::session_by_the_clock(methods::all_methods().edits,
                                            [] { return scene::LoadOptions {}; }))
              .value()
        : batch::begin_session(path, { small_model() }, methods::all_methods().edits).value();
    return options;
}

TEST(LiveWindow, KeepsEveryStrokeInASessionThatCanBeUndone)
{
    auto const path = fs::temp_directory_path() / fmt::format("tractus_{}.tractus", ::getpid());
    fs::remove(path);
    {
        auto window
            = LiveWindow::create(drawing_devices(false), options_with_session(path)).value();
        advance_to_end(window);
        window.settle();
        EXPECT_EQ(session::read_session(path, methods::all_methods().edits).value().step,
                  1u); // The session can be read while the window is open.
        window.perform(view::Undo {});
        window.settle();
        EXPECT_TRUE(window.state().strokes.empty());
        EXPECT_EQ(session::read_session(path, methods::all_methods().edits).value().step, 0u);
        window.perform(view::Undo {});
        window.settle();
        EXPECT_NE(window.state().status.find("nothing to undo"), std::string::npos);
        window.perform(view::Redo {});
        window.settle();
        EXPECT_EQ(window.state().strokes.size(), 1u);
        window.perform(view::Restart {});
        window.settle();
        EXPECT_TRUE(window.state().strokes.empty());
        window.perform(view::Undo {});
        window.settle();
        EXPECT_EQ(window.state().strokes.size(), 1u);
    }
    auto again = LiveWindow::create(drawing_devices(false), options_with_session(path)).value();
    EXPECT_EQ(again.state().strokes.size(), 1u);
    advance_to_end(again);
    again.settle();
    EXPECT_EQ(again.scene().associations.size(), 2u);
    EXPECT_EQ(session::read_session(path, methods::all_methods().edits).value().step, 2u);
    EXPECT_EQ(session::read_session(path, methods::all_methods().edits).value().last_step(),
              2u); // The second stroke replaces the step that was undone.
    fs::remove(path);
}

// Fixture with a window that keeps a session in a temporary file.
class LiveWindowWithSession : public testing::Test {
protected:
    LiveWindowWithSession() { fs::remove(path_); }
    ~LiveWindowWithSession() override { fs::remove(path_); }

    fs::path const path_
        = fs::temp_directory_path() / fmt::format("tractus_growth_{}.tractus", ::getpid());
};

// The copy must contain the stroke and the name, and be listed among the drawings. Drawing
// continues in the original file.
TEST_F(LiveWindowWithSession, NamesTheDrawingAndSavesCopies)
{
    auto const home = fs::temp_directory_path() / fmt::format("tractus_named_home_{}", ::getpid());
    ::setenv("XDG_DATA_HOME", home.c_str(), 1);
    {
        auto window
            = LiveWindow::create(drawing_devices(false), options_with_session(path_)).value();
        EXPECT_TRUE(window.state().drawing_name);
        advance_to_end(window);
        window.perform(view::NameDrawing { " Ash by the gate " });
        EXPECT_EQ(window.state().drawing_name, "Ash by the gate");
        EXPECT_EQ(window.state().title, "tractus: Ash by the gate");
        window.perform(view::SaveCopy { "oak/ash" });
        window.settle();
        EXPECT_NE(window.state().status.find("oak-ash"), std::string::npos);
        window.perform(view::NameDrawing { "" });
        EXPECT_NE(window.state().status.find("at least one letter"), std::string::npos);
        EXPECT_EQ(window.state().drawing_name, "Ash by the gate");
    }
    auto const drawings = recent_drawings(home / "tractus", 12, {});
    ASSERT_EQ(drawings.size(), 1u);
    EXPECT_EQ(drawings.front().name, "oak/ash");
    EXPECT_EQ(
        session::read_session(drawings.front().file, methods::all_methods().edits).value().step,
        1u);
    auto const again
        = LiveWindow::create(drawing_devices(false), options_with_session(path_)).value();
    EXPECT_EQ(again.state().drawing_name, "Ash by the gate");
    ::unsetenv("XDG_DATA_HOME");
    fs::remove_all(home);
}

// A drawing without a file cannot be named, so the window must not offer a name.
TEST(LiveWindow, HasNoNameWithoutAFile)
{
    auto window = LiveWindow::create(drawing_devices(false), live_options()).value();
    EXPECT_FALSE(window.state().drawing_name);
    window.perform(view::SaveCopy { "Ash" });
    EXPECT_NE(window.state().status.find("memory alone"), std::string::npos);
}

TEST_F(LiveWindowWithSession, KeepsGrowthAndTakesItBack)
{
    auto window = LiveWindow::create(drawing_devices(false), options_with_session(path_)).value();
    window.perform(view::ChangeGrowth { { "weeping", 0.5, 0.25 } });
    window.settle();
    EXPECT_EQ(window.state().growth.preset, "weeping");
    EXPECT_EQ(window.scene().growth.variability, 0.5);
    EXPECT_EQ(window.scene().growth.age, 0.25);
    window.perform(view::NextVariation {});
    window.settle();
    EXPECT_EQ(window.state().seed, 2u);
    EXPECT_EQ(window.state().growth.age, 0.25);
    auto const kept = session::read_session(path_, methods::all_methods().edits).value();
    EXPECT_EQ(kept.last_step(), 2u);
    EXPECT_EQ(kept.edits.back().edit.get<scene::SetGrowth>()->seed, 2u);
    window.perform(view::Undo {});
    window.settle();
    EXPECT_EQ(window.state().seed, 1u);
    window.perform(view::Undo {});
    window.settle();
    EXPECT_EQ(window.state().growth.preset, "usual");
    EXPECT_EQ(window.state().growth.age, 1);
}

TEST_F(LiveWindowWithSession, ShowsWhatASliderWouldGiveAndKeepsItWhenItIsReleased)
{
    using Slider = view::ChangeGrowth::Slider;
    auto window = LiveWindow::create(drawing_devices(false), options_with_session(path_)).value();
    window.settle();
    auto const triangles = window.state().plant->triangle_count();
    window.perform(view::ChangeGrowth { { "", 1, 0.3 }, Slider::Moving });
    EXPECT_TRUE(window.state().is_growing);
    // The old plant is shown until the new one is finished.
    EXPECT_EQ(window.state().plant->triangle_count(), triangles);
    window.settle();
    EXPECT_FALSE(window.state().is_growing);
    EXPECT_LT(window.state().plant->triangle_count(), triangles);
    EXPECT_EQ(window.state().growth.age, 0.3);
    EXPECT_EQ(session::read_session(path_, methods::all_methods().edits).value().last_step(), 0u);
    window.perform(view::ChangeGrowth { { "", 1, 0.2 }, Slider::Released });
    window.settle();
    EXPECT_EQ(session::read_session(path_, methods::all_methods().edits).value().last_step(), 1u);
}

TEST_F(LiveWindowWithSession, ShowsASeasonAndTakesItBack)
{
    using Slider = view::ChangeGrowth::Slider;
    auto leafy = small_model();
    leafy.source.text.replace(leafy.source.text.find("]"), 1, "~l(1)]");
    leafy.source.view_text = "material: 2 leaf kind=leaf color=0.2,0.5,0.2\n"
                             "organ: l leaf kind=blade material=2 length=10 width=5\n";
    auto options = live_options();
    options.session = batch::begin_session(path_, { leafy }, methods::all_methods().edits).value();
    auto window = LiveWindow::create(drawing_devices(false), std::move(options)).value();
    window.settle();
    auto const triangles = window.state().plant->triangle_count();
    scene::Season const winter { .month = 1.5, .fallen = 0 };
    window.perform(view::ChangeSeason { winter, Slider::Moving });
    window.settle();
    EXPECT_LT(window.state().plant->triangle_count(), triangles);
    EXPECT_EQ(session::read_session(path_, methods::all_methods().edits).value().last_step(), 0u);
    window.perform(view::ChangeSeason { winter });
    window.settle();
    EXPECT_LT(window.state().plant->triangle_count(), triangles);
    EXPECT_EQ(window.state().season, winter);
    EXPECT_EQ(window.state().status, "It is mid-January");
    EXPECT_EQ(session::read_session(path_, methods::all_methods().edits).value().last_step(), 1u);
    window.perform(view::Undo {});
    window.settle();
    EXPECT_EQ(window.state().plant->triangle_count(), triangles);
    EXPECT_FALSE(window.state().season);
}

TEST_F(LiveWindowWithSession, MakesAVariationThePlant)
{
    auto window = LiveWindow::create(drawing_devices(false), options_with_session(path_)).value();
    window.perform(view::RequestCollection { 4 });
    window.settle();
    ASSERT_EQ(window.state().collection.size(), 4u);
    window.perform(view::PickVariation { window.state().collection[2].seed });
    window.settle();
    EXPECT_EQ(window.state().seed, 3u);
    EXPECT_EQ(window.state().collection.size(), 4u) << "to pick another";
    window.perform(view::Undo {});
    window.settle();
    EXPECT_EQ(window.state().seed, 1u);
}

TEST_F(LiveWindowWithSession, RefusesGrowthThatThereIsNot)
{
    auto window = LiveWindow::create(drawing_devices(false), options_with_session(path_)).value();
    window.perform(view::ChangeGrowth { { "upwards", 1, 1 } });
    window.settle();
    EXPECT_NE(window.state().status.find("cannot grow \"upwards\""), std::string::npos);
    window.perform(view::ChangeGrowth { { "", 5, 1 } });
    window.settle();
    EXPECT_NE(window.state().status.find("as it likes"), std::string::npos);
    window.perform(view::ChangeGrowth { { "", 1, -1 } });
    window.settle();
    EXPECT_NE(window.state().status.find("full-grown"), std::string::npos);
    // The window shows the age in effect, not the one asked for.
    EXPECT_EQ(window.state().growth.age, 1);
    EXPECT_EQ(session::read_session(path_, methods::all_methods().edits).value().last_step(), 0u);
}

} // namespace
} // namespace tractus::controllers
