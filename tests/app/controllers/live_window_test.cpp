#include "app/controllers/live_window.h"

#include "app/methods/indicators/indicate_tool.h"
#include "app/play/paced_log.h"
#include "app/tools/draw_in_order_tool.h"
#include "app/tools/erase_tool.h"
#include "calib/rig_file.h"
#include "engine/base/file.h"
#include "tests/app/controllers/live_window_devices.h"
#include "tests/app/replayed.h"
#include "tests/app/session/same_edit.h"

#include <filesystem>
#include <fmt/core.h>
#include <fstream>
#include <gtest/gtest.h>
#include <unistd.h>

namespace tractus::controllers {
namespace {

namespace fs = std::filesystem;

TEST(LiveWindow, ShowsWhatTheDevicesDraw)
{
    auto window = LiveWindow::create(drawing_devices(false), live_options()).value();
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
    auto window = LiveWindow::create(drawing_devices(true), live_options()).value();
    advance_to_end(window);
    window.settle();
    EXPECT_EQ(window.station().counts().strokes, 1u);
    EXPECT_TRUE(window.state().live_ink.empty());
    // The pen is out of range, so the mouse is used again.
    EXPECT_FALSE(window.state().pen.in_range);
}

TEST(LiveWindow, RecordsWhatReplaysToTheSame)
{
    auto const path
        = fs::temp_directory_path() / fmt::format("tractus_live_{}.tractus-log", ::getpid());
    fs::remove(path);
    auto options = live_options();
    options.recording = path;
    {
        auto window = LiveWindow::create(drawing_devices(true), std::move(options)).value();
        window.perform(view::ChooseTool { indicators::IndicateTool {} });
        EXPECT_EQ(window.state().tool, "Motion indicator");
        advance_to_end(window);
    }
    auto const log = drivers::read_log(path).value();
    EXPECT_EQ(log.records.size(), 21u);
    EXPECT_EQ(log.records.back().size, 0u);
    ASSERT_EQ(log.tools.size(), 3u);
    EXPECT_EQ(log.tools[0].tool, "least");
    EXPECT_EQ(log.tools[0].arguments,
              tools::print_min_extents(tools::usual_min_extents(methods::all_methods().tools)));
    EXPECT_EQ(log.tools[1].tool, "draw_in_order")
        << "for programs that do not know the line before";
    EXPECT_EQ(log.tools[1].arguments, "heading from_foot") << "by which law it draws";
    EXPECT_EQ(log.tools[2].tool, "indicate");
    EXPECT_TRUE(calib::parse_rig(log.rig_text, "log"));
    fs::remove(path);
}

// With finer times, a live drawing would differ in the last bits from the replay of its recording.
TEST(LiveDevices, CutTimesToMicrosecondsAsLogsHaveThem)
{
    auto report = arrived(0, pen_report(50, 50, true));
    report.received = Timestamp(std::chrono::nanoseconds(1'234'567));
    std::vector<std::unique_ptr<drivers::ReportSource>> sources;
    sources.push_back(
        std::make_unique<ScriptedSource>(drivers::simple_pen(), std::vector { report }));
    auto devices = devices::LiveDevices::start(std::move(sources)).value();
    std::vector<devices::LiveReport> reports;
    while (devices.any_left() && reports.empty()) {
        devices.take(reports);
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    ASSERT_EQ(reports.size(), 1u);
    EXPECT_EQ(reports[0].report.received, Timestamp(std::chrono::microseconds(1'234)));
}

// The recording must also contain undo, changes of growth, and all other steps that are not
// strokes.
TEST(LiveWindow, RecordsWhatIsDoneBesideDrawing)
{
    auto const path
        = fs::temp_directory_path() / fmt::format("tractus_steps_{}.tractus-log", ::getpid());
    fs::remove(path);
    auto options = live_options();
    options.recording = path;
    // The clock stands still at 0, so all reports are later than it.
    options.now = [] { return at_ms(0); };
    scene::Scene drawn;
    {
        auto window = LiveWindow::create(drawing_devices(true), std::move(options)).value();
        window.perform(view::NextVariation {});
        window.perform(view::ChangeGrowth { { "windy hillside", 0.5, 0.75 } });
        advance_to_end(window);
        window.perform(view::NextVariation {});
        window.perform(view::Undo {});
        window.perform(view::Undo {}); // Removes the stroke.
        window.perform(view::Redo {}); // Restores the stroke.
        window.perform(view::PickVariation { 42 });
        window.settle();
        drawn = window.scene();
    }
    EXPECT_EQ(drawn.growth.seed, 42u);
    ASSERT_EQ(drawn.associations.size(), 1u);
    auto const log = drivers::read_log(path).value();
    ASSERT_EQ(log.tools.size(), 9u); // The first two lines record the initial settings.
    EXPECT_EQ(log.tools[2].tool, "step");
    EXPECT_EQ(log.tools[5].tool, "undo");
    EXPECT_EQ(log.tools[5].arguments, "1");
    station::ReplayOptions replay_options { .methods = methods::all_methods() };
    replay_options.height = calib::parse_height_scenario("0").value();
    auto const [counts, scene, strokes] = replayed(log, replay_options);
    ASSERT_EQ(strokes.size(), 1u);
    EXPECT_EQ(strokes[0].refusal, "");
    EXPECT_TRUE(session::same(scene.growth, drawn.growth));
    ASSERT_EQ(scene.associations.size(), 1u);
    EXPECT_TRUE(
        session::same(scene.associations[0].what.stroke, drawn.associations[0].what.stroke));
    fs::remove(path);
}

// Returns the devices of a pen that twice slips by 3 mm and then draws a stroke of 60 mm.
devices::LiveDevices slipping_devices()
{
    std::vector<drivers::RawReport> reports;
    std::int64_t now_ms = 0;
    for (double const length_mm : { 3.0, 3.0, 60.0 }) {
        for (int i = 0; i <= 20; ++i, now_ms += 5)
            reports.push_back(arrived(now_ms, pen_report(50 + length_mm * i / 20, 50, true)));
        reports.push_back(arrived(now_ms += 5, pen_report(50 + length_mm, 50, false)));
        now_ms += 50;
    }
    std::vector<std::unique_ptr<drivers::ReportSource>> sources;
    sources.push_back(std::make_unique<ScriptedSource>(drivers::simple_pen(), std::move(reports)));
    return devices::LiveDevices::start(std::move(sources)).value();
}

TEST(LiveWindow, ASlipOfTheHandDoesNothingAndIsToldOnce)
{
    auto const path
        = fs::temp_directory_path() / fmt::format("tractus_dabs_{}.tractus-log", ::getpid());
    fs::remove(path);
    auto options = live_options();
    options.recording = path;
    // The clock stands still at 0, so all reports are later than it.
    options.now = [] { return at_ms(0); };
    std::size_t drawn = 0;
    std::size_t told = 0;
    {
        auto window = LiveWindow::create(slipping_devices(), std::move(options)).value();
        std::string before;
        while (before.find("is over") == std::string::npos) {
            window.advance(std::chrono::milliseconds(16));
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
            auto const& status = window.state().status;
            told += status != before && status.find("less than 6 mm") != std::string::npos;
            before = status;
        }
        window.settle();
        EXPECT_EQ(window.station().counts().dabs, 2u);
        EXPECT_EQ(window.station().counts().strokes, 1u);
        drawn = window.scene().associations.size();
    }
    EXPECT_EQ(drawn, 1u);
    EXPECT_LE(told, 1u);
    auto log = drivers::read_log(path).value();
    station::ReplayOptions replay_options;
    replay_options.height = calib::parse_height_scenario("0").value();
    EXPECT_EQ(replayed(log, replay_options).counts.strokes, 1u);
    EXPECT_EQ(replayed(log, replay_options).scene.associations.size(), 1u);
    log.tools.erase(log.tools.begin()); // Older programs did not record the minimum extents.
    EXPECT_EQ(replayed(log, replay_options).counts.strokes, 3u);
    fs::remove(path);
}

TEST(LiveWindow, APersonSaysHowFarAStrokeHasToGet)
{
    auto options = live_options();
    options.min_extents = { { "draw_in_order", 2 } };
    auto window = LiveWindow::create(slipping_devices(), std::move(options)).value();
    advance_to_end(window);
    window.settle();
    EXPECT_EQ(window.station().counts().strokes, 3u);
    EXPECT_EQ(window.station().counts().dabs, 0u);
}

TEST(LiveWindow, BeginsAgainWithTheSameTool)
{
    auto window = LiveWindow::create(drawing_devices(false), live_options()).value();
    window.perform(view::ChooseTool { indicators::IndicateTool {} });
    advance_to_end(window);
    window.perform(view::Restart {});
    window.settle();
    EXPECT_TRUE(window.state().strokes.empty());
    EXPECT_TRUE(window.state().layers.empty());
    EXPECT_EQ(window.state().tool, "Motion indicator");
}

// Returns the problem that the window shows at `now_ms`, after the height sensor has sent the value
// `counts` for 100 ms.
std::string trouble_after(int counts, std::int64_t now_ms)
{
    std::vector<drivers::RawReport> heights;
    for (int i = 0; i <= 20; ++i)
        heights.push_back(arrived(5 * i, height_report(counts)));
    std::vector<std::unique_ptr<drivers::ReportSource>> sources;
    sources.push_back(std::make_unique<ScriptedSource>(
        drivers::simple_pen(), std::vector { arrived(0, pen_report(50, 50, false)) }));
    sources.push_back(
        std::make_unique<ScriptedSource>(drivers::simple_height_sensor(), std::move(heights)));
    auto options = live_options();
    options.rig = calib::Rig {};
    auto now = at_ms(100);
    options.now = [&now] { return now; };
    auto devices = devices::LiveDevices::start(std::move(sources)).value();
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

// A source that always claims to have lost one report because it was too long.
class Chatterbox final : public ScriptedSource {
public:
    using ScriptedSource::ScriptedSource;
    std::uint64_t oversized_count() const override { return 1; }
};

TEST(LiveWindow, SaysThatReportsAreLost)
{
    std::vector<std::unique_ptr<drivers::ReportSource>> sources;
    sources.push_back(std::make_unique<Chatterbox>(
        drivers::simple_pen(), std::vector { arrived(0, pen_report(50, 50, false)) }));
    auto window = LiveWindow::create(devices::LiveDevices::start(std::move(sources)).value(),
                                     live_options())
                      .value();
    while (window.state().status.find("lost") == std::string::npos)
        window.advance(Duration(0));
    EXPECT_EQ(window.state().status.find("1 of the devices' reports is lost"), 0u)
        << window.state().status;
}

TEST(LiveWindow, SaysThatATabletsSizeIsAGuess)
{
    auto tablet = drivers::simple_pen();
    auto& descriptor = tablet.report_descriptor;
    // Removes the physical size from the descriptor: the maxima of both axes and the unit.
    std::vector<std::byte> plain;
    for (std::size_t i = 0; i < descriptor.size(); ++i)
        if (descriptor[i] == std::byte { 0x46 })
            i += 2;
        else
            plain.push_back(descriptor[i]);
    descriptor = plain;
    auto const status = [&](LiveWindowOptions options) {
        std::vector<std::unique_ptr<drivers::ReportSource>> sources;
        sources.push_back(
            std::make_unique<ScriptedSource>(tablet, std::vector<drivers::RawReport> {}));
        return LiveWindow::create(devices::LiveDevices::start(std::move(sources)).value(),
                                  std::move(options))
            .value()
            .state()
            .status;
    };
    EXPECT_NE(status(live_options()).find("does not tell its size"), std::string::npos);
    auto options = live_options();
    options.rig = calib::Rig {};
    options.rig->surface_mm = options.rig->tablet_size_mm;
    EXPECT_EQ(status(std::move(options)).find("does not tell its size"), std::string::npos);
}

TEST(LiveWindow, AsksForACalibration)
{
    std::vector<std::unique_ptr<drivers::ReportSource>> sources;
    sources.push_back(std::make_unique<ScriptedSource>(drivers::simple_pen(),
                                                       std::vector<drivers::RawReport> {}));
    sources.push_back(std::make_unique<ScriptedSource>(drivers::simple_height_sensor(),
                                                       std::vector<drivers::RawReport> {}));
    auto const window = LiveWindow::create(devices::LiveDevices::start(std::move(sources)).value(),
                                           live_options());
    ASSERT_FALSE(window);
    EXPECT_EQ(window.error().fault, Fault::User);
    EXPECT_NE(window.error().message.find("--rig"), std::string::npos);
}

} // namespace
} // namespace tractus::controllers
