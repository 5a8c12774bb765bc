#include "app/controllers/rules_file.h"
#include "app/methods/construction_lines/line_tool.h"
#include "app/session/begin_empty.h"
#include "engine/base/file.h"
#include "engine/methods/construction_lines/line_edits.h"
#include "tests/app/controllers/live_window_devices.h"
#include "tests/app/simulated_drawing.h"

#include <algorithm>
#include <filesystem>
#include <fmt/core.h>
#include <fstream>
#include <gtest/gtest.h>
#include <string>
#include <unistd.h>

namespace tractus::controllers {
namespace {

namespace fs = std::filesystem;

// Fixture with a window that shows a plant of construction lines, whose rules are edited in a file
// while the window is open.
class WrittenRules : public testing::Test {
protected:
    WrittenRules() { fs::create_directories(folder_); }
    ~WrittenRules() override { fs::remove_all(folder_); }

    // Returns a scene with a stem and the boundary on its left.
    static scene::Scene drawn_plant()
    {
        auto const stem = stroke_through({ { 0, -60, 50 }, { 0, 60, 50 } });
        auto const boundary = stroke_through({ { -30, -62, 50 }, { -25, 64, 50 } });
        auto scene = scene::apply_edit({}, lines::AddLine { .stroke = stem, .id = 1 }).value();
        return scene::apply_edit(scene, lines::AddLine { .plant = 1, .stroke = boundary, .id = 2 })
            .value();
    }

    LiveWindow open(scene::Scene scene)
    {
        auto options = live_options();
        options.scene = std::move(scene);
        options.folder = folder_;
        options.now = [this] { return now_; };
        return LiveWindow::create(drawing_devices(false), std::move(options)).value();
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

    // Returns the path of the file of rules that the window has written.
    fs::path rules_file() const
    {
        for (auto const& entry : fs::recursive_directory_iterator(folder_))
            if (entry.path().extension() == ".l")
                return entry.path();
        return {};
    }

    fs::path const folder_
        = fs::temp_directory_path() / fmt::format("tractus_rules_{}", ::getpid());
    Timestamp now_ = at_ms(100);
};

TEST_F(WrittenRules, AreTakenWhenTheyAreSaved)
{
    auto window = open(drawn_plant());
    window.advance(std::chrono::milliseconds(16));
    EXPECT_TRUE(window.state().may_write_rules);
    window.perform(view::WriteRules {});
    EXPECT_NE(window.state().status.find("Write in "), std::string::npos) << window.state().status;
    auto const file = rules_file();
    ASSERT_FALSE(file.empty());
    EXPECT_TRUE(fs::exists(fs::path(file).replace_extension(".v")));
    pass_time(window);
    auto const organs = window.scene().base->organs.size();
    ASSERT_GT(organs, 0U);

    auto text = read_text_file(file, 1 << 20).value();
    auto const at = text.find("--> [+(func(3, x))");
    ASSERT_NE(at, std::string::npos) << text;
    std::ofstream(file) << std::string(text).insert(at + 4, "[~l(5)]");
    pass_time(window);
    EXPECT_EQ(window.state().status, "The plant is that of lines.l as it was saved");
    EXPECT_EQ(window.scene().base->organs.size(), organs + organs / 2) << "three for two";

    std::ofstream(file) << std::string(text).insert(at + 4, "[~l(5]");
    pass_time(window);
    EXPECT_NE(window.state().status.find("lines.l:"), std::string::npos) << window.state().status;
    EXPECT_EQ(window.scene().base->organs.size(), organs + organs / 2) << "as it was last";

    std::ofstream(file) << text;
    pass_time(window);
    EXPECT_EQ(window.scene().base->organs.size(), organs);
    window.perform(view::Undo {});
    window.settle();
    EXPECT_EQ(window.scene().base->organs.size(), organs + organs / 2);
}

TEST_F(WrittenRules, AreOnlyThoseOfDrawnPlants)
{
    auto window = open(small_scene());
    window.advance(std::chrono::milliseconds(16));
    EXPECT_FALSE(window.state().may_write_rules);
    window.perform(view::WriteRules {});
    EXPECT_NE(window.state().status.find("the rules of this plant are not written here"),
              std::string::npos)
        << window.state().status;
    EXPECT_TRUE(rules_file().empty());
}

} // namespace
} // namespace tractus::controllers
