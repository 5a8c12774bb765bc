#include "app/batch/session_plant.h"
#include "tests/app/controllers/live_window_devices.h"
#include "tests/app/full_disk.h"

#include <filesystem>
#include <fmt/core.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace tractus::controllers {
namespace {

namespace fs = std::filesystem;

// Fixture with a window that saves its drawing in a new session. Its devices stop sending during a
// stroke, while the pen is down.
class LiveWindowClosing : public testing::Test {
protected:
    LiveWindowClosing() { fs::remove(path_); }
    ~LiveWindowClosing() override { fs::remove(path_); }

    LiveWindow drawing() const
    {
        std::vector<drivers::RawReport> reports;
        for (int i = 0; i < 20; ++i)
            reports.push_back(arrived(5 * i, pen_report(50 + 5 * i, 50, true)));
        std::vector<std::unique_ptr<drivers::ReportSource>> sources;
        sources.push_back(
            std::make_unique<ScriptedSource>(drivers::simple_pen(), std::move(reports)));
        auto options = live_options();
        options.session
            = batch::begin_session(path_, { small_model() }, methods::all_methods().edits).value();
        auto window = LiveWindow::create(devices::LiveDevices::start(std::move(sources)).value(),
                                         std::move(options))
                          .value();
        advance_to_end(window);
        EXPECT_FALSE(window.state().live_ink.empty());
        EXPECT_EQ(window.station().counts().strokes, 0u);
        return window;
    }
    std::size_t kept_steps() const
    {
        return session::read_session(path_, methods::all_methods().edits).value().last_step();
    }

    fs::path path_
        = fs::temp_directory_path() / fmt::format("tractus_closing_{}.tractus", ::getpid());
};

TEST_F(LiveWindowClosing, KeepsTheStrokeUnderWay)
{
    {
        auto window = drawing();
        EXPECT_EQ(kept_steps(), 0u);
        EXPECT_TRUE(window.close());
        EXPECT_EQ(kept_steps(), 1u);
    }
    EXPECT_EQ(kept_steps(), 1u) << "it closes once";
}

TEST_F(LiveWindowClosing, KeepsTheStrokeUnderWayWhenNobodyCloses)
{
    drawing();
    EXPECT_EQ(kept_steps(), 1u);
}

TEST_F(LiveWindowClosing, SaysWhatCannotBeKept)
{
    auto window = drawing();
    FullDisk const disk(1);
    auto const closed = window.close();
    ASSERT_FALSE(closed);
    EXPECT_NE(closed.error().message.find("the last stroke is not kept"), std::string::npos)
        << closed.error().message;
}

TEST_F(LiveWindowClosing, AsksOnceBeforeSomethingIsLost)
{
    auto window = drawing();
    {
        FullDisk const disk(1);
        EXPECT_FALSE(window.may_close());
        EXPECT_NE(window.state().status.find("close once more"), std::string::npos)
            << window.state().status;
        EXPECT_TRUE(window.may_close());
    }
    EXPECT_TRUE(window.close()) << "there is room again";
    EXPECT_EQ(kept_steps(), 1u);
}

TEST_F(LiveWindowClosing, SaysWhichStepCannotBeKept)
{
    auto window = drawing();
    ASSERT_TRUE(window.close());
    FullDisk const disk(1);
    window.perform(view::NextVariation {});
    EXPECT_FALSE(window.close());
}

TEST_F(LiveWindowClosing, SaysWhichFileCannotBeWritten)
{
    auto window = drawing();
    ASSERT_TRUE(window.may_close()); // The stroke is saved.
    FullDisk const disk(1);
    window.perform(view::SavePicture { render::Image(2, 2) });
    auto const closed = window.close();
    ASSERT_FALSE(closed);
    EXPECT_NE(closed.error().message.find(".png"), std::string::npos) << closed.error().message;
}

} // namespace
} // namespace tractus::controllers
