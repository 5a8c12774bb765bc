#include "drivers/logs/log_writer.h"
#include "engine/base/file.h"
#include "tests/app/commands/outcome.h"
#include "tests/drivers/devices.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <sstream>
#include <string>
#include <unistd.h>
#include <vector>

namespace tractus::commands {
namespace {

namespace fs = std::filesystem;

std::string const kHeader
    = "time_s,device,x_mm,y_mm,pressure,tilt_x_deg,tilt_y_deg,in_range,tip,eraser,buttons";

class DecodeCommand : public testing::Test {
protected:
    void SetUp() override { fs::create_directories(folder_); }
    void TearDown() override { fs::remove_all(folder_); }

    // Writes a log with reports, each given as the index of its device and its bytes in
    // hexadecimal.
    std::string write_log(std::vector<drivers::DeviceInfo> const& devices,
                          std::vector<std::pair<std::size_t, std::string>> const& reports)
    {
        std::ostringstream text;
        drivers::LogWriter writer(text, { .devices = devices });
        std::int64_t time_ns = 0;
        for (auto const& [device, report] : reports)
            writer.write_report(device, timestamp_ns(time_ns += 5'000'000), drivers::bytes(report));
        auto const path = folder_ / "pen.tractus-log";
        EXPECT_TRUE(write_file(path, text.str()));
        return path.string();
    }

    fs::path const folder_
        = fs::temp_directory_path() / ("tractus-decode-" + std::to_string(::getpid()));
};

TEST_F(DecodeCommand, PrintsOneRowPerSample)
{
    auto const log = write_log({ drivers::simple_pen(), drivers::simple_height_sensor() },
                               // The pen touches, with its first button pressed.
                               { { 0, "02 23 10 27 c4 09 ff 03 1e e2" },
                                 { 1, "01 34 02" },
                                 // The pen leaves the range.
                                 { 0, "02 00 00 00 00 00 00 00 00 00" } });
    auto const outcome = run({ "decode", log, "--csv", "--raw" });
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(outcome.out,
              kHeader
                  + ",x_raw,y_raw,pressure_raw\n"
                    "0.005000,0,100.0000,75.0000,0.49976,30.00,30.00,1,1,0,1,10000,2500,1023\n"
                    "0.015000,0,100.0000,75.0000,0.00000,30.00,30.00,0,0,0,0,10000,2500,0\n");
}

TEST_F(DecodeCommand, TellsTheEraserFromTheTip)
{
    auto const log
        = write_log({ drivers::simple_pen() }, { { 0, "02 30 10 27 c4 09 00 00 00 00" } });
    EXPECT_EQ(run({ "decode", log, "--csv" }).out,
              kHeader + "\n0.005000,0,100.0000,75.0000,0.00000,0.00,0.00,1,0,1,0\n");
}

TEST_F(DecodeCommand, LeavesEmptyWhatTheDeviceDoesNotSay)
{
    // A pen tablet that reports only the tip switch, X and Y.
    drivers::DeviceInfo const plain {
        .report_descriptor = drivers::bytes(
            "05 0d 09 02 a1 01 09 20 a1 00 09 42 15 00 25 01 75 01 95 01 81 02 95 07 81 03"
            "05 01 09 30 26 20 4e 46 c8 00 65 11 55 0f 75 10 95 01 81 02"
            "09 31 26 10 27 46 64 00 81 02 c0 c0")
    };
    auto const log = write_log({ plain }, { { 0, "01 10 27 c4 09" } });
    EXPECT_EQ(run({ "decode", log, "--csv", "--raw" }).out,
              kHeader
                  + ",x_raw,y_raw,pressure_raw\n0.005000,0,100.0000,75.0000,,,,,1,,,10000,2500,\n");
}

TEST_F(DecodeCommand, WritesToAFile)
{
    auto const log
        = write_log({ drivers::simple_pen() }, { { 0, "02 20 00 00 00 00 00 00 00 00" } });
    auto const csv = (folder_ / "pen.csv").string();
    auto const outcome = run({ "decode", log, "--csv", "-o", csv });
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(read_file(csv).value(),
              kHeader + "\n0.005000,0,0.0000,100.0000,0.00000,0.00,0.00,1,0,0,0\n");
}

TEST_F(DecodeCommand, SummarizesALog)
{
    auto const log = write_log({ drivers::simple_pen() },
                               { { 0, "02 21 10 27 c4 09 ff 03 00 00" },
                                 { 0, "02 21 11 27 c4 09 ff 03 00 00" },
                                 { 0, "02 20 12 27 c4 09 00 00 00 00" } });
    auto const outcome = run({ "decode", log });
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(
        outcome.out,
        log
            + ": 3 reports in 0.010 s\n"
              "device 0: Simple Pen (1209:0002), 3 reports\n"
              "  pen tablet, 200.0 x 100.0 mm, pressure to 2047, tilt, eraser, 2 barrel buttons\n"
              "  3 samples, typically 200 per second, 2 of them touching; strokes: 1\n");
}

TEST_F(DecodeCommand, FailsOnlyIfThereIsNoPenAtAll)
{
    auto const log = write_log(
        { { .name = "Pad", .report_descriptor = drivers::bytes("05 01") }, drivers::simple_pen() },
        { { 1, "02 21 10 27 c4 09 ff 03 00 00" } });
    auto const outcome = run({ "decode", log, "--csv" });
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.err,
              "warning: " + log
                  + ": device 0: Pad (0000:0000) is not a pen that describes itself: its "
                    "report descriptor has no X, Y and tip of a pen\n");

