#include "app/calibration/live_calibration.h"

#include "app/calibration/simulated_calibration.h"
#include "engine/base/file.h"
#include "tests/app/simple_rig.h"

#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>
#include <sstream>
#include <thread>
#include <unistd.h>

namespace tractus::calibration {
namespace {

// A sensor that is connected by a loose cable and sends nothing.
class SilentSensor final : public drivers::ReportSource {
public:
    drivers::DeviceInfo const& info() const override { return info_; }
    Result<std::optional<drivers::RawReport>> read(Duration) override
    {
        std::this_thread::yield();
        return std::optional<drivers::RawReport>();
    }

private:
    drivers::DeviceInfo info_ = drivers::simple_height_sensor();
};

// A simulated person at a terminal, with a clock that advances when the program sleeps.
class Talk {
public:
    // The person presses `keys`, and then `last` once the program has printed the text `awaited`.
    Talk(std::string keys, std::string awaited, char last)
        : keys_(std::move(keys))
        , awaited_(std::move(awaited))
        , last_(last)
    {
    }

    CalibrationPerson person()
    {
        return { .key = [this] { return key(); },
                 .say = [this](std::string const& line) { said_ += line + "\n"; },
                 .show = [](std::string const&) {} };
    }

    LiveCalibrationOptions options(std::vector<double> heights_mm)
    {
        return { .heights_mm = std::move(heights_mm),
                 .now = [this] { return now_; },
                 .rest = [this](Duration duration) { now_ += duration; } };
    }

    std::function<Timestamp()> clock()
    {
        return [this] { return now_; };
    }
    std::string const& said() const { return said_; }
    Timestamp now() const { return now_; }

private:
    std::optional<char> key()
    {
        if (!keys_.empty()) {
            char const first = keys_.front();
            keys_.erase(0, 1);
            return first;
        }
        if (last_ == 0 || said_.find(awaited_) == std::string::npos)
            return std::nullopt;
        return std::exchange(last_, 0);
    }

    std::string keys_;
    std::string awaited_;
    char last_ = 0;
    std::string said_;
    Timestamp now_ {};
};

// Calibrates with a SilentSensor. Returns false if the person quit.
bool calibrate_silent_sensor(Talk& talk)
{
    std::vector<std::unique_ptr<drivers::ReportSource>> sources;
    sources.push_back(std::make_unique<SilentSensor>());
    auto devices = devices::LiveDevices::start(std::move(sources)).value();
    auto controller = CalibrationController::create(devices.infos(), {}).value();
    std::atomic<bool> const stop = false;
    return calibrate_live(controller, devices, talk.person(), talk.options({}), stop).value();
}

TEST(LiveCalibration, SaysThatTheSensorFellSilentDuringACapture)
{
    Talk talk("0\n", "fell silent", 'q');
    EXPECT_FALSE(calibrate_silent_sensor(talk));
    EXPECT_NE(talk.said().find("the height sensor fell silent during the capture: check its plug "
                               "and its cable, then capture again\n"),
              std::string::npos)
        << talk.said();
}

TEST(LiveCalibration, LetsAPersonLeaveDuringACapture)
{
    Talk talk("0\nq", "", 0);
    EXPECT_FALSE(calibrate_silent_sensor(talk));
    EXPECT_LT(talk.now(), at_ms(1000));
}

TEST(LiveCalibration, TellsWhyItDoesNotFitDuringACapture)
{
    Talk talk("0\nfu", "0 captures are left", 'q');
    EXPECT_FALSE(calibrate_silent_sensor(talk));
    EXPECT_NE(talk.said().find("a capture is under way: wait a second for its end, or press u to "
                               "give it up\n  0 captures are left\n"),
              std::string::npos)
        << talk.said();
}

TEST(LiveCalibration, OffersToMeasureAgainWhatDisagrees)
{
    auto const file = std::filesystem::temp_directory_path()
        / ("tractus_live_calibration_" + std::to_string(::getpid()) + ".tractus-log");
    SimulatedCalibration const simulated { .geometry = simulated_geometry() };
    std::ostringstream text;
    ASSERT_TRUE(write_simulated_calibration(text, simulated));
    ASSERT_TRUE(write_file(file, text.str()));

    Talk talk("", "disagrees", 'f');
    auto devices = devices::LiveDevices::play_log(file.string(), talk.clock()).value();
    std::filesystem::remove(file);
    auto controller = CalibrationController::create(devices.infos(), {}).value();
    auto heights_mm = proposed_heights_mm(CalibrationProcedure::Height);
    heights_mm[2] += 20; // The person states this height wrongly.
    std::atomic<bool> const stop = false;
    EXPECT_TRUE(
        calibrate_live(controller, devices, talk.person(), talk.options(heights_mm), stop).value());
    EXPECT_NE(talk.said().find("capture 3 (220 mm) disagrees with the others"), std::string::npos)
        << talk.said();
    EXPECT_NE(talk.said().find("(f does without them)\nSet the surface to 220 mm"),
              std::string::npos)
        << talk.said();
    EXPECT_EQ(controller.captures().size(), 6u);
    EXPECT_FALSE(controller.doubt());
}

} // namespace
} // namespace tractus::calibration
