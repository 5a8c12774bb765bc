#include "app/controllers/live_window.h"
#include "app/methods/all_methods.h"
#include "app/methods/indicators/indicate_tool.h"
#include "app/tools/draw_in_order_tool.h"
#include "app/tools/erase_tool.h"
#include "app/tools/select_tool.h"
#include "app/tools/tool_choices.h"
#include "app/window/window.h"
#include "drivers/logs/log_writer.h"
#include "engine/base/file.h"
#include "tests/app/render/read_png.h"
#include "tests/app/replayed.h"
#include "tests/app/session/same_edit.h"
#include "tests/app/simple_rig.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <optional>
#include <sstream>
#include <unistd.h>

namespace tractus::window {

namespace {

constexpr int kWidth_px = 1000;
constexpr int kHeight_px = 560;
// Size of the simple pen's tablet. The window shows the tablet in its middle, as large as possible.
constexpr double kTabletWidth_mm = 200;
constexpr double kTabletDepth_mm = 100;
constexpr double kPxPerMm = kWidth_px / kTabletWidth_mm;

// Writes the reports of a pen that operates the window. Positions are in pixels of the window.
class PenScript {
public:
    explicit PenScript(std::vector<drivers::DeviceInfo> devices = { drivers::simple_pen() })
        : log_(text_, { .devices = std::move(devices), .rig_text = {}, .start = {} })
    {
        hover(10, 10);
        wait(300); // By then, the window is open.
    }

    void hover(double x_px, double y_px, bool barrel = false)
    {
        send(x_px, y_px, barrel ? kInRange | kBarrel : kInRange);
    }

    void tap(double x_px, double y_px)
    {
        hover(x_px, y_px);
        wait(100);
        for (int i = 0; i < 5; ++i)
            send(x_px, y_px, kInRange | kTouching);
        hover(x_px, y_px);
        wait(100);
    }

    void draw(double from_x_px, double from_y_px, double to_x_px, double to_y_px,
              int flags = kInRange | kTouching)
    {
        for (int i = 0; i <= 20; ++i)
            send(from_x_px + (to_x_px - from_x_px) * i / 20,
                 from_y_px + (to_y_px - from_y_px) * i / 20, flags);
        hover(to_x_px, to_y_px);
        wait(100);
    }

    // Erases along a line with the pen's other end.
    void erase(double from_x_px, double from_y_px, double to_x_px, double to_y_px)
    {
        draw(from_x_px, from_y_px, to_x_px, to_y_px, kInRange | kErasing);
    }

    // Opens the ring of tools at a position, and taps one of its choices, which are counted
    // clockwise from the top.
    void choose(double x_px, double y_px, int choice)
    {
        constexpr double kMiddleOfRing_px = 126;
        hover(x_px, y_px);
        hover(x_px, y_px, true);
        wait(50);
        hover(x_px, y_px);
        wait(50);
        // The choices are the groups of tools, undo, redo, and two that change the view.
        auto const choices
            = static_cast<int>(tools::tool_choices(methods::all_methods().tools, {}).size()) + 4;
        double const angle = choice * 2 * kPi / choices - kPi / 2;
        tap(x_px + kMiddleOfRing_px * std::cos(angle), y_px + kMiddleOfRing_px * std::sin(angle));
    }

    void rest(double x_px, double y_px, int milliseconds)
    {
        for (int i = 0; i < milliseconds / 5; ++i)
            send(x_px, y_px, kInRange | kTouching);
    }

    void wait(int milliseconds) { now_ms_ += milliseconds; }
    int frames() const { return static_cast<int>(now_ms_ * 60 / 1000 + 30); }

    std::string text()
    {
        EXPECT_TRUE(log_.flush());
        return text_.str();
    }

private:
    // Bits in the simple pen's report, in the byte after the report ID.
    static constexpr int kTouching = 0x01;
    static constexpr int kBarrel = 0x02;
    static constexpr int kErasing = 0x18; // The pen's other end touches.
    static constexpr int kInRange = 0x20;

