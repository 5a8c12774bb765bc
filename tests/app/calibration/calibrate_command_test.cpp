#include "calib/rig_file.h"
#include "engine/base/file.h"
#include "tests/app/commands/outcome.h"

#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <unistd.h>

namespace tractus::calibration {
namespace {

namespace fs = std::filesystem;

class CalibrateCommand : public testing::Test {
protected:
    void SetUp() override { fs::create_directories(folder_); }
    void TearDown() override { fs::remove_all(folder_); }

    std::string path(std::string const& name) const { return (folder_ / name).string(); }
    std::string text(std::string const& name) const { return read_file(path(name)).value(); }

    commands::Outcome calibrate(std::vector<std::string> arguments) const
    {
        arguments.insert(arguments.begin(), "calibrate");
        return commands::run(arguments);
    }

    // Returns the bend of the track as text, as it is written in a rig file; empty if the file has
    // none.
    std::string bend_in(std::string const& name) const
    {
        auto const rig = text(name);
        auto const begin = rig.find("\nbend = [");
        auto const end = rig.find("\n]", begin);
        return begin == std::string::npos ? "" : rig.substr(begin, end - begin);
    }

    fs::path folder_
        = fs::temp_directory_path() / ("tractus_calibrate_" + std::to_string(::getpid()));
};

TEST_F(CalibrateCommand, ReplaysALogToTheSameFileByteForByte)
{
    auto const live = calibrate({ "height", "--rig", path("live.rig.toml"), "--simulate", "--seed",
                                  "5", "--record", path("cal.tractus-log") });
    ASSERT_EQ(live.exit_code, 0) << live.err;
    auto const again
        = calibrate({ "height", "--rig", path("again.rig.toml"), path("cal.tractus-log") });
    ASSERT_EQ(again.exit_code, 0) << again.err;
    EXPECT_EQ(text("again.rig.toml"), text("live.rig.toml"));
    EXPECT_NE(text("again.rig.svg").find("Residuals: "), std::string::npos);
}

TEST_F(CalibrateCommand, ReplaysATiltToTheSameFileByteForByte)
{
    ASSERT_EQ(calibrate({ "height", "--rig", path("live.rig.toml"), "--simulate" }).exit_code, 0);
    fs::copy_file(path("live.rig.toml"), path("again.rig.toml"));
    auto const live = calibrate({ "tilt", "--rig", path("live.rig.toml"), "--simulate", "--seed",
                                  "5", "--record", path("tilt.tractus-log") });
    ASSERT_EQ(live.exit_code, 0) << live.err;
    auto const again
        = calibrate({ "tilt", "--rig", path("again.rig.toml"), path("tilt.tractus-log") });
    ASSERT_EQ(again.exit_code, 0) << again.err;
    EXPECT_EQ(text("again.rig.toml"), text("live.rig.toml"));
    EXPECT_NE(text("live.rig.toml").find("\ncoil_height_mm = ["), std::string::npos);
}

TEST_F(CalibrateCommand, DoesAllProceduresOneAfterAnother)
{
    for (auto const* procedure : { "height", "travel", "latency", "tilt", "check", "zero" }) {
        auto const outcome = calibrate({ procedure, "--rig", path("my.rig.toml"), "--simulate" });
        ASSERT_EQ(outcome.exit_code, 0) << procedure << ": " << outcome.err;
        EXPECT_NE(outcome.out.find("my.rig.toml: written\n"), std::string::npos);
    }
    auto const rig = calib::load_rig(path("my.rig.toml")).value();
    EXPECT_TRUE(rig.calibration.height && rig.calibration.travel && rig.calibration.latency
                && rig.calibration.tilt && rig.calibration.check);
    EXPECT_NEAR(rig.coil_height_mm.x(), 9, 0.1);
    EXPECT_TRUE(fs::exists(path("my.rig.toml.bak")));
}

// All calibration procedures must keep the bend of the track in the rig file, like the rest of the
// rig.
TEST_F(CalibrateCommand, KeepsATrackThatIsBent)
{
    auto const outcome
        = calibrate({ "height", "--rig", path("my.rig.toml"), "--simulate", "--linearity", "0.25",
                      "--heights", "0,60,120,200,280,340,400" });
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("(0.25 % by its data sheet)"), std::string::npos) << outcome.out;
    auto const first = calib::load_rig(path("my.rig.toml")).value();
    EXPECT_FALSE(calib::bend_of(first.height_model).empty());
    ASSERT_TRUE(first.calibration.height);
    EXPECT_EQ(first.calibration.height->linearity_percent, 0.25);
    auto const bend = bend_in("my.rig.toml");
    EXPECT_NE(bend, "");
    for (auto const* procedure : { "travel", "latency", "check" })
        ASSERT_EQ(calibrate({ procedure, "--rig", path("my.rig.toml"), "--simulate" }).exit_code, 0)
            << procedure;
    EXPECT_EQ(bend_in("my.rig.toml"), bend);
    auto const zeroed = calibrate({ "zero", "--rig", path("my.rig.toml"), "--simulate" });
    ASSERT_EQ(zeroed.exit_code, 0) << zeroed.err;
    EXPECT_EQ(bend_in("my.rig.toml"), bend);
}

TEST_F(CalibrateCommand, KeepsTheOldFileWhenTheCalibrationIsRefused)
{
    ASSERT_EQ(calibrate({ "height", "--rig", path("my.rig.toml"), "--simulate" }).exit_code, 0);
    auto const before = text("my.rig.toml");
    auto const outcome = calibrate(
        { "height", "--rig", path("my.rig.toml"), "--simulate", "--heights", "100,101" });
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_NE(outcome.err.find("are at one height, 100 to 101 mm: move the surface"),
              std::string::npos)
        << outcome.err;
    EXPECT_EQ(text("my.rig.toml"), before);
}

TEST_F(CalibrateCommand, RefusesFewerCapturesThanParameters)
{
    auto const outcome = calibrate({ "height", "--rig", path("my.rig.toml"), "--simulate",
                                     "--heights", "0,200,400", "--model", "string" });
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_NE(outcome.err.find("a string model has 4 parameters and there are only 3 captures"),
              std::string::npos)
        << outcome.err;
    EXPECT_FALSE(fs::exists(path("my.rig.toml")));
}

// "check" needs a rig with calibrated heights; "tilt" needs only an existing rig.
TEST_F(CalibrateCommand, WantsTheHeightsFirst)
{
    for (auto const& [what, why] : { std::pair { "check", "needs the heights in it" },
                                     std::pair { "tilt", "only adds to a rig that is there" } }) {
        auto const outcome = calibrate({ what, "--rig", path("my.rig.toml"), "--simulate" });
        EXPECT_EQ(outcome.exit_code, 1);
        EXPECT_NE(outcome.err.find(fmt::format("is not there, and calibrate {} {}: use \"tractus "
                                               "calibrate height --rig ",
                                               what, why)),
                  std::string::npos)
            << outcome.err;
    }
}

TEST_F(CalibrateCommand, RefusesARigOfALaterVersion)
{
    std::ofstream(path("my.rig.toml")) << "version = 99\n";
    auto const outcome = calibrate({ "height", "--rig", path("my.rig.toml"), "--simulate" });
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_NE(outcome.err.find("a later tractus wrote this file, so use that one to read it"),
              std::string::npos)
        << outcome.err;
    EXPECT_EQ(text("my.rig.toml"), "version = 99\n");
}

TEST_F(CalibrateCommand, RefusesHeightsThatTheSimulatedRigDoesNotHave)
{
    auto const outcome = calibrate(
        { "height", "--rig", path("my.rig.toml"), "--simulate", "--heights", "0,4000" });
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_NE(outcome.err.find("the simulated rig has no height of 4000 mm"), std::string::npos)
        << outcome.err;
}

// A log played at its recorded speed serves as live devices. Its pen rests on the tablet at each
// height.
TEST_F(CalibrateCommand, CalibratesLiveDevicesByTheirPen)
{
    ASSERT_EQ(calibrate({ "height", "--rig", path("a.rig.toml"), "--simulate", "--heights",
                          "100,250", "--record", path("played.tractus-log") })
                  .exit_code,
              0);
    auto const live = calibrate({ "height", "--rig", path("live.rig.toml"), "--device",
                                  path("played.tractus-log"), "--heights", "100,250", "--record",
                                  path("live.tractus-log") });
    ASSERT_EQ(live.exit_code, 0) << live.err;
    ASSERT_EQ(calibrate({ "height", "--rig", path("again.rig.toml"), path("live.tractus-log") })
                  .exit_code,
              0);
    EXPECT_EQ(text("again.rig.toml"), text("live.rig.toml"));
}

} // namespace
} // namespace tractus::calibration
