#include "app/play/simulated_hand.h"

#include "app/controllers/live_window.h"
#include "app/devices/live_devices.h"
#include "app/methods/all_methods.h"
#include "calib/height_monitor.h"
#include "calib/rig_file.h"
#include "drivers/height_decoders.h"
#include "drivers/reports/height_decoder.h"
#include "tests/app/simple_rig.h"
#include "tests/app/simulated_drawing.h"

#include <gtest/gtest.h>
#include <memory>

namespace tractus::play {
namespace {

using namespace std::chrono_literals;

class HandOnAClock : public testing::Test {
protected:
    std::shared_ptr<drivers::Log const> log_ = std::make_shared<drivers::Log const>(recorded_log());
    Timestamp now_ { 1000s };
    SimulatedHand hand_ { log_, [this] { return now_; } };
    std::vector<std::unique_ptr<drivers::ReportSource>> sources_ = hand_.open_sources();

    // Returns the reports that a device sends within `time`, if they are read every 16 ms.
    std::vector<drivers::RawReport> read(std::size_t device, Duration time)
    {
        std::vector<drivers::RawReport> reports;
        for (auto const end = now_ + time; now_ < end; now_ += 16ms)
            while (auto const report = sources_[device]->read(Duration::zero()).value())
                reports.push_back(*report);
        return reports;
    }
};

TEST_F(HandOnAClock, WaitsAndThenSendsWhatWasRecorded)
{
    EXPECT_TRUE(read(0, 10s).empty()) << "nobody has begun";
    EXPECT_TRUE(hand_.take_tools().empty());
    hand_.begin();
    auto const begun = now_;
    auto const reports = read(0, log_->end() - log_->begin() + 1s);
    auto const tools = hand_.take_tools();
    std::size_t next = 0;
    for (auto const& record : log_->records) {
        if (record.device != 0)
            continue;
        ASSERT_LT(next, reports.size());
        EXPECT_EQ(reports[next].received - begun, record.time - log_->begin());
        auto const sent = reports[next++].bytes();
        auto const recorded = log_->report(record);
        EXPECT_TRUE(std::equal(sent.begin(), sent.end(), recorded.begin(), recorded.end()));
    }
    EXPECT_EQ(next, reports.size()) << "and nothing afterwards";
    ASSERT_EQ(tools.size(), log_->tools.size());
    EXPECT_EQ(tools.back().tool, log_->tools.back().tool);
    EXPECT_EQ(tools.back().time - begun, log_->tools.back().time - log_->begin());
}

TEST_F(HandOnAClock, HasAHeightSensorThatLivesBeforeAndAfter)
{
    auto const decoder = drivers::make_height_decoder(log_->devices[1]).value();
    calib::HeightMonitor monitor(calib::parse_rig(log_->rig_text, "log").value());
    auto const is_well_for = [&](Duration time) {
        for (auto const& report : read(1, time)) {
            std::vector<drivers::HeightSample> samples;
            EXPECT_TRUE(decoder->decode(report, samples));
            for (auto const& sample : samples)
                monitor.push(sample);
        }
        monitor.advance(now_);
        return !monitor.present();
    };
    EXPECT_TRUE(is_well_for(30s));
    hand_.begin();
    EXPECT_TRUE(is_well_for(log_->end() - log_->begin() + 120s));
    now_ += 300ms; // The program stalls for 300 ms.
    EXPECT_TRUE(is_well_for(1s));
    for (auto const kind : { calib::HeightFaultKind::Silence, calib::HeightFaultKind::Jump,
                             calib::HeightFaultKind::Stuck })
        EXPECT_EQ(monitor.total(kind).count, 0u) << static_cast<int>(kind);
}

// Tests the simulated hand that `tractus draw --device simulated` uses.
TEST(SimulatedHand, DrawsOnTheStationsWindow)
{
    auto const now = std::make_shared<Timestamp>(1000s);
    auto const clock = [now] { return *now; };
    controllers::LiveWindowOptions options { .methods = methods::all_methods(),
                                             .scene = small_scene(),
                                             .now = clock };
    auto window = controllers::LiveWindow::create(devices::LiveDevices::play_hand(clock).value(),
                                                  std::move(options))
                      .value();
    std::string trouble;
    for (int i = 0; i < 60 * 40; ++i) {
        *now += 16ms;
        window.advance(16ms);
        trouble += window.state().trouble;
    }
    window.settle();
    EXPECT_EQ(window.station().counts().strokes, 13u);
    EXPECT_EQ(window.station().tool().kind().word, std::string("indicate"));
    EXPECT_EQ(window.scene().indicators.size(), 1u);
    EXPECT_EQ(trouble, "");
}

} // namespace
} // namespace tractus::play
