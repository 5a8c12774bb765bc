#include "app/controllers/file_queue.h"
#include "app/files/resources.h"
#include "app/io/model_file.h"
#include "app/methods/indicators/indicate_tool.h"
#include "app/tools/draw_in_order_tool.h"
#include "app/tools/erase_tool.h"
#include "engine/base/file.h"
#include "engine/export/glb_reader.h"
#include "tests/app/controllers/live_window_devices.h"
#include "tests/app/replayed.h"

#include <algorithm>
#include <filesystem>
#include <fmt/core.h>
#include <fstream>
#include <gtest/gtest.h>
#include <unistd.h>

namespace tractus::controllers {
namespace {

namespace fs = std::filesystem;

// Fixture with a window that writes its files into a temporary folder.
class LiveWindowWithFolder : public testing::Test {
protected:
    LiveWindowWithFolder() { fs::create_directory(folder_); }
    ~LiveWindowWithFolder() override { fs::remove_all(folder_); }

    LiveWindow window(bool goes_away = false, scene::Scene scene = small_scene()) const
    {
        auto options = live_options();
        options.folder = folder_;
        options.scene = std::move(scene);
        return LiveWindow::create(drawing_devices(goes_away), std::move(options)).value();
    }

    // Returns the files in the folder with the given extension.
    std::vector<fs::path> files(std::string const& ending) const
    {
        std::vector<fs::path> found;
        for (auto const& entry : fs::directory_iterator(folder_))
            if (entry.path().string().ends_with(ending))
                found.push_back(entry.path());
        std::sort(found.begin(), found.end());
        return found;
    }

