#include "app/controllers/tour.h"

#include "app/files/resources.h"
#include "app/play/simulated_recording.h"
#include "engine/base/file.h"
#include "tests/app/controllers/live_window_devices.h"

#include <deque>
#include <filesystem>
#include <fmt/core.h>
#include <gtest/gtest.h>
#include <sstream>
#include <unistd.h>

namespace tractus::controllers {
namespace {

namespace fs = std::filesystem;

TEST(Tour, GoesOnOnlyWhenItsTaskIsDone)
{
    Tour tour;
    EXPECT_TRUE(tour.waits_for_hand());
    tour.take(view::ExportPlant {});
    tour.look({ .strokes = 2 }); // The hand's strokes.
    EXPECT_EQ(tour.step(), 0u);
    tour.look({ .is_hand_over = true, .strokes = 2 });
    EXPECT_EQ(tour.step(), 1u);
    EXPECT_EQ(tour.tool(), "draw_limb");
    tour.look({ .is_hand_over = true, .strokes = 2 });
    EXPECT_EQ(tour.step(), 1u) << "the hand's strokes are not the user's";
    tour.look({ .is_hand_over = true, .strokes = 3 });
    EXPECT_EQ(tour.tool(), "indicate");
    tour.look({ .is_hand_over = true, .strokes = 4 });
    EXPECT_EQ(tour.step(), 2u) << "a stroke that is no wind";
    tour.look({ .is_hand_over = true, .strokes = 5, .indicators = 1 });
    EXPECT_EQ(tour.step(), 3u);
    tour.take(view::SetActiveFoliage {}); // The plant's own leaves.
    EXPECT_EQ(tour.step(), 3u);
    tour.take(view::SetActiveFoliage { .leaves = "birch" });
    tour.take(view::ChangeSeason { scene::Season {}, view::ChangeGrowth::Slider::Moving });
    EXPECT_EQ(tour.step(), 4u) << "while the slider moves, the season is not chosen yet";
    tour.take(view::ChangeSeason { scene::Season {} });
    tour.take(view::RequestCollection { .count = 0 });
    EXPECT_EQ(tour.step(), 5u);
    tour.take(view::RequestCollection {});
    EXPECT_FALSE(tour.view({}).is_last);
    tour.take(view::ExportPlant {});
    EXPECT_TRUE(tour.view({}).is_last);
    tour.skip();
    EXPECT_TRUE(tour.view({}).is_last) << "behind the last step there is none";
}

TEST(Tour, CountsAStrokeAfterAnUndo)
{
    Tour tour;
    tour.look({ .is_hand_over = true, .strokes = 2 });
    tour.look({ .is_hand_over = true, .strokes = 1 }); // The hand's last stroke is undone.
    EXPECT_EQ(tour.step(), 1u);
    tour.look({ .is_hand_over = true, .strokes = 2 });
    EXPECT_EQ(tour.step(), 2u);
}

TEST(Tour, SaysHowWithTheDevicesThatThereAre)
{
    Tour tour;
    tour.skip();
    auto const how = [&](bool mouse_draws, bool wheel) {
        return tour.view({ .mouse_draws = mouse_draws, .mouse_moves_surface = wheel }).how;
    };
    EXPECT_NE(how(true, true).find("button"), std::string::npos);
    EXPECT_NE(how(true, true).find("wheel"), std::string::npos);
    EXPECT_EQ(how(false, false).find("wheel"), std::string::npos);
    EXPECT_NE(how(false, false).find("pen"), std::string::npos);
    EXPECT_NE(how(false, true).find("wheel"), std::string::npos);
}

TEST(Tour, ItsHandIsRecordedFromItsScriptByteForByte)
{
    auto const path = files::find_resource("demo/tour.hand.toml").value();
    auto const script = sim::parse_gesture_script(read_file(path).value(), path.string()).value();
    std::ostringstream out;
    auto const written
        = play::write_simulated_recording(out, script, {}, methods::all_methods().tools);
    ASSERT_TRUE(written) << written.error().message;
    auto const kept = read_file(files::find_resource("demo/tour.tractus-log").value()).value();
    EXPECT_TRUE(out.str() == kept) << "record it again: its script says how";
}

// A tablet whose pen the test moves. It has no thread.
class TestPen final : public drivers::ReportSource {
public:
    using Reports = std::deque<drivers::RawReport>;

    explicit TestPen(std::shared_ptr<Reports> reports)
        : reports_(std::move(reports))
    {
    }

    drivers::DeviceInfo const& info() const override { return info_; }

    Result<std::optional<drivers::RawReport>> read(Duration) override
    {
        if (reports_->empty())
            return std::optional<drivers::RawReport>();
        auto const report = reports_->front();
        reports_->pop_front();
        return std::optional(report);
    }

private:
    drivers::DeviceInfo const info_ = drivers::simple_pen();
    std::shared_ptr<Reports> reports_;
};

// Fixture with a window that begins with the tour, for a user with a tablet or with the mouse.
class TourInWindow : public testing::TestWithParam<bool> {
protected:
    void SetUp() override
    {
        fs::remove_all(folder_);
        fs::create_directories(folder_);
        auto devices = devices::LiveDevices::start({}).value();
        auto const now = [time = time_] { return *time; };
        LiveWindowOptions options { .methods = methods::all_methods(),
                                    .folder = folder_,
                                    .now = now,
                                    .counted_time = time_,
                                    .begins_tour = true };
        if (has_tablet())
            devices.add_source_without_thread(std::make_unique<TestPen>(reports_));
        else
            options.mouse.emplace(now);
        window_ = std::make_unique<LiveWindow>(
            LiveWindow::create(std::move(devices), std::move(options)).value());
    }
    void TearDown() override
    {
        window_.reset();
        fs::remove_all(folder_);
    }

