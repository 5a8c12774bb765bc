#include "app/controllers/live_window.h"
#include "app/files/resources.h"
#include "app/methods/all_methods.h"
#include "app/window/card_grid.h"
#include "drivers/logs/log.h"
#include "drivers/logs/log_writer.h"
#include "tests/app/our_plant.h"
#include "tests/app/replayed.h"
#include "tests/app/simple_rig.h"
#include "tests/app/window/layout_fixture.h"

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fmt/core.h>
#include <fstream>
#include <gtest/gtest.h>
#include <memory>
#include <sstream>
#include <thread>
#include <tuple>
#include <unistd.h>

// Tests that draw the first plant with each method, starting at the start page, with each kind of
// device. They measure the presses and seconds until the plant exists, and check that the recording
// replays.
namespace tractus::window {

using namespace layout_tests;

namespace {

namespace fs = std::filesystem;
using Line = std::vector<Vec3>; // Points of a stroke, in the world frame.

enum class Device { PenAndSurface, PenDisplay, Tablet, Mouse };

char const* name_of(Device device)
{
    static constexpr std::array kNames { "surface", "display", "tablet", "mouse" };
    return kNames.at(static_cast<std::size_t>(device));
}

// A card that the user presses, and the lines that the user then draws. The lower edge of the pad
// is hidden by the window's bar.
struct FirstPlant {
    char const* method = "";
    char const* card = "";
    std::vector<Line> lines {};
};

Line ring(double x, double y, double radius)
{
    Line line;
    for (int i = 0; i <= 40; ++i) {
        double const angle = i * 2 * kPi / 40 - kPi / 2;
        double const r = radius * (1 + 0.2 * std::fabs(std::sin(2 * angle)));
        line.emplace_back(x + r * std::cos(angle), y + r * std::sin(angle), 100);
    }
    return line;
}

Line leaf_edge()
{
    Line line;
    for (int i = 0; i <= 60; ++i) {
        double const t = i <= 30 ? i / 30.0 : (60 - i) / 30.0;
        line.emplace_back((i <= 30 ? 13 : -13) * std::sin(t * kPi), -12 + 52 * t, 100);
    }
    return line;
}

// Returns lines through points given by x and y, at a height of 100 mm.
std::vector<Line> flat(std::vector<std::vector<Vec2>> const& lines)
{
    std::vector<Line> all;
    for (auto const& line : lines) {
        all.emplace_back();
        for (auto const& at : line)
            all.back().emplace_back(at.x(), at.y(), 100);
    }
    return all;
}

FirstPlant leaf()
{
    auto lines = flat({ { { 0, -18 }, { 0, 39 } },
                        { { 0, 0 }, { 8, 7 } },
                        { { 0, 0 }, { -8, 7 } },
                        { { 0, 12 }, { 8, 19 } },
                        { { 0, 12 }, { -8, 19 } } });
    lines.insert(lines.begin(), leaf_edge());
    return { "leaf", "A leaf", lines };
}

std::vector<FirstPlant> first_plants()
{
    return {
        { "strokes", "Birch", { { { -5, -15, 60 }, { 0, 10, 100 }, { 20, 35, 140 } } } },
        { "sketch", "Along a stroke", { { { 30, -15, 60 }, { 35, 10, 90 }, { 30, 40, 130 } } } },
        { "outline",
          "From an outline",
          { { { 30, -6, 100 }, { 31, 22, 100 } }, ring(31, 28, 12) } },
        { "lines", "From lines",
          flat({ { { 30, -18 }, { 29, 10 }, { 32, 40 } },
                 { { 15, -18 }, { 12, 12 }, { 22, 42 } },
                 { { 44, -18 }, { 46, 12 }, { 41, 42 } },
                 { { 8, -4 }, { 29, -8 }, { 48, -2 } },
                 { { 10, 32 }, { 31, 28 }, { 50, 33 } } }) },
        leaf()
    };
}

// A hand that moves the pen, and optionally the surface. It writes a log with 200 reports of each
// device per second.
class PenHand {
public:
    explicit PenHand(bool has_surface)
        : has_surface_(has_surface)
        , log_(text_,
               { .devices = has_surface ? simple_rig() : std::vector { drivers::simple_pen() },
                 .rig_text = {},
                 .start = {} })
    {
        send({ -90, 40, 100 }, false);
    }

