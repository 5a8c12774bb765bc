#include "drivers/logs/log.h"
#include "tests/app/command_line/workshop.h"

#include <gtest/gtest.h>

namespace tractus {
namespace {

class RecordCommand : public Workshop { };

constexpr char const* kProgram = "'" TRACTUS_PROGRAM "'";

// Returns a shell command that waits until the file contains `count` reports, or until the program
// that writes the file has ended. It has no time limit, since the machine may be busy. A missing
// file counts as one without reports.
std::string wait_for_reports(std::string const& file, int count)
{
    return "until [ \"$(grep -cs '^E' " + file + ")\" -ge " + std::to_string(count)
        + " ] 2>/dev/null; do kill -0 $pid || break; sleep 0.02; done; ";
}

TEST_F(RecordCommand, LosesNothingThatHasComeWhenItIsKilled)
{
    auto const outcome
        = run(std::string(kProgram) + " record --device simulated -o live.tractus-log & pid=$!; "
              + wait_for_reports("live.tractus-log", 200) + "kill -9 $pid; wait $pid");
    EXPECT_EQ(outcome.exit_code, 128 + 9) << outcome.err;
    auto const log = drivers::parse_log(read("live.tractus-log"), "live.tractus-log");
    ASSERT_TRUE(log) << log.error().message;
    EXPECT_GE(log->records.size(), 200u);
    EXPECT_EQ(log->devices.size(), 2u);
    EXPECT_FALSE(log->rig_text.empty());
    EXPECT_LE(log->warning_count, 1u); // The last line may have been truncated.
    EXPECT_EQ(run("tractus decode live.tractus-log").exit_code, 0);
}

TEST_F(RecordCommand, EndsWellWhenItIsInterrupted)
{
    auto const outcome
        = run(std::string(kProgram) + " record --device simulated -o live.tractus-log & pid=$!; "
              + wait_for_reports("live.tractus-log", 20) + "kill -TERM $pid; wait $pid");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("live.tractus-log: "), std::string::npos) << outcome.out;
    EXPECT_EQ(drivers::parse_log(read("live.tractus-log"), "log")->warning_count, 0u);
}

TEST_F(RecordCommand, MixesLogs)
{
    write("a.hid", "R: 1 c0\nN: a\nE: 5.0 1 01\nE: 5.01 1 02\n");
    write("b.hid", "R: 1 c0\nN: b\nE: 0.0 1 03\n");
    auto const outcome = run("tractus record --device a.hid b.hid -o both.tractus-log");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "both.tractus-log: 3 reports\n");
    auto const log = drivers::parse_log(read("both.tractus-log"), "both.tractus-log").value();
    ASSERT_EQ(log.devices.size(), 2u);
    EXPECT_EQ(log.devices[1].name, "b");
}

TEST_F(RecordCommand, ReplaysAtAnyPaceToTheSame)
{
    record();
    for (std::string const name : { "at_once", "paced" }) {
        auto const outcome = run("tractus replay hand.tractus-log --plant small.l --count 1 -o "
                                 + name + (name == "paced" ? " --speed 50" : ""));
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    }
    EXPECT_FALSE(read("at_once/collection.glb").empty());
    EXPECT_EQ(read("at_once/collection.glb"), read("paced/collection.glb"));
    expect_error(run("tractus replay hand.tractus-log --plant small.l --speed 0"), 2, "'0'");
}

TEST_F(RecordCommand, SaysWhichDeviceIsNotThere)
{
    expect_error(run("tractus record -o x --device /dev/hidraw999"), 1,
                 "there is no device at /dev/hidraw999");
    expect_error(run("tractus record -o x --device tablet"), 1,
                 "'tablet' is not the address of a device: expected /dev/hidrawN");
    EXPECT_FALSE(exists("x"));
}

} // namespace
} // namespace tractus
