#include "app/live/live_window.h"
#include "app/methods/all_methods.h"

#include "app/calibration/simulated_calibration.h"
#include "app/live/file_queue.h"
#include "app/methods/indicators/indicate_tool.h"
#include "app/plants/model_file.h"
#include "app/plants/session_plant.h"
#include "app/play/paced_log.h"
#include "app/resources.h"
#include "app/tools/draw_in_order_tool.h"
#include "app/tools/erase_tool.h"
#include "calib/rig_file.h"
#include "drivers/file.h"
#include "engine/export/glb_reader.h"
#include "tests/app/full_disk.h"
#include "tests/app/replayed.h"
#include "tests/app/session/same_edit.h"
#include "tests/app/simple_rig.h"

#include <algorithm>
#include <filesystem>
#include <fmt/core.h>
#include <fstream>
#include <gtest/gtest.h>
#include <thread>
#include <unistd.h>

namespace tractus {
namespace {

namespace fs = std::filesystem;

// Sends what it is told to send, when it is told to; nothing else knows the time.
class Script : public ReportSource {
public:
    Script(DeviceInfo info, std::vector<RawReport> reports)
        : info_(std::move(info))
        , reports_(std::move(reports))
    {
    }

    DeviceInfo const& info() const override { return info_; }

    Result<std::optional<RawReport>> read(Duration) override
    {
        if (next_ == reports_.size())
            return fail(Fault::User, "the script is over");
        return std::optional(reports_[next_++]);
    }

private:
    DeviceInfo info_;
    std::vector<RawReport> reports_;
    std::size_t next_ = 0;
};

RawReport arrived(std::int64_t milliseconds, std::vector<std::byte> const& bytes)
{
    RawReport report { .received = at_ms(milliseconds), .size = bytes.size() };
    std::copy(bytes.begin(), bytes.end(), report.storage.begin());
    return report;
}

// A stroke across the tablet, which ends when the tablet is unplugged if it `goes_away`.
LiveDevices drawing_devices(bool goes_away)
{
    std::vector<RawReport> reports;
    for (int i = 0; i < 20; ++i)
        reports.push_back(arrived(5 * i, pen_report(50 + 5 * i, 50, true)));
    reports.push_back(goes_away ? RawReport { .received = at_ms(100) }
                                : arrived(100, pen_report(150, 50, false)));
    std::vector<std::unique_ptr<ReportSource>> sources;
    sources.push_back(std::make_unique<Script>(simple_pen(), std::move(reports)));
    return LiveDevices::start(std::move(sources)).value();
}

LiveWindowOptions options_for_tests()
{
    return { .methods = all_methods(), .scene = small_scene(), .now = [] { return at_ms(100); } };
}

// Advances until the script is over and was seen to be: it is read on a thread of its own, which a
// loaded machine may let wait.
void advance_to_end(LiveWindow& window)
{
    while (window.state().status.find("is over") == std::string::npos) {
        window.advance(std::chrono::milliseconds(16));
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
}

TEST(LiveWindow, ShowsWhatTheDevicesDraw)
{
    auto window = LiveWindow::create(drawing_devices(false), options_for_tests()).value();
    EXPECT_TRUE(window.state().is_live);
    EXPECT_FALSE(window.state().playing);
    window.settle();
    auto const plants = window.state().plant_revision;
    advance_to_end(window);
    window.settle();
    ASSERT_EQ(window.station().counts().strokes, 1u);
    EXPECT_EQ(window.scene().associations.size(), 1u);
    EXPECT_EQ(window.state().strokes.size(), 1u);
    EXPECT_EQ(window.state().plant_revision, plants + 1);
    EXPECT_FALSE(window.state().pen.touching);
}

TEST(LiveWindow, KeepsTheStrokeOfATabletThatIsUnplugged)
{
    auto window = LiveWindow::create(drawing_devices(true), options_for_tests()).value();
    advance_to_end(window);
    window.settle();
    EXPECT_EQ(window.station().counts().strokes, 1u);
    EXPECT_TRUE(window.state().live_ink.empty());
    EXPECT_FALSE(window.state().pen.in_range); // The mouse counts again.
}

TEST(LiveWindow, RecordsWhatReplaysToTheSame)
{
    auto const path
        = fs::temp_directory_path() / fmt::format("tractus_live_{}.tractus-log", ::getpid());
    fs::remove(path);
    auto options = options_for_tests();
    options.recording = path;
    {
        auto window = LiveWindow::create(drawing_devices(true), std::move(options)).value();
        window.perform(ChooseTool { IndicateTool {} });
        EXPECT_EQ(window.state().tool, "Motion indicator");
        advance_to_end(window);
    }
    auto const log = read_log(path).value();
    EXPECT_EQ(log.records.size(), 21u);
    EXPECT_EQ(log.records.back().size, 0u);
    ASSERT_EQ(log.tools.size(), 1u);
    EXPECT_EQ(log.tools[0].tool, "indicate");
    EXPECT_TRUE(parse_rig(log.rig_text, "log"));
    fs::remove(path);
}

// Undo, growth and all else that no stroke does.
TEST(LiveWindow, RecordsWhatIsDoneBesideDrawing)
{
    auto const path
        = fs::temp_directory_path() / fmt::format("tractus_steps_{}.tractus-log", ::getpid());
    fs::remove(path);
    auto options = options_for_tests();
    options.recording = path;
    options.now = [] { return at_ms(0); }; // No report is older.
    Scene drawn;
    {
        auto window = LiveWindow::create(drawing_devices(true), std::move(options)).value();
        window.perform(NextVariation {});
        window.perform(ChangeGrowth { { "windy hillside", 0.5, 0.75 } });
        advance_to_end(window);
        window.perform(NextVariation {});
        window.perform(Undo {});
        window.perform(Undo {}); // The stroke,
        window.perform(Redo {}); // which comes back.
        window.perform(PickVariation { 42 });
        window.settle();
        drawn = window.scene();
    }
    EXPECT_EQ(drawn.growth.seed, 42u);
    ASSERT_EQ(drawn.associations.size(), 1u);
    auto const log = read_log(path).value();
    ASSERT_EQ(log.tools.size(), 7u);
    EXPECT_EQ(log.tools[0].tool, "step");
    EXPECT_EQ(log.tools[3].tool, "undo");
    EXPECT_EQ(log.tools[3].arguments, "1");
    ReplayOptions replay_options { .methods = all_methods() };
    replay_options.height = parse_height_scenario("0").value();
    auto const [counts, scene, strokes] = replayed(log, replay_options);
    ASSERT_EQ(strokes.size(), 1u);
    EXPECT_EQ(strokes[0].refusal, "");
    EXPECT_TRUE(same(scene.growth, drawn.growth));
    ASSERT_EQ(scene.associations.size(), 1u);
    EXPECT_TRUE(same(scene.associations[0].what.stroke, drawn.associations[0].what.stroke));
    fs::remove(path);
}

// A window that keeps what is drawn in a session of its own, and devices that stop sending in the
// middle of a stroke, with the pen down.
class LiveWindowClosing : public testing::Test {
protected:
    LiveWindowClosing() { fs::remove(path_); }
    ~LiveWindowClosing() override { fs::remove(path_); }

    LiveWindow drawing() const
    {
        std::vector<RawReport> reports;
        for (int i = 0; i < 20; ++i)
            reports.push_back(arrived(5 * i, pen_report(50 + 5 * i, 50, true)));
        std::vector<std::unique_ptr<ReportSource>> sources;
        sources.push_back(std::make_unique<Script>(simple_pen(), std::move(reports)));
        auto options = options_for_tests();
        options.session = begin_session(path_, { small_model() }, all_methods().edits).value();
        auto window
            = LiveWindow::create(LiveDevices::start(std::move(sources)).value(), std::move(options))
                  .value();
        advance_to_end(window);
        EXPECT_FALSE(window.state().live_ink.empty());
        EXPECT_EQ(window.station().counts().strokes, 0u);
        return window;
    }
    std::size_t kept_steps() const
    {
        return read_session(path_, all_methods().edits).value().last_step();
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
    window.perform(NextVariation {});
    EXPECT_FALSE(window.close());
}

TEST_F(LiveWindowClosing, SaysWhichFileCannotBeWritten)
{
    auto window = drawing();
    ASSERT_TRUE(window.may_close()); // The stroke is kept.
    FullDisk const disk(1);
    window.perform(SavePicture { Image(2, 2) });
    auto const closed = window.close();
    ASSERT_FALSE(closed);
    EXPECT_NE(closed.error().message.find(".png"), std::string::npos) << closed.error().message;
}

// A window that writes its files into a new folder, which goes away with it.
class LiveWindowWithFolder : public testing::Test {
protected:
    LiveWindowWithFolder() { fs::create_directory(folder_); }
    ~LiveWindowWithFolder() override { fs::remove_all(folder_); }

    LiveWindow window(bool goes_away = false, Scene scene = small_scene()) const
    {
        auto options = options_for_tests();
        options.folder = folder_;
        options.scene = std::move(scene);
        return LiveWindow::create(drawing_devices(goes_away), std::move(options)).value();
    }

    // The files that are there with this ending.
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
    window.perform(ChooseTool { IndicateTool {} });
    window.perform(SetRecording { true });
    EXPECT_TRUE(window.state().recording.is_on);
    EXPECT_EQ(window.state().recording.file.substr(0, 6), "small-");
    auto const begun = window.state().recording.bytes;
    EXPECT_GT(begun, 0u);
    advance_to_end(window);
    window.perform(SetRecording { false });
    EXPECT_FALSE(window.state().recording.is_on);
    EXPECT_EQ(window.state().status.substr(0, 15), "Recorded small-");
    window.perform(SetRecording { false }); // Not twice.

    auto const logs = files(".tractus-log");
    ASSERT_EQ(logs.size(), 1u);
    EXPECT_EQ(logs[0].filename(), window.state().recording.file);
    EXPECT_EQ(fs::file_size(logs[0]), window.state().recording.bytes);
    EXPECT_GT(window.state().recording.bytes, begun);
    auto const log = read_log(logs[0]).value();
    EXPECT_EQ(log.records.size(), 21u);
    ASSERT_EQ(log.tools.size(), 1u) << "the one that was in hand before";
    EXPECT_EQ(log.tools[0].tool, "indicate");
}

TEST_F(LiveWindowWithFolder, RecordsHowThePensOtherEndErasesFromTheBeginning)
{
    auto window = this->window();
    window.perform(ChooseTool { EraseTool { .erasing = EraseTool::Erasing::Part } });
    window.perform(ChooseTool { DrawInOrderTool {} });
    window.perform(Restart {});
    EXPECT_EQ(window.state().remembered,
              std::vector<Tool> { EraseTool { EraseTool::Erasing::Part } });
    window.perform(SetRecording { true });
    window.perform(SetRecording { false });
    auto const log = read_log(files(".tractus-log").at(0)).value();
    ASSERT_EQ(log.tools.size(), 2u);
    EXPECT_EQ(log.tools[0].tool, "erase");
    EXPECT_EQ(log.tools[0].arguments, "part");
    EXPECT_EQ(log.tools[1].tool, "draw_in_order");
}

TEST_F(LiveWindowWithFolder, NeverRecordsOverARecording)
{
    auto window = this->window();
    for (int i = 0; i < 2; ++i) {
        window.perform(SetRecording { true });
        window.perform(SetRecording { false });
    }
    EXPECT_EQ(files(".tractus-log").size(), 2u);
}

TEST_F(LiveWindowWithFolder, SaysWhyItCannotRecord)
{
    auto window = this->window();
    fs::remove_all(folder_);
    std::ofstream(folder_) << "no folder any more";
    window.perform(SetRecording { true });
    EXPECT_FALSE(window.state().recording.is_on);
    EXPECT_NE(window.state().status.find("cannot write"), std::string::npos);
}

TEST_F(LiveWindowWithFolder, ExportsThePlantInTheBackground)
{
    auto window = this->window();
    advance_to_end(window);
    window.perform(ExportPlant { ExportPlant::Format::Glb });
    window.perform(ExportPlant { ExportPlant::Format::Obj });
    window.perform(SavePicture { Image(2, 2) });
    EXPECT_TRUE(window.state().is_saving);
    EXPECT_EQ(window.state().status.substr(0, 8), "Writing ");
    window.settle();
    EXPECT_FALSE(window.state().is_saving);
    EXPECT_EQ(window.state().status.substr(0, 6), "Saved ");
    for (auto const* const ending : { "-seed-1.glb", "-seed-1.obj", "-seed-1.png" }) {
        ASSERT_EQ(files(ending).size(), 1u) << ending;
        EXPECT_GT(fs::file_size(files(ending)[0]), 0u) << ending;
    }
}

TEST_F(LiveWindowWithFolder, ExportsLeavesInTheMeshOrAsItIsAsked)
{
    using Organs = GlbOptions::Organs;
    auto const edit = load_plant_edit(find_model("leaf").value());
    ASSERT_TRUE(edit) << edit.error().message;
    auto const scene = apply_edit({}, *edit).value();
    for (auto const organs : { Organs::Merged, Organs::Instanced }) {
        auto window = this->window(false, scene);
        advance_to_end(window);
        window.perform(ExportPlant { ExportPlant::Format::Glb, organs });
        window.settle();
        auto const written = files("-seed-1.glb");
        ASSERT_EQ(written.size(), 1u);
        auto const mesh = read_glb(read_file(written[0]).value());
        ASSERT_TRUE(mesh) << mesh.error().message;
        EXPECT_EQ(mesh->organs.empty(), organs == Organs::Merged);
        fs::remove(written[0]);
    }
}

TEST_F(LiveWindowWithFolder, WritesAllFilesThoughTheWindowCloses)
{
    {
        auto window = this->window();
        window.perform(ExportPlant { ExportPlant::Format::Glb });
        window.perform(ExportPlant { ExportPlant::Format::Obj });
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
    window.perform(ExportPlant {});
    window.settle();
    EXPECT_FALSE(window.state().is_saving);
    EXPECT_NE(window.state().status.find("cannot make the folder"), std::string::npos)
        << window.state().status;
}

TEST(LiveWindow, BeginsAgainWithTheSameTool)
{
    auto window = LiveWindow::create(drawing_devices(false), options_for_tests()).value();
    window.perform(ChooseTool { IndicateTool {} });
    advance_to_end(window);
    window.perform(Restart {});
    window.settle();
    EXPECT_TRUE(window.state().strokes.empty());
    EXPECT_TRUE(window.state().layers.empty());
    EXPECT_EQ(window.state().tool, "Motion indicator");
}

// A session, gone on with if it is there.
LiveWindowOptions options_with_session(fs::path const& path)
{
    auto options = options_for_tests();
    options.session = fs::exists(path)
        ? Session::open(path,
                        session_by_the_clock(all_methods().edits, [] { return LoadOptions {}; }))
              .value()
        : begin_session(path, { small_model() }, all_methods().edits).value();
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
        EXPECT_EQ(read_session(path, all_methods().edits).value().step,
                  1u); // While the window is open.
        window.perform(Undo {});
        window.settle();
        EXPECT_TRUE(window.state().strokes.empty());
        EXPECT_EQ(read_session(path, all_methods().edits).value().step, 0u);
        window.perform(Undo {});
        window.settle();
        EXPECT_NE(window.state().status.find("nothing to undo"), std::string::npos);
        window.perform(Redo {});
        window.settle();
        EXPECT_EQ(window.state().strokes.size(), 1u);
        window.perform(Restart {});
        window.settle();
        EXPECT_TRUE(window.state().strokes.empty());
        window.perform(Undo {});
        window.settle();
        EXPECT_EQ(window.state().strokes.size(), 1u);
    }
    auto again = LiveWindow::create(drawing_devices(false), options_with_session(path)).value();
    EXPECT_EQ(again.state().strokes.size(), 1u);
    advance_to_end(again);
    again.settle();
    EXPECT_EQ(again.scene().associations.size(), 2u);
    EXPECT_EQ(read_session(path, all_methods().edits).value().step, 2u);
    EXPECT_EQ(read_session(path, all_methods().edits).value().last_step(),
              2u); // Undone steps are gone.
    fs::remove(path);
}

// A window that keeps a session in a new file, which goes away with it.
class LiveWindowWithSession : public testing::Test {
protected:
    LiveWindowWithSession() { fs::remove(path_); }
    ~LiveWindowWithSession() override { fs::remove(path_); }

    fs::path const path_
        = fs::temp_directory_path() / fmt::format("tractus_growth_{}.tractus", ::getpid());
};

TEST_F(LiveWindowWithSession, KeepsGrowthAndTakesItBack)
{
    auto window = LiveWindow::create(drawing_devices(false), options_with_session(path_)).value();
    window.perform(ChangeGrowth { { "weeping", 0.5, 0.25 } });
    window.settle();
    EXPECT_EQ(window.state().growth.preset, "weeping");
    EXPECT_EQ(window.scene().growth.variability, 0.5);
    EXPECT_EQ(window.scene().growth.age, 0.25);
    window.perform(NextVariation {});
    window.settle();
    EXPECT_EQ(window.state().seed, 2u);
    EXPECT_EQ(window.state().growth.age, 0.25);
    auto const kept = read_session(path_, all_methods().edits).value();
    EXPECT_EQ(kept.last_step(), 2u);
    EXPECT_EQ(kept.edits.back().edit.get<SetGrowth>()->seed, 2u);
    window.perform(Undo {});
    window.settle();
    EXPECT_EQ(window.state().seed, 1u);
    window.perform(Undo {});
    window.settle();
    EXPECT_EQ(window.state().growth.preset, "usual");
    EXPECT_EQ(window.state().growth.age, 1);
}

TEST_F(LiveWindowWithSession, ShowsWhatASliderWouldGiveAndKeepsItWhenItIsReleased)
{
    using Slider = ChangeGrowth::Slider;
    auto window = LiveWindow::create(drawing_devices(false), options_with_session(path_)).value();
    window.settle();
    auto const triangles = window.state().plant->triangle_count();
    window.perform(ChangeGrowth { { "", 1, 0.3 }, Slider::Moving });
    EXPECT_TRUE(window.state().is_growing);
    EXPECT_EQ(window.state().plant->triangle_count(), triangles); // It stays until the new one.
    window.settle();
    EXPECT_FALSE(window.state().is_growing);
    EXPECT_LT(window.state().plant->triangle_count(), triangles);
    EXPECT_EQ(window.state().growth.age, 0.3);
    EXPECT_EQ(read_session(path_, all_methods().edits).value().last_step(), 0u);
    window.perform(ChangeGrowth { { "", 1, 0.2 }, Slider::Released });
    window.settle();
    EXPECT_EQ(read_session(path_, all_methods().edits).value().last_step(), 1u);
}

TEST_F(LiveWindowWithSession, MakesAVariationThePlant)
{
    auto window = LiveWindow::create(drawing_devices(false), options_with_session(path_)).value();
    window.perform(AskForCollection { 4 });
    window.settle();
    ASSERT_EQ(window.state().collection.size(), 4u);
    window.perform(PickVariation { window.state().collection[2].seed });
    window.settle();
    EXPECT_EQ(window.state().seed, 3u);
    EXPECT_EQ(window.state().collection.size(), 4u) << "to pick another";
    window.perform(Undo {});
    window.settle();
    EXPECT_EQ(window.state().seed, 1u);
}

TEST_F(LiveWindowWithSession, RefusesGrowthThatThereIsNot)
{
    auto window = LiveWindow::create(drawing_devices(false), options_with_session(path_)).value();
    window.perform(ChangeGrowth { { "upwards", 1, 1 } });
    window.settle();
    EXPECT_NE(window.state().status.find("cannot grow \"upwards\""), std::string::npos);
    window.perform(ChangeGrowth { { "", 5, 1 } });
    window.settle();
    EXPECT_NE(window.state().status.find("as it likes"), std::string::npos);
    window.perform(ChangeGrowth { { "", 1, -1 } });
    window.settle();
    EXPECT_NE(window.state().status.find("full-grown"), std::string::npos);
    EXPECT_EQ(window.state().growth.age, 1); // What holds is shown.
    EXPECT_EQ(read_session(path_, all_methods().edits).value().last_step(), 0u);
}

// Returns what the window says is wrong after the height sensor has sent `counts` for 100 ms, at
// `now_ms`.
std::string trouble_after(int counts, std::int64_t now_ms)
{
    std::vector<RawReport> heights;
    for (int i = 0; i <= 20; ++i)
        heights.push_back(arrived(5 * i, height_report(counts)));
    std::vector<std::unique_ptr<ReportSource>> sources;
    sources.push_back(std::make_unique<Script>(
        simple_pen(), std::vector { arrived(0, pen_report(50, 50, false)) }));
    sources.push_back(std::make_unique<Script>(simple_height_sensor(), std::move(heights)));
    auto options = options_for_tests();
    options.rig = Rig {};
    auto now = at_ms(100);
    options.now = [&now] { return now; };
    auto devices = LiveDevices::start(std::move(sources)).value();
    auto window = LiveWindow::create(std::move(devices), std::move(options)).value();
    while (window.station().counts().height_samples < 21) {
        window.advance(std::chrono::milliseconds(16));
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    now = at_ms(now_ms);
    window.advance(std::chrono::milliseconds(16));
    return window.state().trouble;
}

TEST(LiveWindow, SaysWhatIsWrongWithTheHeightSensor)
{
    EXPECT_EQ(trouble_after(2000, 100), "");
    EXPECT_EQ(trouble_after(4095, 100),
              "height sensor reads 4095, the end of its range: wiper or cable open?");
    EXPECT_EQ(trouble_after(2000, 3100), "height sensor silent for 3 s: is it plugged in?");
}

// Says after each report that one more was too long.
class Chatterbox final : public Script {
public:
    using Script::Script;
    std::uint64_t too_long_count() const override { return 1; }
};

TEST(LiveWindow, SaysThatReportsAreLost)
{
    std::vector<std::unique_ptr<ReportSource>> sources;
    sources.push_back(std::make_unique<Chatterbox>(
        simple_pen(), std::vector { arrived(0, pen_report(50, 50, false)) }));
    auto window
        = LiveWindow::create(LiveDevices::start(std::move(sources)).value(), options_for_tests())
              .value();
    while (window.state().status.find("lost") == std::string::npos)
        window.advance(Duration(0));
    EXPECT_EQ(window.state().status.find("1 of the devices' reports is lost"), 0u)
        << window.state().status;
}

TEST(LiveWindow, SaysThatATabletsSizeIsAGuess)
{
    auto tablet = simple_pen();
    auto& descriptor = tablet.report_descriptor;
    // The physical size is taken away: the maxima of both axes and the unit.
    std::vector<std::byte> plain;
    for (std::size_t i = 0; i < descriptor.size(); ++i)
        if (descriptor[i] == std::byte { 0x46 })
            i += 2;
        else
            plain.push_back(descriptor[i]);
    descriptor = plain;
    auto const status = [&](LiveWindowOptions options) {
        std::vector<std::unique_ptr<ReportSource>> sources;
        sources.push_back(std::make_unique<Script>(tablet, std::vector<RawReport> {}));
        return LiveWindow::create(LiveDevices::start(std::move(sources)).value(),
                                  std::move(options))
            .value()
            .state()
            .status;
    };
    EXPECT_NE(status(options_for_tests()).find("does not tell its size"), std::string::npos);
    auto options = options_for_tests();
    options.rig = Rig {};
    options.rig->surface_mm = options.rig->tablet_size_mm;
    EXPECT_EQ(status(std::move(options)).find("does not tell its size"), std::string::npos);
}

TEST(LiveWindow, AsksForACalibration)
{
    std::vector<std::unique_ptr<ReportSource>> sources;
    sources.push_back(std::make_unique<Script>(simple_pen(), std::vector<RawReport> {}));
    sources.push_back(std::make_unique<Script>(simple_height_sensor(), std::vector<RawReport> {}));
    auto const window
        = LiveWindow::create(LiveDevices::start(std::move(sources)).value(), options_for_tests());
    ASSERT_FALSE(window);
    EXPECT_EQ(window.error().fault, Fault::User);
    EXPECT_NE(window.error().message.find("--rig"), std::string::npos);
}

// Plays what a simulated person did who calibrated the simulated rig, pen and all.
class CalibratesInTheWindow : public testing::Test {
protected:
    void SetUp() override
    {
        folder_ = fs::temp_directory_path() / fmt::format("tractus_calibrates_{}", ::getpid());
        fs::create_directories(folder_);
        std::ofstream log(folder_ / "hand.tractus-log");
        EXPECT_TRUE(write_simulated_calibration(log, { .geometry = simulated_geometry() }));
    }
    void TearDown() override { fs::remove_all(folder_); }

    LiveWindow window()
    {
        auto const now = std::make_shared<Timestamp>();
        LiveWindowOptions options { .methods = all_methods(),
                                    .rig_file = folder_ / "my" / "table.rig.toml",
                                    .scene = small_scene(),
                                    .now = [now] { return *now; },
                                    .counted_time = now };
        auto devices
            = LiveDevices::play_log((folder_ / "hand.tractus-log").string(), options.now).value();
        return LiveWindow::create(std::move(devices), std::move(options)).value();
    }

    static void play(LiveWindow& window)
    {
        for (int i = 0; i < 100'000 && window.state().status.find("is over") == std::string::npos;
             ++i)
            window.advance(std::chrono::milliseconds(16));
    }

    fs::path folder_;
};

TEST_F(CalibratesInTheWindow, WhereTheSensorIsUnknown)
{
    auto window = this->window();
    auto* const calibration = window.calibration();
    ASSERT_NE(calibration, nullptr) << "it opens with calibrating";
    play(window);
    EXPECT_EQ(calibration->view().captures.size(), 7u) << "at the pen's rests";
    ASSERT_TRUE(calibration->view().may_keep) << calibration->view().message;
    calibration->perform(KeepRig {});
    window.advance(std::chrono::milliseconds(16));
    window.perform(CloseCalibration {});
    EXPECT_EQ(window.calibration(), nullptr);
    auto const kept = load_rig(folder_ / "my" / "table.rig.toml");
    ASSERT_TRUE(kept) << kept.error().message;
    auto const heights = calibrated_heights(*kept).value();
    EXPECT_NEAR(heights.high_mm, 400, 5);
    EXPECT_NEAR(window.state().volume_mm.max_mm.z(), heights.high_mm, 1e-6)
        << "the pen draws by it at once";
}

TEST_F(CalibratesInTheWindow, ShowsTheDevicesRawValuesOnceTheyAreWatched)
{
    auto window = this->window();
    window.advance(std::chrono::milliseconds(500));
    EXPECT_TRUE(window.state().devices.readings.empty());
    window.perform(WatchDevices { true });
    for (int i = 0; i < 60; ++i)
        window.advance(std::chrono::milliseconds(16));
    auto const& readings = window.state().devices.readings;
    ASSERT_EQ(readings.size(), 2u);
    EXPECT_GT(readings[0].reports, 10u);
    EXPECT_TRUE(readings[1].last.has_value());
    EXPECT_FALSE(readings[1].fields.empty());
    window.perform(WatchDevices { false });
    EXPECT_TRUE(window.state().devices.readings.empty());
}

} // namespace
} // namespace tractus