    fs::path const folder_
        = fs::temp_directory_path() / fmt::format("tractus_files_{}", ::getpid());
};

TEST_F(LiveWindowWithFolder, RecordsWhenItIsAskedTo)
{
    auto window = this->window();
    EXPECT_FALSE(window.state().recording.is_on);
    window.perform(view::ChooseTool { indicators::IndicateTool {} });
    window.perform(view::SetRecording { true });
    EXPECT_TRUE(window.state().recording.is_on);
    EXPECT_EQ(window.state().recording.file.substr(0, 6), "small-");
    auto const begun = window.state().recording.bytes;
    EXPECT_GT(begun, 0u);
    advance_to_end(window);
    window.perform(view::SetRecording { false });
    EXPECT_FALSE(window.state().recording.is_on);
    EXPECT_EQ(window.state().status.substr(0, 15), "Recorded small-");
    // The second request to stop recording has no effect.
    window.perform(view::SetRecording { false });

    auto const logs = files(".tractus-log");
    ASSERT_EQ(logs.size(), 1u);
    EXPECT_EQ(logs[0].filename(), window.state().recording.file);
    EXPECT_EQ(fs::file_size(logs[0]), window.state().recording.bytes);
    EXPECT_GT(window.state().recording.bytes, begun);
    auto const log = drivers::read_log(logs[0]).value();
    EXPECT_EQ(log.records.size(), 21u);
    ASSERT_EQ(log.tools.size(), 2u) << "the least extents, and the tool that was in hand before";
    EXPECT_EQ(log.tools[0].tool, "least");
    EXPECT_EQ(log.tools[1].tool, "indicate");
}

TEST_F(LiveWindowWithFolder, RecordsHowThePensOtherEndErasesFromTheBeginning)
{
    auto window = this->window();
    window.perform(
        view::ChooseTool { tools::EraseTool { .erasing = tools::EraseTool::EraseExtent::Part } });
    window.perform(view::ChooseTool { tools::DrawInOrderTool {} });
    window.perform(view::Restart {});
    EXPECT_EQ(
        window.state().remembered,
        std::vector<tools::Tool> { tools::EraseTool { tools::EraseTool::EraseExtent::Part } });
    window.perform(view::SetRecording { true });
    window.perform(view::SetRecording { false });
    auto const log = drivers::read_log(files(".tractus-log").at(0)).value();
    ASSERT_EQ(log.tools.size(), 3u);
    EXPECT_EQ(log.tools[0].tool, "least");
    EXPECT_EQ(log.tools[1].tool, "erase");
    EXPECT_EQ(log.tools[1].arguments, "part");
    EXPECT_EQ(log.tools[2].tool, "draw_in_order");
}

TEST_F(LiveWindowWithFolder, NeverRecordsOverARecording)
{
    auto window = this->window();
    for (int i = 0; i < 2; ++i) {
        window.perform(view::SetRecording { true });
        window.perform(view::SetRecording { false });
    }
    EXPECT_EQ(files(".tractus-log").size(), 2u);
}

TEST_F(LiveWindowWithFolder, SaysWhyItCannotRecord)
{
    auto window = this->window();
    fs::remove_all(folder_);
    std::ofstream(folder_) << "no folder any more";
    window.perform(view::SetRecording { true });
    EXPECT_FALSE(window.state().recording.is_on);
    EXPECT_NE(window.state().status.find("cannot write"), std::string::npos);
}

TEST_F(LiveWindowWithFolder, ExportsThePlantInTheBackground)
{
    auto window = this->window();
    advance_to_end(window);
    window.perform(view::ExportPlant { ".glb" });
    window.perform(view::ExportPlant { ".obj" });
    window.perform(view::ExportPlant { ".mtg" });
    window.perform(view::SavePicture { render::Image(2, 2) });
    EXPECT_TRUE(window.state().is_saving);
    EXPECT_EQ(window.state().status.substr(0, 8), "Writing ");
    window.settle();
    EXPECT_FALSE(window.state().is_saving);
    EXPECT_EQ(window.state().status.substr(0, 6), "Saved ");
    for (auto const* const ending :
         { "-seed-1.glb", "-seed-1.obj", "-seed-1.mtg", "-seed-1.png" }) {
        ASSERT_EQ(files(ending).size(), 1u) << ending;
        EXPECT_GT(fs::file_size(files(ending)[0]), 0u) << ending;
    }
}

TEST_F(LiveWindowWithFolder, ExportsLeavesInTheMeshOrAsItIsAsked)
{
    using Organs = exports::GlbOptions::Organs;
    auto const edit = io::load_plant_edit(files::find_model("leaf").value());
    ASSERT_TRUE(edit) << edit.error().message;
    auto const scene = scene::apply_edit({}, *edit).value();
    for (auto const organs : { Organs::Merged, Organs::Instanced }) {
        auto window = this->window(false, scene);
        advance_to_end(window);
        window.perform(view::ExportPlant { ".glb", organs });
        window.settle();
        auto const written = files("-seed-1.glb");
        ASSERT_EQ(written.size(), 1u);
        auto const mesh = exports::read_glb(read_file(written[0]).value());
        ASSERT_TRUE(mesh) << mesh.error().message;
        EXPECT_EQ(mesh->organs.empty(), organs == Organs::Merged);
        fs::remove(written[0]);
    }
}

TEST_F(LiveWindowWithFolder, WritesAllFilesThoughTheWindowCloses)
{
    {
        auto window = this->window();
        window.perform(view::ExportPlant { ".glb" });
        window.perform(view::ExportPlant { ".obj" });
    }
    EXPECT_EQ(files(".glb").size(), 1u);
    EXPECT_EQ(files(".obj").size(), 1u);
}

TEST_F(LiveWindowWithFolder, FilesComeWithWhatElseThereIsToSay)
{
    FileQueue files;
    files.add({ folder_ / "a", [](fs::path const&) { return Result<std::string>("large"); } });
    files.add({ folder_ / "b", [](fs::path const&) { return Result<std::string>(""); } });
    files.settle();
    EXPECT_EQ(files.take().value().value().note, "large");
    auto const second = files.take().value().value();
    EXPECT_EQ(second.path, folder_ / "b");
    EXPECT_EQ(second.note, "");
    EXPECT_FALSE(files.take());
}

TEST_F(LiveWindowWithFolder, SaysWhyItCannotExport)
{
    auto window = this->window();
    fs::remove_all(folder_);
    std::ofstream(folder_) << "no folder any more";
    window.perform(view::ExportPlant {});
    window.settle();
    EXPECT_FALSE(window.state().is_saving);
    EXPECT_NE(window.state().status.find("cannot make the folder"), std::string::npos)
        << window.state().status;
}

} // namespace
} // namespace tractus::controllers
