#include "app/controllers/drawing_file.h"
#include "engine/base/file.h"
#include "tests/app/controllers/live_window_devices.h"

#include <filesystem>
#include <fmt/core.h>
#include <fstream>
#include <gtest/gtest.h>
#include <string>
#include <unistd.h>

namespace tractus::controllers {
namespace {

namespace fs = std::filesystem;

// Fixture with a window that shows a model file, which is edited while the window is open.
class FollowedModelWindow : public testing::Test {
protected:
    FollowedModelWindow()
    {
        fs::create_directories(folder_);
        save("mine.l", rules("40"));
    }
    ~FollowedModelWindow() override { fs::remove_all(folder_); }

    static std::string rules(std::string const& length)
    {
        return "Lsystem: 1\nderivation length: 1\nAxiom: A\nA --> F(" + length
            + ")[+(60)F(20)]F(20)\nendlsystem\n";
    }

    void save(std::string const& name, std::string const& text) const
    {
        std::ofstream(folder_ / name) << text;
    }

    LiveWindow open()
    {
        auto options = live_options();
        options.scene = scene_of_plant(folder_ / "mine.l", options.methods.edits).value();
        options.model = folder_ / "mine.l";
        options.now = [this] { return now_; };
        auto window = LiveWindow::create(drawing_devices(false), std::move(options)).value();
        advance_to_end(window); // The devices draw a stroke, which shapes the trunk.
        window.settle();
        return window;
    }

    // Lets enough time pass for the window to detect that the file has changed and is now
    // unchanged.
    void pass_time(LiveWindow& window)
    {
        for (int i = 0; i < 3; ++i) {
            now_ += std::chrono::milliseconds(600);
            window.advance(std::chrono::milliseconds(16));
        }
        window.settle();
    }

    static double height_mm(LiveWindow const& window)
    {
        return bounds(*window.scene().base).max_mm.z();
    }

    fs::path const folder_
        = fs::temp_directory_path() / fmt::format("tractus_followed_{}", ::getpid());
    Timestamp now_ = at_ms(100);
};

TEST_F(FollowedModelWindow, IsTakenInWhenItIsSavedAndKeepsWhatWasDrawn)
{
    auto window = open();
    ASSERT_EQ(window.scene().associations.size(), 1u);
    auto const before = height_mm(window);
    save("mine.l", rules("80"));
    pass_time(window);
    EXPECT_EQ(window.state().status, "The plant is that of mine.l as it was saved");
    EXPECT_GT(height_mm(window), before * 1.5);
    EXPECT_EQ(window.scene().associations.size(), 1u);
    window.perform(view::Undo {});
    window.settle();
    EXPECT_EQ(height_mm(window), before);
    EXPECT_EQ(window.scene().associations.size(), 1u);
}

TEST_F(FollowedModelWindow, StaysWhatItWasWhereTheFileIsNoModelAnyMore)
{
    auto window = open();
    pass_time(window);
    auto const before = height_mm(window);
    save("mine.l", "Lsystem: 1\nAxiom: A\nA --> F(\nendlsystem\n");
    pass_time(window);
    EXPECT_NE(window.state().status.find("mine.l:3:"), std::string::npos) << window.state().status;
    EXPECT_EQ(height_mm(window), before);
    save("mine.l", rules("20"));
    pass_time(window);
    EXPECT_LT(height_mm(window), before);
}

TEST_F(FollowedModelWindow, TakesInWhatItIncludesAndItsView)
{
    save("size.h", "#define SIZE 40\n");
    save("mine.l", "#include \"size.h\"\n" + rules("SIZE"));
    auto window = open();
    pass_time(window);
    auto const before = height_mm(window);
    save("size.h", "#define SIZE 90\n");
    pass_time(window);
    EXPECT_GT(height_mm(window), before * 1.5);
    save("mine.v", "line width: 3\n");
    pass_time(window);
    EXPECT_EQ(window.state().status, "The plant is that of mine.l as it was saved");
    window.perform(view::Undo {});
    window.perform(view::Undo {});
    window.settle();
    EXPECT_EQ(height_mm(window), before);
}

TEST_F(FollowedModelWindow, IsNotTakenInAgainWhenNothingInItIsOther)
{
    auto window = open();
    pass_time(window);
    auto const status = window.state().status;
    fs::last_write_time(folder_ / "mine.l",
                        fs::file_time_type::clock::now() + std::chrono::seconds(5));
    pass_time(window);
    EXPECT_EQ(window.state().status, status);
    window.perform(view::Undo {});
    window.settle();
    EXPECT_TRUE(window.state().strokes.empty()) << "the stroke was the last step";
}

} // namespace
} // namespace tractus::controllers