    auto const height = write_log({ drivers::simple_height_sensor() }, { { 0, "01 34 02" } });
    auto const failure = run({ "decode", height, "--csv" });
    EXPECT_EQ(failure.exit_code, 1);
    EXPECT_EQ(failure.out, "");
    EXPECT_EQ(failure.err,
              "error: there is no pen to decode in " + height + ": it has a height sensor alone\n");
}

TEST_F(DecodeCommand, FailsWhenNoReportIsWhatTheDescriptorSays)
{
    auto const log = write_log({ drivers::simple_pen() }, { { 0, "02 21 10" }, { 0, "02 21 10" } });
    auto const csv = folder_ / "pen.csv";
    auto const outcome = run({ "decode", log, "--csv", "-o", csv.string() });
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_EQ(outcome.err,
              "device error: " + log
                  + ":device 0: its reports are not what its report descriptor says, the "
                    "first at 0.005000 s: pen report 2: 3 bytes, expected 10\n");
    EXPECT_FALSE(fs::exists(csv));
}

TEST_F(DecodeCommand, WarnsOnceOfReportsThatItCouldNotDecode)
{
    auto const log
        = write_log({ drivers::simple_pen() },
                    { { 0, "02 21" }, { 0, "02 21 10 27 c4 09 ff 03 00 00" }, { 0, "02 21" } });
    auto const outcome = run({ "decode", log, "--csv" });
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.err,
              "warning: " + log
                  + ":device 0: 2 of 3 reports could not be decoded, the first at 0.005000 s: "
                    "pen report 2: 2 bytes, expected 10\n");
}

TEST_F(DecodeCommand, ReadsATruncatedLog)
{
    auto const log = write_log(
        { drivers::simple_pen() },
        { { 0, "02 21 10 27 c4 09 ff 03 00 00" }, { 0, "02 21 10 27 c4 09 ff 03 00 00" } });
    auto text = read_file(log).value();
    text.resize(text.size() - 10);
    ASSERT_TRUE(write_file(log, text));
    auto const outcome = run({ "decode", log, "--csv" });
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.out, kHeader + "\n0.005000,0,100.0000,75.0000,0.49976,0.00,0.00,1,1,0,0\n");
    EXPECT_EQ(outcome.err,
              "warning: " + log + ":6: the last line is cut off: a report is dropped\n");
}

TEST_F(DecodeCommand, CallsRawWithoutCsvWrongUsage)
{
    EXPECT_EQ(run({ "decode", "pen.hid", "--raw" }).exit_code, 2);
    EXPECT_EQ(run({ "decode" }).exit_code, 2);
}

TEST(DevicesCommand, PrintsJson)
{
    auto const outcome = run({ "devices", "--json" });
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_TRUE(outcome.out.starts_with("[")) << outcome.out;
}

} // namespace
} // namespace tractus::commands