    void send(double x_px, double y_px, int flags)
    {
        double const x_mm = kTabletWidth_mm / 2 + (x_px - kWidth_px / 2.0) / kPxPerMm;
        double const y_mm = kTabletDepth_mm / 2 + (y_px - kHeight_px / 2.0) / kPxPerMm;
        auto report = pen_report(x_mm, y_mm, flags != kInRange && (flags & kBarrel) == 0);
        report[1] = static_cast<std::byte>(flags);
        now_ms_ += 5;
        log_.write_report(0, at_ms(now_ms_), report);
    }

    std::ostringstream text_;
    drivers::LogWriter log_;
    std::int64_t now_ms_ = 0;
};

} // namespace

class PenWorksWindow : public testing::Test {
protected:
    void SetUp() override
    {
        folder_ = std::filesystem::temp_directory_path()
            / ("tractus_pen_works_" + std::to_string(::getpid()));
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    controllers::LiveWindow window_of(PenScript& script, bool records = false,
                                      bool has_sensor = false)
    {
        auto const file = folder_ / "pen.tractus-log";
        std::ofstream(file) << script.text();
        auto const now = std::make_shared<Timestamp>();
        controllers::LiveWindowOptions options {
            .methods = methods::all_methods(),
            .rig_file = folder_ / "table.rig.toml",
            .height_mm = has_sensor ? std::nullopt : std::optional(100.0),
            .scene = small_scene(),
            .folder = folder_,
            .now = [now] { return *now; },
            .counted_time = now,
        };
        if (records)
            options.recording = folder_ / "again.tractus-log";
        auto devices = devices::LiveDevices::play_log(file.string(), options.now).value();
        return controllers::LiveWindow::create(std::move(devices), std::move(options)).value();
    }

    // Returns a window at its start page: a pen can also operate the window before there is a
    // drawing.
    controllers::LiveWindow window_at_start(PenScript& script)
    {
        auto const file = folder_ / "pen.tractus-log";
        std::ofstream(file) << script.text();
        auto const now = std::make_shared<Timestamp>();
        controllers::LiveWindowOptions options {
            .methods = methods::all_methods(),
            .height_mm = 100.0,
            .folder = folder_,
            .now = [now] { return *now; },
            .counted_time = now,
            .start_page = std::make_unique<controllers::StartPageController>(
                controllers::StartPageOptions { .kinds = methods::all_methods().edits,
                                                .tools = methods::all_methods().tools,
                                                .models = {},
                                                .sessions = folder_,
                                                .pictures = {},
                                                .now = [] { return std::chrono::sys_seconds(); } }),
        };
        options.start_page->open({});
        auto devices = devices::LiveDevices::play_log(file.string(), options.now).value();
        return controllers::LiveWindow::create(std::move(devices), std::move(options)).value();
    }

    void run(controllers::LiveWindow& window, PenScript const& script)
    {
        auto const result = run_window(window,
                                       { .width = kWidth_px,
                                         .height = kHeight_px,
                                         .frames = script.frames(),
                                         .screenshot = folder_ / "window.png" });
        EXPECT_TRUE(result) << result.error().message;
    }

    std::filesystem::path folder_;
};

namespace {

constexpr int kDrawChoice = 0; // Index of the ring's first choice, clockwise from the top.
constexpr int kSelectChoice = 1;
constexpr int kLeanChoice = 2;
constexpr int kEraseChoice = 3;
constexpr int kSketchChoice = 4;

} // namespace

TEST_F(PenWorksWindow, ChoosesAToolInTheRingAndDrawsWithIt)
{
    PenScript script;
    script.choose(500, 195, kLeanChoice);
    script.draw(350, 195, 600, 195);
    auto window = window_of(script);
    run(window, script);
    EXPECT_TRUE(window.state().hand.get<indicators::IndicateTool>());
    ASSERT_EQ(window.station().counts().strokes, 1u) << "what presses draws nothing";
    ASSERT_EQ(window.scene().indicators.size(), 1u);
    auto const& indicator = window.scene().indicators[0].what;
    EXPECT_NEAR(indicator.start_mm.x(), (350 - 500) / kPxPerMm, 0.1);
    EXPECT_NEAR(indicator.start_mm.y(), (280 - 195) / kPxPerMm, 0.1);
    EXPECT_NEAR(indicator.end_mm.x(), (600 - 500) / kPxPerMm, 0.1);
}

TEST_F(PenWorksWindow, OpensTheRingForATouchThatRests)
{
    PenScript script;
    script.hover(500, 195);
    script.rest(500, 195, 700);
    script.hover(500, 195);
    script.wait(100);
    script.tap(500 + 120, 195 - 39); // Taps "Lean".
    script.draw(350, 150, 600, 150);
    script.choose(500, 195, kEraseChoice);
    script.draw(450, 60, 450, 220);
    auto window = window_of(script);
    run(window, script);
    EXPECT_TRUE(window.state().hand.get<tools::EraseTool>());
    ASSERT_EQ(window.station().counts().strokes, 2u);
    EXPECT_TRUE(window.scene().indicators.empty()) << "the eraser ran over it";
}

TEST_F(PenWorksWindow, SelectsWhereTheSkeletonIsShown)
{
    PenScript script;
    script.choose(500, 195, kSelectChoice);
    script.draw(500, 310, 500, 120); // Draws across the branch on the right.
    auto window = window_of(script);
    run(window, script);
    EXPECT_TRUE(window.state().hand.get<tools::SelectTool>());
    ASSERT_EQ(window.station().counts().strokes, 1u);
    EXPECT_FALSE(window.scene().selection.empty());
}

TEST_F(PenWorksWindow, RecordsWhatReplaysTheSame)
{
    PenScript script;
    script.choose(500, 195, kLeanChoice);
    script.draw(350, 195, 600, 195);
    auto window = window_of(script, true);
    run(window, script);
    auto const log = drivers::read_log(folder_ / "again.tractus-log").value();
    station::ReplayOptions options { .methods = methods::all_methods() };
    options.height = calib::parse_height_scenario("100").value();
    auto const replay = replayed(log, options);
    auto const& again = replay.scene.indicators;
    ASSERT_EQ(again.size(), 1u);
    EXPECT_LT((again[0].what.start_mm - window.scene().indicators.at(0).what.start_mm).norm(),
              1e-9);
    EXPECT_EQ(replay.strokes.size(), 1u);
}

// The eraser is chosen by a button, and then used with the pen's other end. The replay of the
// recording must give the same result.
TEST_F(PenWorksWindow, ErasesWhatItTouches)
{
    PenScript script;
    script.draw(300, 195, 700, 215); // Draws a stroke for the first branch.
    script.choose(500, 195, kEraseChoice);
    script.tap(306, 458); // Taps "What it touches".
    script.draw(700, 150, 700, 250);
    script.choose(500, 300, kDrawChoice);
    script.erase(300, 150, 300, 250);
    auto window = window_of(script, true);
    run(window, script);
    EXPECT_TRUE(window.state().hand.get<tools::DrawInOrderTool>());
    EXPECT_EQ(
        window.state().remembered,
        std::vector<tools::Tool> { tools::EraseTool { tools::EraseTool::EraseExtent::Part } });
    ASSERT_EQ(window.station().counts().strokes, 3u);
    ASSERT_EQ(window.scene().associations.size(), 1u);
    auto const& tips = window.scene().associations[0].what.stroke.tips;
    EXPECT_NEAR(tips.front().position_mm.x(), -36,
                0.1); // The line has a tip every 4 mm, so its new ends are at x = -36 and 36 mm.
    EXPECT_NEAR(tips.back().position_mm.x(), 36, 0.1);

    auto const log = drivers::read_log(folder_ / "again.tractus-log").value();
    station::ReplayOptions options { .methods = methods::all_methods() };
    options.height = calib::parse_height_scenario("100").value();
    auto const scene = replayed(log, options).scene;
    ASSERT_EQ(scene.associations.size(), 1u);
    EXPECT_TRUE(session::same(scene.associations[0].what.stroke,
                              window.scene().associations[0].what.stroke));
}

// The table's height sensor is not calibrated yet, and the user has neither keyboard nor mouse.
TEST_F(PenWorksWindow, LeavesCalibratingForDrawing)
{
    PenScript script(simple_rig());
    script.tap(826, 42); // Taps "Back to drawing".
    script.choose(500, 195, kLeanChoice);
    script.draw(350, 195, 600, 195);
    auto window = window_of(script, false, true);
    EXPECT_NE(window.calibration(), nullptr);
    run(window, script);
    EXPECT_EQ(window.calibration(), nullptr);
    EXPECT_EQ(window.scene().indicators.size(), 1u) << "the surface lies on the desk";
}

TEST_F(PenWorksWindow, RestsOnTheTabletToCapture)
{
    PenScript script(simple_rig());
    script.tap(760, 400); // Taps a position without buttons.
    script.rest(760, 400, 800);
    script.wait(500);
    auto window = window_of(script, false, true);
    run(window, script);
    ASSERT_NE(window.calibration(), nullptr);
    EXPECT_TRUE(window.calibration()->view().is_capturing) << window.calibration()->view().message;
    EXPECT_EQ(window.station().counts().strokes, 0u);
}

TEST_F(PenWorksWindow, PressesAButtonForLongWithoutCapturing)
{
    PenScript script(simple_rig());
    script.hover(64, 212);
    script.wait(50);
    script.rest(64, 212, 800); // Rests on the button "-10".
    script.hover(64, 212);
    script.wait(100);
    auto window = window_of(script, false, true);
    run(window, script);
    ASSERT_NE(window.calibration(), nullptr);
    EXPECT_FALSE(window.calibration()->view().is_capturing);
    EXPECT_EQ(window.calibration()->view().proposed_mm, -10);
}

// Numbers are set in steps and by keys. Numbers out of range must change nothing.
TEST_F(PenWorksWindow, SetsNumbersOfATool)
{
    PenScript script;
    script.choose(500, 195, kSketchChoice);
    script.draw(973, 340, 973, 480); // Scrolls the rows of the bar to their end.
    script.tap(220, 392); // Taps the button "Angle 45°", whose panel opens above the bar.
    script.tap(316, 140); // Taps "more by 5".
    script.tap(80, 392);  // Taps the button "Laterals 2", whose range is 0 to 8.
    script.tap(676, 247); // Taps the key 3.
    script.tap(676, 42);  // Taps "Set".
    script.tap(676, 115); // Taps the key 9.
    script.tap(676, 42);  // Taps "Set".
    auto window = window_of(script);
    run(window, script);
    auto const words = tools::words_for(window.state().hand);
    EXPECT_EQ(words.name, "sketch");
    EXPECT_EQ(words.arguments, "laterals=3 angle=55 first=15 ratio=0.95 lateral=0.7 at_foot");
    EXPECT_EQ(window.station().counts().strokes, 0u);
}

// The display on which the tests run must be larger than their window.
TEST_F(PenWorksWindow, FillsTheDisplay)
{
    PenScript script;
    script.tap(942, 524); // Opens the menu.
    script.tap(920, 42);  // Opens the page "Window" of the menu.
    script.tap(760, 126); // Chooses "Full screen".
    script.wait(300);
    auto window = window_of(script);
    run(window, script);
    auto const picture = render::read_png(read_file(folder_ / "window.png").value());
    EXPECT_GT(picture.width(), kWidth_px);
    EXPECT_GT(picture.height(), kHeight_px);
}

TEST_F(PenWorksWindow, PressesACardAndDrawsOnTheEmptySheet)
{
    ::setenv("XDG_DATA_HOME", folder_.c_str(), 1);
    PenScript script;
    script.tap(110, 200); // Taps the card "Along a stroke".
    script.draw(300, 150, 700, 150);
    auto window = window_at_start(script);
    ASSERT_NE(window.start_page(), nullptr);
    run(window, script);
    ::unsetenv("XDG_DATA_HOME");
    EXPECT_EQ(window.start_page(), nullptr);
    EXPECT_STREQ(window.state().hand.kind().word, "sketch");
    EXPECT_EQ(window.station().counts().strokes, 1u) << "what presses draws nothing";
    EXPECT_EQ(window.scene().plants.size(), 1u) << window.state().status;
}

} // namespace tractus::window