    void tap(Vec2 const& at)
    {
        for (bool const touches : { false, true, false })
            rest({ at.x(), at.y(), 100 }, touches, 30);
    }

    // Draws a line at 120 mm/s.
    void draw(Line const& line)
    {
        rest(line.front(), false, 20);
        auto last = line.front();
        for (auto const& at : line) {
            auto const steps = std::ceil((at - last).norm() / 0.6);
            for (int i = 1; i <= steps; ++i)
                send(last + (at - last) * i / steps, true);
            last = at;
        }
        rest(last, false, 20);
    }

    void wait(int milliseconds) { now_ms_ += milliseconds; }

    double seconds() const { return static_cast<double>(now_ms_) / 1000; }

    std::string text()
    {
        EXPECT_TRUE(log_.flush());
        return text_.str();
    }

private:
    void rest(Vec3 const& at, bool touches, int reports)
    {
        for (int i = 0; i < reports; ++i)
            send(at, touches);
    }

    void send(Vec3 const& at, bool touches)
    {
        now_ms_ += 5;
        if (has_surface_) // The counts follow the linear height model of a default Rig.
            log_.write_report(kHeight, at_ms(now_ms_),
                              height_report(static_cast<int>(std::lround(10 * at.z()))));
        log_.write_report(kPen, at_ms(now_ms_), pen_report(100 + at.x(), 50 - at.y(), touches));
    }

    bool has_surface_;
    std::ostringstream text_;
    drivers::LogWriter log_;
    std::int64_t now_ms_ = 0;
};

// The window, drawn in frames of 1/60 s.
class Frames {
public:
    Frames(ImVec2 const& size, render::Renderer& renderer)
        : renderer_(renderer)
    {
        ImGui::CreateContext();
        auto& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.DisplaySize = size;
        io.DeltaTime = 1.0f / 60;
        auto* const title = theme::apply(1);
        io.Fonts->Build();
        io.Fonts->TexID = reinterpret_cast<ImTextureID>(std::uintptr_t { 0xF0F0 });
        layout_.emplace(title, 1.0f);
    }
    Frames(Frames const&) = delete;
    Frames& operator=(Frames const&) = delete;
    ~Frames()
    {
        layout_.reset();
        ImGui::DestroyContext();
    }

    void show(controllers::LiveWindow& window, HandInput const& input = {})
    {
        window.advance(from_seconds(1.0 / 60));
        window.settle();
        pen_.feed(window.state(), layout_->pen_area(), 1.0f / 60);
        ImGui::NewFrame();
        layout_->show(window, renderer_, pen_, input);
        ImGui::Render();
    }

    PenArea const& area() const { return layout_->pen_area(); }

    // Returns the middle of a card on the start page. The card must be fully visible.
    ImVec2 card(view::StartPageState const& page, std::string const& title) const
    {
        DrawnFrame drawn;
        auto const* const data = ImGui::GetDrawData();
        for (int i = 0; i < data->CmdListsCount; ++i)
            find_drawn(*data->CmdLists[i], drawn);
        std::vector<Box> boxes;
        for (auto const& [whole, visible] : drawn.buttons)
            if (whole.panel.find("cards") != std::string::npos)
                boxes.push_back(visible);
        // The cards are drawn in the order of the grid. Those at the end that are not visible are
        // not drawn.
        auto const grid = arrange_cards(page.groups, ImGui::GetIO().DisplaySize.x, 1);
        for (std::size_t i = 0; i < std::min(boxes.size(), grid.places.size()); ++i) {
            auto const& place = grid.places[i];
            if (page.groups[place.group].cards[place.card].title == title)
                return { (boxes[i].left + boxes[i].right) / 2,
                         (boxes[i].top + boxes[i].bottom) / 2 };
        }
        ADD_FAILURE() << "no card is called " << title;
        return { 0, 0 };
    }

private:
    render::Renderer& renderer_;
    std::optional<Layout> layout_;
    PenPointer pen_;
};

Timestamp clock_now()
{
    return Timestamp(std::chrono::steady_clock::now().time_since_epoch());
}

// Waits until another thread has opened the chosen drawing, without a time limit. The time of the
// log stands still meanwhile.
void wait_for_opening(controllers::LiveWindow& window)
{
    while (window.start_page() && window.start_page()->state().is_opening) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        window.advance(Duration::zero());
    }
}

} // namespace

