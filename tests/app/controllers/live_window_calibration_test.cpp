#include "app/calibration/simulated_calibration.h"
#include "calib/rig_file.h"
#include "tests/app/controllers/live_window_devices.h"

#include <filesystem>
#include <fmt/core.h>
#include <fstream>
#include <gtest/gtest.h>
#include <unistd.h>

namespace tractus::controllers {
namespace {

namespace fs = std::filesystem;

// Fixture that plays the actions of a simulated person who calibrates the simulated rig, including
// those of the pen.
class CalibratesInTheWindow : public testing::Test {
protected:
    void SetUp() override
    {
        folder_ = fs::temp_directory_path() / fmt::format("tractus_calibrates_{}", ::getpid());
        fs::create_directories(folder_);
        std::ofstream log(folder_ / "hand.tractus-log");
        EXPECT_TRUE(calibration::write_simulated_calibration(
            log, { .geometry = calibration::simulated_geometry() }));
    }
    void TearDown() override { fs::remove_all(folder_); }

    LiveWindow window()
    {
        auto const now = std::make_shared<Timestamp>();
        LiveWindowOptions options { .methods = methods::all_methods(),
                                    .rig_file = folder_ / "my" / "table.rig.toml",
                                    .scene = small_scene(),
                                    .now = [now] { return *now; },
                                    .counted_time = now };
        auto devices
            = devices::LiveDevices::play_log((folder_ / "hand.tractus-log").string(), options.now)
                  .value();
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
    calibration->perform(calibration::KeepRig {});
    window.advance(std::chrono::milliseconds(16));
    window.perform(view::CloseCalibration {});
    EXPECT_EQ(window.calibration(), nullptr);
    auto const kept = calib::load_rig(folder_ / "my" / "table.rig.toml");
    ASSERT_TRUE(kept) << kept.error().message;
    auto const heights = calib::calibrated_heights(*kept).value();
    EXPECT_NEAR(heights.high_mm, 400, 5);
    EXPECT_NEAR(window.state().volume_mm.max_mm.z(), heights.high_mm, 1e-6)
        << "the pen draws by it at once";
}

TEST_F(CalibratesInTheWindow, ShowsTheDevicesRawValuesOnceTheyAreWatched)
{
    auto window = this->window();
    window.advance(std::chrono::milliseconds(500));
    EXPECT_TRUE(window.state().devices.readings.empty());
    window.perform(view::WatchDevices { true });
    for (int i = 0; i < 60; ++i)
        window.advance(std::chrono::milliseconds(16));
    auto const& readings = window.state().devices.readings;
    ASSERT_EQ(readings.size(), 2u);
    EXPECT_GT(readings[0].reports, 10u);
    EXPECT_TRUE(readings[1].last.has_value());
    EXPECT_FALSE(readings[1].fields.empty());
    window.perform(view::WatchDevices { false });
    EXPECT_TRUE(window.state().devices.readings.empty());
}

} // namespace
} // namespace tractus::controllers
