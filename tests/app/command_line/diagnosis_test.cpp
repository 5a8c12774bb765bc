#include "calib/rig_file.h"
#include "tests/app/command_line/workshop.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace tractus {
namespace {

class DiagnosisCommands : public Workshop {
protected:
    void write_demo()
    {
        record();
        if (HasFatalFailure())
            return;
        ASSERT_TRUE(exists("hand.tractus-log"));
    }
};

TEST_F(DiagnosisCommands, DoctorExaminesALog)
{
    write_demo();
    auto const outcome = run("tractus doctor hand.tractus-log");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("ok:      Simulated pen tablet"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("ok:      Simulated height sensor"), std::string::npos);
    EXPECT_EQ(outcome.out.find("problem"), std::string::npos) << outcome.out;
}

TEST_F(DiagnosisCommands, DoctorFailsWhereItFindsAProblem)
{
    // Log of an Intuos tablet in mouse mode.
    std::string log
        = "R: 50 05 01 09 02 a1 01 85 01 09 01 a1 00 05 09 19 01 29 03 15 00 25 01 95 03 "
          "75 01 81 02 95 05 81 03 05 01 09 30 09 31 15 81 25 7f 75 08 95 02 81 06 c0 c0 "
          "N: tablet\nI: 3 056a 037a\n";
    log.insert(log.find("N:"), 1, '\n');
    for (int i = 0; i < 50; ++i)
        log += fmt::format("E: 0.{:03} 4 01 00 05 05\n", 8 * i);
    write("pen.hid", log);
    for (std::string const options : { "", "--json " }) {
        auto const outcome = run("tractus doctor " + options + "pen.hid");
        EXPECT_EQ(outcome.exit_code, 1) << outcome.out;
        EXPECT_NE(outcome.out.find("mouse"), std::string::npos) << outcome.out;
        EXPECT_EQ(outcome.err, "error: 1 problem was found, with the remedy for each\n");
    }
}

TEST_F(DiagnosisCommands, DoctorPrintsJson)
{
    write("pen.hid", "R: 1 c0\nN: tablet\nI: 3 056a fffe\n");
    EXPECT_EQ(run("tractus doctor --json pen.hid").out, "[]\n");
}

// Log of a tablet whose descriptor states the range of its coordinates in counts, but no size in
// millimetres.
constexpr char const* kUnmeasuredTablet
    = "R: 67 05 0d 09 02 a1 01 85 07 09 20 a1 00 09 42 09 44 09 45 09 3c 09 32 15 00 25 01 75 01 "
      "95 "
      "05 81 02 95 03 81 03 05 01 09 30 26 ff 7f 75 10 95 01 81 02 09 31 26 ff 7f 81 02 05 0d 09 "
      "30 "
      "26 ff 1f 81 02 c0 c0\nN: Square Tablet\nI: 3 1234 5678\n";

TEST_F(DiagnosisCommands, DoctorAsksForTheSidesOfATablet)
{
    if (run("command -v script").exit_code != 0)
        GTEST_SKIP() << "there is no script (Debian's bsdutils) to make a terminal";
    std::string log = kUnmeasuredTablet;
    for (int i = 0; i < 50; ++i)
        log += fmt::format("E: 0.{:03}000 8 07 11 {:02x} 10 00 20 00 10\n", 4 * i, i);
    write("pen.hid", log);
    calib::Rig const rig;
    write("a.rig.toml", calib::print_rig(rig));
    auto const before = read("a.rig.toml");
    std::string const doctor = "script -qec '" TRACTUS_PROGRAM " doctor pen.hid --rig ";

    auto const asked = run("printf '\\n' | " + doctor + "a.rig.toml' keys");
    EXPECT_NE(asked.out.find("does not tell the size of its surface"), std::string::npos)
        << asked.out;
    EXPECT_EQ(read("a.rig.toml"), before) << "nothing was answered";
    EXPECT_EQ(run("printf '\\n' | " + doctor + "none.rig.toml' keys").out.find("Measure the sides"),
              std::string::npos)
        << "there is nowhere to keep the answer";

    auto const answered
        = run("printf 'two by four\\n203.2x127\\n' | " + doctor + "a.rig.toml' keys");
    EXPECT_NE(answered.out.find("\"two by four\": expected the two sides"), std::string::npos)
        << answered.out;
    EXPECT_NE(read("a.rig.toml").find("surface_mm = [203.2, 127]"), std::string::npos)
        << answered.out;
    EXPECT_EQ(run("printf '\\n' | " + doctor + "a.rig.toml' keys").out.find("Measure the sides"),
              std::string::npos)
        << "it is known now";
    EXPECT_EQ(run("tractus doctor pen.hid --rig a.rig.toml </dev/null").exit_code, 0);
}

TEST_F(DiagnosisCommands, DoctorWritesTheRules)
{
    auto const outcome = run("tractus doctor --install-rules --rules-file 70-tractus.rules");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("udevadm control --reload-rules"), std::string::npos);
    EXPECT_NE(read("70-tractus.rules").find("TAG+=\"uaccess\""), std::string::npos);
    expect_error(run("touch no; tractus doctor --install-rules --rules-file no/70-tractus.rules"),
                 1, "cannot make the folder no");
    expect_error(run("tractus doctor --for-group"), 2, "--install-rules");
}

TEST_F(DiagnosisCommands, WatchPrintsALogsDevices)
{
    write_demo();
    auto const outcome = run("tractus watch hand.tractus-log --seconds 0.5");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("Simulated pen tablet"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("height sensor, 0 to 4095"), std::string::npos);
}

// The program runs in a pseudo-terminal made by the program "script", which also passes keys on.
TEST_F(DiagnosisCommands, WatchFillsATerminalAndRecordsWithAKey)
{
    if (run("command -v script").exit_code != 0)
        GTEST_SKIP() << "there is no script (Debian's bsdutils) to make a terminal";
    // Each key is pressed once the text that it needs is on the screen or in the recording, or the
    // program has ended.
    auto const outcome = run(
        "touch screen; wait_for() { until \"$@\" || [ -e ended ]; do sleep 0.02; done; }\n"
        "{ wait_for grep -q 'q quit' screen; wait_for grep -q touching screen; printf r;"
        "  wait_for sh -c 'grep -qs ^E watch-*.tractus-log'; printf rq; wait_for [ -e ended ]; } | "
        "{"
        "  TERM=xterm script -qec \"stty rows 40 cols 120; '" TRACTUS_PROGRAM
        "' watch simulated --seconds 250\" /dev/null >screen; code=$?; touch ended; exit $code; }");
    auto const screen = read("screen");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err << screen;
    EXPECT_NE(screen.find("Simulated pen tablet"), std::string::npos);
    EXPECT_NE(screen.find("touching"), std::string::npos);
    EXPECT_NE(screen.find("q quit"), std::string::npos);
    auto const decoded = run("tractus decode watch-*.tractus-log");
    EXPECT_EQ(decoded.exit_code, 0) << decoded.err;
    EXPECT_NE(decoded.out.find("Simulated pen tablet"), std::string::npos) << decoded.out;
}

TEST_F(DiagnosisCommands, DevicesAreListedAsJson)
{
    auto const outcome = run("tractus devices --json");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.out.front(), '[');
}

} // namespace
} // namespace tractus