class FirstPlants : public LayoutTest,
                    public testing::WithParamInterface<std::tuple<Device, std::size_t>> {
protected:
    void SetUp() override
    {
        LayoutTest::SetUp();
        fs::create_directories(folder_);
        ::setenv("XDG_DATA_HOME", folder_.c_str(), 1);
    }
    void TearDown() override
    {
        ::unsetenv("XDG_DATA_HOME");
        fs::remove_all(folder_);
    }

    static FirstPlant plant() { return first_plants()[std::get<1>(GetParam())]; }
    static Device device() { return std::get<0>(GetParam()); }
    static ImVec2 size()
    {
        return device() == Device::PenDisplay ? ImVec2(1920, 1080) : ImVec2(1600, 900);
    }
    fs::path recording() const { return folder_ / "first.tractus-log"; }

    controllers::LiveWindowOptions options() const
    {
        controllers::StartPageOptions page { .kinds = methods::all_methods().edits,
                                             .tools = methods::all_methods().tools };
        page.models = { files::find_resource("models").value() };
        page.sessions = folder_ / "tractus";
        page.now = [] { return std::chrono::sys_seconds(); };
        controllers::LiveWindowOptions options { .methods = methods::all_methods(),
                                                 .folder = folder_ };
        options.recording = recording();
        options.start_page = std::make_unique<controllers::StartPageController>(std::move(page));
        options.start_page->open({});
        return options;
    }

    controllers::LiveWindow window_of(PenHand& hand) const
    {
        auto const file = folder_ / "hand.tractus-log";
        std::ofstream(file) << hand.text();
        auto const now = std::make_shared<Timestamp>();
        auto all = options();
        all.now = [now] { return *now; };
        all.counted_time = now;
        if (device() == Device::PenAndSurface)
            all.rig = calib::Rig { .tablet_size_mm = { 200, 100 } };
        else
            all.height_mm = 100;
        auto devices = devices::LiveDevices::play_log(file.string(), all.now).value();
        return controllers::LiveWindow::create(std::move(devices), std::move(all)).value();
    }

    // These functions return the time until the plant exists, in seconds, and the resulting scene.
    std::pair<double, scene::Scene> draw_with_pen();
    std::pair<double, scene::Scene> draw_with_mouse();

    fs::path const folder_
        = fs::temp_directory_path() / fmt::format("tractus_first_{}", ::getpid());
};

std::pair<double, scene::Scene> FirstPlants::draw_with_pen()
{
    bool const has_surface = device() == Device::PenAndSurface;
    Vec2 card = Vec2::Zero();
    {
        PenHand looks(has_surface);
        auto window = window_of(looks);
        Frames frames(size(), *renderer_);
        for (int i = 0; i < 4; ++i)
            frames.show(window);
        card = frames.area().to_mm(frames.card(window.start_page()->state(), plant().card));
    }
    fs::remove(recording());
    PenHand hand(has_surface);
    hand.tap(card);
    hand.wait(500);
    for (auto const& line : plant().lines)
        hand.draw(line);
    hand.wait(300);
    auto window = window_of(hand);
    Frames frames(size(), *renderer_);
    for (int i = 0; i < static_cast<int>(60 * hand.seconds()) + 10; ++i) {
        frames.show(window);
        wait_for_opening(window);
    }
    window.settle();
    auto const drawn = window.scene();
    EXPECT_TRUE(window.close());
    EXPECT_EQ(window.start_page(), nullptr);
    return { hand.seconds(), drawn };
}

// Draws in real time, since the mouse's devices are read in threads of their own.
std::pair<double, scene::Scene> FirstPlants::draw_with_mouse()
{
    auto all = options();
    all.now = clock_now;
    all.mouse.emplace(clock_now);
    auto window
        = controllers::LiveWindow::create(devices::LiveDevices::start({}).value(), std::move(all))
              .value();
    Frames frames(size(), *renderer_);
    auto const begin = clock_now();
    auto const show = [&](ImVec2 const& at, bool is_down) {
        ImGui::GetIO().MousePos = at;
        ImGui::GetIO().MouseDown[0] = is_down;
        HandInput input;
        input.mouse.push_back({ at, is_down });
        frames.show(window, input);
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    };
    for (int i = 0; i < 4; ++i)
        show({ 0, 0 }, false);
    auto const card = frames.card(window.start_page()->state(), plant().card);
    for (bool const is_down : { false, true, true, false, false })
        show(card, is_down);
    while (window.start_page())
        show(card, false);
    for (int i = 0; i < 4; ++i) // Drawing can start only when the pad has its final position.
        show({ 0, 0 }, false);
    for (auto const& line : plant().lines) {
        std::vector<ImVec2> path;
        auto last = line.front();
        for (auto const& at : line)
            for (int i = 1; i <= 8; ++i) {
                Vec3 const place = last + (at - last) * i / 8;
                path.push_back(frames.area().to_px(place.head<2>()));
                last = i == 8 ? at : last;
            }
        for (int i = 0; i < 4; ++i)
            show(path.front(), false);
        for (auto const& at : path)
            show(at, true);
        auto const strokes = window.station().counts().strokes;
        while (window.station().counts().strokes == strokes)
            show(path.back(), false);
    }
    window.settle();
    auto const drawn = window.scene();
    EXPECT_TRUE(window.close());
    return { to_seconds(clock_now() - begin), drawn };
}

