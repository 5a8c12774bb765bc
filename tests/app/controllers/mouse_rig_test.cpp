#include "app/controllers/mouse_rig.h"
#include "app/methods/all_methods.h"

#include "app/controllers/live_window.h"
#include "app/methods/indicators/indicate_tool.h"
#include "calib/height_model.h"
#include "calib/height_monitor.h"
#include "drivers/height_decoders.h"
#include "drivers/reports/height_decoder.h"
#include "drivers/tablets/pen_decoders.h"
#include "tests/app/simple_rig.h"
#include "tests/drivers/decode_one.h"

#include <array>
#include <chrono>
#include <gtest/gtest.h>
#include <thread>

namespace tractus::controllers {
namespace {

TEST(MouseRig, SendsTheMouseAsATabletDoes)
{
    auto now = at_ms(100);
    MouseRig mouse([&] { return now; });
    auto const tablet = mouse.open_tablet();
    auto const decoder = drivers::make_pen_decoder(tablet->info()).value();
    EXPECT_FALSE(tablet->read(Duration::zero()).value()) << "nothing has moved yet";

    now = at_ms(120);
    mouse.move_pen(std::array {
        sim::TabletPen { .place_mm = { 10, 20 }, .in_range = true },
        sim::TabletPen {
            .place_mm = { 30, 20 }, .in_range = true, .touching = true, .pressure = 0.5 },
    });
    auto const first = tablet->read(Duration::zero()).value().value();
    auto const second = tablet->read(Duration::zero()).value().value();
    EXPECT_EQ(first.received, at_ms(110)) << "spread over the time since the last one";
    EXPECT_EQ(second.received, at_ms(120));
    auto const hovering
        = drivers::decode_one(*decoder, first.received, first.bytes()).value().value();
    EXPECT_TRUE(hovering.in_range && !hovering.touching);
    EXPECT_NEAR((hovering.position_mm - Vec2(10, 20)).norm(), 0, 0.02);
    auto const touching
        = drivers::decode_one(*decoder, second.received, second.bytes()).value().value();
    EXPECT_TRUE(touching.touching && !touching.eraser);
    EXPECT_NEAR(touching.pressure.value(), 0.5, 0.001);

    mouse.move_pen(std::array { sim::TabletPen {} });
    auto const gone = tablet->read(Duration::zero()).value().value();
    EXPECT_FALSE(drivers::decode_one(*decoder, gone.received, gone.bytes()).value()->in_range);
}

TEST(MouseRig, GlidesToWhereItsSurfaceShallBe)
{
    auto now = at_ms(100);
    MouseRig mouse([&] { return now; });
    auto const surface = mouse.open_height();
    auto const decoder = drivers::make_height_decoder(surface->info()).value();
    auto const rig = MouseRig::rig();
    auto const read_mm = [&] {
        now += MouseRig::kHeightPeriod;
        auto const report = surface->read(Duration::zero()).value().value();
        std::vector<drivers::HeightSample> samples;
        EXPECT_TRUE(decoder->decode(report, samples));
        return calib::height_mm(rig.height_model, samples.at(0).counts).value();
    };
    auto const read_later_mm = [&] {
        double last_mm = 0;
        for (int i = 0; i < 120; ++i)
            last_mm = read_mm();
        return last_mm;
    };
    EXPECT_NEAR(read_mm(), 0, 0.01);
    EXPECT_FALSE(surface->read(Duration::zero()).value()) << "not yet due";
    mouse.move_surface(123.4);
    double const soon_mm = read_mm();
    EXPECT_GT(soon_mm, 1);
    EXPECT_LT(soon_mm, 30) << "no surface jumps";
    EXPECT_NEAR(read_later_mm(), 123.4, 0.01);
    mouse.move_surface(1000);
    EXPECT_NEAR(read_later_mm(), MouseRig::kTop_mm, 0.01);
    mouse.move_surface(-1000);
    EXPECT_NEAR(read_later_mm(), 0, 0.01);
    mouse.set_surface(50);
    EXPECT_NEAR(read_mm(), 50, 0.01) << "was put there";
}

TEST(MouseRig, MayRestWithoutBeingTakenForBroken)
{
    auto now = at_ms(100);
    MouseRig mouse([&] { return now; });
    auto const surface = mouse.open_height();
    auto const decoder = drivers::make_height_decoder(surface->info()).value();
    for (double const height_mm : { 0.0, 120.0, MouseRig::kTop_mm }) {
        mouse.set_surface(height_mm);
        calib::HeightMonitor monitor(MouseRig::rig());
        std::vector<drivers::HeightSample> samples;
        for (auto const until = now + std::chrono::minutes(2); now < until;) {
            now += MouseRig::kHeightPeriod;
            auto const report = surface->read(Duration::zero()).value().value();
            samples.clear();
            ASSERT_TRUE(decoder->decode(report, samples));
            monitor.push(samples.at(0));
            ASSERT_FALSE(monitor.present()) << calib::describe_fault(*monitor.present());
            auto const counts = samples.at(0).counts;
            ASSERT_GE(counts, MouseRig::rig().calibrated_min_counts);
            ASSERT_LE(counts, MouseRig::rig().calibrated_max_counts);
        }
    }
}

Timestamp clock_now()
{
    return Timestamp(std::chrono::steady_clock::now().time_since_epoch());
}

// Advances the window until `done` returns true, without a time limit, since the machine may be
// loaded.
template<typename Done> void advance_until(LiveWindow& window, Done const& done)
{
    while (!done()) {
        window.advance(std::chrono::milliseconds(16));
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
}

TEST(LiveWindow, LetsAMouseDrawWhereThereIsNothingElse)
{
    LiveWindowOptions options { .methods = methods::all_methods(),
                                .scene = small_scene(),
                                .now = clock_now };
    options.mouse.emplace(clock_now);
    auto window
        = LiveWindow::create(devices::LiveDevices::start({}).value(), std::move(options)).value();
    EXPECT_TRUE(window.state().mouse_draws);
    EXPECT_TRUE(window.state().mouse_moves_surface);
    auto const at_surface = [&](double height_mm) {
        return std::abs(window.state().surface_height_mm - height_mm) < 0.6;
    };
    advance_until(window, [&] { return at_surface(100); });
    window.perform(view::MoveSurface { 50 });
    advance_until(window, [&] { return at_surface(150); });
    EXPECT_TRUE(at_surface(150)) << "seen before a pen is there";
    auto const heights = [&] { return window.station().counts().height_samples; };
    // Heights come every 5 ms, so 40 of them outlast the last glide.
    auto const still = heights() + 40;
    advance_until(window, [&] { return heights() >= still; });

    window.perform(view::ChooseTool { indicators::IndicateTool {} });
    for (int i = 0; i <= 10; ++i) {
        window.perform(view::MoveMousePen {
            { { .place_mm = { -50.0 + 10 * i, 20 }, .in_range = true, .touching = i < 10 } } });
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        window.advance(std::chrono::milliseconds(16));
    }
    advance_until(window, [&] { return !window.scene().indicators.empty(); });
    ASSERT_EQ(window.scene().indicators.size(), 1u);
    auto const& indicator = window.scene().indicators[0].what;
    EXPECT_NEAR((indicator.start_mm - Vec3(-50, 20, 150)).norm(), 0, 0.3);
    EXPECT_NEAR((indicator.end_mm - Vec3(40, 20, 150)).norm(), 0, 0.3);
}

TEST(LiveWindow, LetsAMouseMoveTheSurfaceUnderATablet)
{
    class SilentTablet final : public drivers::ReportSource {
    public:
        drivers::DeviceInfo const& info() const override { return info_; }
        Result<std::optional<drivers::RawReport>> read(Duration timeout) override
        {
            std::this_thread::sleep_for(timeout);
            return std::optional<drivers::RawReport>();
        }

    private:
        drivers::DeviceInfo info_ = drivers::simple_pen();
    };
    std::vector<std::unique_ptr<drivers::ReportSource>> sources;
    sources.push_back(std::make_unique<SilentTablet>());
    LiveWindowOptions options { .methods = methods::all_methods(),
                                .height_mm = 200,
                                .scene = small_scene(),
                                .now = clock_now };
    options.mouse.emplace(clock_now);
    auto window = LiveWindow::create(devices::LiveDevices::start(std::move(sources)).value(),
                                     std::move(options))
                      .value();
    EXPECT_FALSE(window.state().mouse_draws);
    EXPECT_TRUE(window.state().mouse_moves_surface);
    auto const is_at_200 = [&] { return std::abs(window.state().surface_height_mm - 200) < 0.01; };
    advance_until(window, is_at_200);
    EXPECT_TRUE(is_at_200());
}

} // namespace
} // namespace tractus::controllers