    static bool has_tablet() { return GetParam(); }

    void advance(int frames)
    {
        for (int i = 0; i < frames; ++i)
            window_->advance(std::chrono::milliseconds(16));
        window_->settle();
        window_->advance(std::chrono::milliseconds(16));
    }

    // Puts the user's pen on a place of the world frame, and lets a frame pass.
    void point(Vec2 const& place_mm, bool touching)
    {
        if (has_tablet()) {
            auto const bytes = pen_report(100 + place_mm.x(), 50 - place_mm.y(), touching);
            drivers::RawReport report { .received = *time_, .size = bytes.size() };
            std::copy(bytes.begin(), bytes.end(), report.storage.begin());
            reports_->push_back(report);
        } else {
            window_->perform(view::MoveMousePen { { { place_mm, true, touching } } });
        }
        window_->advance(std::chrono::milliseconds(16));
    }

    void draw(Vec2 const& from_mm, Vec2 const& to_mm)
    {
        point(from_mm, false);
        for (int i = 0; i <= 20; ++i)
            point(from_mm + (to_mm - from_mm) * i / 20, true);
        point(to_mm, false);
        advance(40);
    }

    std::string task() const { return window_->state().tour ? window_->state().tour->task : ""; }
    std::size_t step() const { return window_->state().tour ? window_->state().tour->step : 0; }

    void watch_the_hand()
    {
        for (int i = 0; i < 60 * 30 && step() == 1; ++i)
            window_->advance(std::chrono::milliseconds(16));
        advance(1);
    }

    fs::path const folder_ = fs::temp_directory_path() / fmt::format("tractus_tour_{}", ::getpid());
    std::shared_ptr<Timestamp> const time_ = std::make_shared<Timestamp>(at_ms(1000));
    std::shared_ptr<TestPen::Reports> const reports_ = std::make_shared<TestPen::Reports>();
    std::unique_ptr<LiveWindow> window_;
};

TEST_P(TourInWindow, IsWalkedToItsEnd)
{
    EXPECT_EQ(step(), 1u);
    EXPECT_TRUE(window_->state().is_hand_simulated);
    watch_the_hand();
    ASSERT_EQ(step(), 2u) << task();
    EXPECT_FALSE(window_->state().is_hand_simulated);
    EXPECT_EQ(window_->state().mouse_draws, !has_tablet());
    EXPECT_EQ(window_->state().trouble, "");
    auto const& scene = window_->scene();
    EXPECT_EQ(scene.plants.size(), 1u);
    auto const branches = scene.base->axes.size();
    EXPECT_GT(branches, 5u) << "the hand has drawn a tree";
    draw({ 0, 0 }, { 50, 15 });
    ASSERT_EQ(step(), 3u) << task() << ": " << window_->state().status;
    EXPECT_GT(window_->scene().base->axes.size(), branches);
    draw({ -50, -20 }, { 30, -20 });
    ASSERT_EQ(step(), 4u) << task() << ": " << window_->state().status;
    window_->perform(
        view::SetActiveFoliage { files::find_resource("leaves/birch.leaf").value().string() });
    window_->perform(view::ChangeSeason { scene::Season { .month = 10 } });
    window_->perform(view::RequestCollection { .count = 2 });
    advance(1);
    ASSERT_EQ(step(), 7u) << task();
    window_->perform(view::ExportPlant {});
    advance(1);
    EXPECT_TRUE(window_->state().tour && window_->state().tour->is_last);
    window_->perform(view::EndTour {});
    EXPECT_FALSE(window_->state().tour);
    ASSERT_TRUE(window_->close());
    bool is_exported = false;
    for (auto const& entry : fs::directory_iterator(folder_))
        is_exported |= entry.path().extension() == ".glb";
    EXPECT_TRUE(is_exported);
}

TEST_P(TourInWindow, EndsWhileTheHandDraws)
{
    advance(60);
    EXPECT_EQ(step(), 1u);
    window_->perform(view::EndTour {});
    advance(1);
    EXPECT_FALSE(window_->state().tour);
    EXPECT_FALSE(window_->state().is_hand_simulated);
    auto const strokes = window_->document().stroke_count();
    draw({ -50, 0 }, { 50, 0 });
    EXPECT_EQ(window_->document().stroke_count(), strokes + 1) << "the user draws with own devices";
}

TEST_P(TourInWindow, IgnoresTheUsersPenWhileTheHandDraws)
{
    draw({ -50, 0 }, { 50, 0 });
    EXPECT_EQ(step(), 1u);
    auto const ours = window_->document().stroke_count();
    watch_the_hand();
    advance(60);
    EXPECT_LE(ours, 1u);
    EXPECT_EQ(window_->document().stroke_count(), 2u) << "the hand's trunk and crown";
}

TEST_P(TourInWindow, CanBeSkippedStepByStep)
{
    for (int i = 0; i < 20; ++i) {
        window_->perform(view::SkipTourStep {});
        advance(1);
    }
    EXPECT_TRUE(window_->state().tour && window_->state().tour->is_last);
    EXPECT_FALSE(window_->state().is_hand_simulated);
}

INSTANTIATE_TEST_SUITE_P(Users, TourInWindow, testing::Bool(), [](auto const& test) {
    return std::string(test.param ? "WithTablet" : "WithMouse");
});

} // namespace
} // namespace tractus::controllers