TEST_P(FirstPlants, TakesOnePressAndIsRecorded)
{
    auto const [seconds, scene] = device() == Device::Mouse ? draw_with_mouse() : draw_with_pen();
    RecordProperty("seconds", fmt::format("{:.1f}", seconds));
    if (device() != Device::Mouse)
        EXPECT_LT(seconds, 60); // The limit is in the log's time, not in computing time.
    ASSERT_EQ(scene.plants.size(), 1u);
    EXPECT_GT(scene.plants.front()->base->segment_count(), 0u);
    bool const is_shaped = std::string_view(plant().method) == "strokes";
    EXPECT_EQ(scene.associations.size(), is_shaped ? 1u : 0u);

    // If this variable is set, the recordings are copied to the folder that it names.
    if (auto const* const folder = std::getenv("TRACTUS_FIRST_PLANTS"))
        fs::copy_file(recording(),
                      fs::path(folder)
                          / fmt::format("{}-{}.tractus-log", plant().method, name_of(device())),
                      fs::copy_options::overwrite_existing);
    auto const log = drivers::read_log(recording()).value();
    station::ReplayOptions options { .methods = methods::all_methods() };
    if (device() == Device::Tablet || device() == Device::PenDisplay)
        options.height = calib::parse_height_scenario("100").value();
    auto const again = replayed(log, options, is_shaped ? our_plant("birch") : scene::Scene {});
    ASSERT_EQ(again.scene.plants.size(), 1u);
    EXPECT_EQ(again.strokes.size(), plant().lines.size());
    auto const& base = *scene.plants.front()->base;
    EXPECT_EQ(again.scene.plants.front()->base->node_position_mm, base.node_position_mm);
    EXPECT_EQ(again.scene.associations.size(), scene.associations.size());
}

// Tests the recordings that come with the program. Running the tests with
// TRACTUS_FIRST_PLANTS=app/demo/first-plants makes these again.
TEST(FirstPlantRecordings, ReplayToAPlant)
{
    std::size_t count = 0;
    for (auto const& entry :
         fs::directory_iterator(files::find_resource("demo/first-plants").value())) {
        SCOPED_TRACE(entry.path().filename().string());
        ++count;
        auto const name = entry.path().stem().string();
        bool const is_shaped = name.starts_with("strokes");
        station::ReplayOptions options { .methods = methods::all_methods() };
        if (name.ends_with("tablet"))
            options.height = calib::parse_height_scenario("100").value();
        auto const log = drivers::read_log(entry.path()).value();
        auto const drawn = replayed(log, options, is_shaped ? our_plant("birch") : scene::Scene {});
        EXPECT_EQ(drawn.scene.plants.size(), 1u);
        EXPECT_EQ(drawn.scene.associations.size(), is_shaped ? 1u : 0u);
        for (auto const& stroke : drawn.strokes)
            EXPECT_EQ(stroke.refusal, "");
    }
    EXPECT_EQ(count, 15u);
}

INSTANTIATE_TEST_SUITE_P(All, FirstPlants,
                         testing::Combine(testing::Values(Device::PenAndSurface, Device::PenDisplay,
                                                          Device::Tablet, Device::Mouse),
                                          testing::Range<std::size_t>(0, 5)),
                         [](auto const& test) {
                             return fmt::format("{}_{}", name_of(std::get<0>(test.param)),
                                                first_plants()[std::get<1>(test.param)].method);
                         });

} // namespace tractus::window
