// Tests of a mouse that draws while the program stalls: one press must give one stroke, and moving
// the surface by the mouse wheel must never be reported as a broken sensor.

#include "app/controllers/live_window.h"
#include "app/methods/all_methods.h"
#include "app/methods/indicators/indicate_tool.h"
#include "calib/height_monitor.h"
#include "drivers/height_decoders.h"
#include "drivers/logs/log.h"
#include "drivers/reports/height_decoder.h"
#include "engine/base/random.h"
#include "tests/app/replayed.h"
#include "tests/app/simple_rig.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/core.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace tractus::controllers {
namespace {

using namespace std::chrono_literals;

// A window in which the mouse draws frame by frame, with a clock that the test controls.
class Evening {
public:
    explicit Evening(std::filesystem::path recording = {})
    {
        auto const clock = [now = now_] { return *now; };
        LiveWindowOptions options { .methods = methods::all_methods(),
                                    .scene = small_scene(),
                                    .recording = std::move(recording),
                                    .now = clock };
        options.mouse.emplace(clock);
        window_.emplace(
            LiveWindow::create(devices::LiveDevices::start({}).value(), std::move(options))
                .value());
        window_->perform(view::ChooseTool { indicators::IndicateTool {} });
        for (int i = 0; i < 30; ++i)
            frame({});
    }

    // Runs one frame, with the mouse's movement since the previous frame. The program may stall
    // before it takes the devices' reports, or after that and before it handles the mouse.
    void frame(std::vector<view::MousePen> path, Duration stall_before = {},
               Duration stall_within = {})
    {
        *now_ += 16ms + stall_before;
        window_->advance(16ms);
        trouble_ += window_->state().trouble;
        *now_ += 1ms + stall_within;
        if (!path.empty())
            window_->perform(view::MoveMousePen { std::move(path) });
    }

    static view::MousePen at(double x_mm, bool touching)
    {
        return { .place_mm = { x_mm, 20 }, .in_range = true, .touching = touching };
    }

    // Draws a stroke of 39 mm in 60 frames: presses, drags, rests, drags and releases the mouse.
    // The program stalls in one frame. While pressed, a resting mouse also reports in each frame.
    void draw(int stalled, Duration before, Duration within)
    {
        for (int i = 0; i <= 60; ++i)
            frame({ at(i < 20 ? i : std::max(20, i - 20), i < 60) }, i == stalled ? before : 0ms,
                  i == stalled ? within : 0ms);
        rest();
    }

    // Runs frames until everything drawn is processed and shown.
    void rest()
    {
        for (int i = 0; i < 30; ++i)
            frame({});
        window_->settle();
    }

    LiveWindow& window() { return *window_; }
    std::string const& trouble() const { return trouble_; }

private:
    std::shared_ptr<Timestamp> now_ = std::make_shared<Timestamp>(1s);
    std::optional<LiveWindow> window_;
    std::string trouble_;
};

TEST(MouseStall, OnePressIsOneStrokeHoweverLongTheProgramStalls)
{
    for (Duration const stall :
         { Duration(60ms), Duration(300ms), Duration(2s), Duration(20s), Duration(60s) })
        for (int const stalled : { 0, 1, 30, 59, 60 })
            for (bool const is_within : { false, true }) {
                Evening evening;
                evening.draw(stalled, is_within ? 0ms : stall, is_within ? stall : 0ms);
                auto const where = fmt::format("{} s in frame {}, {} it", to_seconds(stall),
                                               stalled, is_within ? "within" : "before");
                auto const& window = evening.window();
                EXPECT_EQ(window.station().counts().strokes, 1u) << where;
                ASSERT_EQ(window.scene().indicators.size(), 1u) << where;
                auto const& arrow = window.scene().indicators[0].what;
                EXPECT_NEAR((arrow.start_mm - Vec3(0, 20, 100)).norm(), 0, 0.3) << where;
                EXPECT_NEAR((arrow.end_mm - Vec3(39, 20, 100)).norm(), 0, 0.3) << where;
                EXPECT_EQ(evening.trouble(), "") << where;
            }
}

TEST(MouseStall, ASlowMachineDrawsOneStrokeAPress)
{
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        Random random({ .seed = seed });
        Evening evening;
        std::size_t presses = 0;
        for (; presses < 3; ++presses) {
            for (int i = 0; i <= 20; ++i) {
                evening.window().perform(view::MoveSurface { 20 * (random.uniform() - 0.5) });
                evening.frame({ Evening::at(3 * i, i < 20), Evening::at(3 * i + 1, i < 20) },
                              Duration(static_cast<std::int64_t>(4e8 * random.uniform())),
                              Duration(static_cast<std::int64_t>(4e8 * random.uniform())));
            }
        }
        evening.rest();
        EXPECT_EQ(evening.window().station().counts().strokes, presses) << "seed " << seed;
        EXPECT_EQ(evening.trouble(), "") << "seed " << seed;
    }
}

TEST(MouseStall, ItsRecordingHasTimesInOrderAndReplaysToTheSame)
{
    auto const path = std::filesystem::temp_directory_path()
        / fmt::format("tractus_stall_{}.tractus-log", ::getpid());
    std::filesystem::remove(path);
    Vec3 end_mm;
    {
        Evening evening(path);
        evening.draw(30, 300ms, 60s);
        end_mm = evening.window().scene().indicators.at(0).what.end_mm;
    }
    auto const log = drivers::read_log(path).value();
    EXPECT_TRUE(std::is_sorted(log.records.begin(), log.records.end(),
                               [](auto const& a, auto const& b) { return a.time < b.time; }));
    auto const [counts, scene, strokes] = replayed(log);
    EXPECT_EQ(counts.strokes, 1u);
    ASSERT_EQ(scene.indicators.size(), 1u);
    EXPECT_EQ(scene.indicators[0].what.end_mm, end_mm);
    std::filesystem::remove(path);
}

// However the wheel is turned, the surface must not move faster than a hand could move it, and a
// stall must not make its sensor seem silent.
TEST(MouseStall, NoWheelIsFasterThanAHand)
{
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        Random random({ .seed = seed });
        auto now = Timestamp(1s);
        MouseRig mouse([&] { return now; });
        auto const surface = mouse.open_height();
        auto const decoder = drivers::make_height_decoder(surface->info()).value();
        calib::HeightMonitor monitor(MouseRig::rig());
        std::optional<drivers::HeightSample> last;
        for (int i = 0; i < 3000; ++i) {
            if (random.uniform() < 0.1) // A notch of the wheel is 5 mm.
                mouse.move_surface(5 * std::round(40 * (random.uniform() - 0.5)));
            now += random.uniform() < 0.002 ? Duration(5s) : Duration(16ms);
            while (auto const report = surface->read(Duration::zero()).value()) {
                std::vector<drivers::HeightSample> samples;
                ASSERT_TRUE(decoder->decode(*report, samples));
                monitor.push(samples.at(0));
                monitor.advance(samples[0].time);
                if (last) {
                    double const way_mm = std::abs(samples[0].counts - last->counts) / 200.0;
                    double const time_s = to_seconds(samples[0].time - last->time);
                    ASSERT_LE(way_mm, MouseRig::kFastest_mm_per_s * time_s + 0.02);
                }
                last = samples[0];
            }
        }
        EXPECT_EQ(monitor.total(calib::HeightFaultKind::Silence).count, 0u) << "seed " << seed;
        EXPECT_EQ(monitor.total(calib::HeightFaultKind::Stuck).count, 0u) << "seed " << seed;
    }
}

} // namespace
} // namespace tractus::controllers
