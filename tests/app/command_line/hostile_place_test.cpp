#include "tests/app/command_line/workshop.h"

#include <array>
#include <fmt/core.h>
#include <string>

namespace tractus {
namespace {

// Tests in which the system refuses something to the program, or ends it.
using HostilePlace = Workshop;

TEST_F(HostilePlace, AFullDiskLeavesTheOldFile)
{
    write("plant.glb", "the old one");
    expect_error(run("ulimit -f 8; tractus grow small.l -o plant.glb"), 1,
                 "cannot write plant.glb: File too large");
    EXPECT_EQ(read("plant.glb"), "the old one");
    EXPECT_EQ(run("ls").out, "hand.toml\nplant.glb\nsmall.l\n");
}

TEST_F(HostilePlace, AFullDiskLeavesWholeFilesOfAJob)
{
    record();
    // The limit is in blocks of 512 bytes. It leaves room for at most the first picture of the job.
    expect_error(run("ulimit -f 64; tractus replay hand.tractus-log --plant small.l -o out"), 1,
                 "File too large");
    EXPECT_EQ(run("ls out | grep -c part").out, "0\n");
    EXPECT_TRUE(read("out/report.txt").ends_with("not finished\n"));
}

TEST_F(HostilePlace, AFileSystemThatIsFull)
{
    if (run("mkdir disk && mount -t tmpfs -o size=64k tmpfs disk").exit_code != 0)
        GTEST_SKIP() << "no file system may be mounted here";
    auto const grown = run("tractus grow broadleaf -o disk/plant.glb");
    auto const left = run("ls disk");
    run("umount disk");
    expect_error(grown, 1, "cannot write disk/plant.glb: No space left on device");
    EXPECT_EQ(left.out, "");
}

TEST_F(HostilePlace, StandardOutputThatTakesNothingIsAnError)
{
    record();
    for (char const* const command :
         { "tractus --help", "tractus devices", "tractus devices --json",
           "tractus derive small.l --string", "tractus decode hand.tractus-log",
           "tractus decode hand.tractus-log --csv", "tractus grow small.l -o x.glb" }) {
        expect_error(run(std::string(command) + " >/dev/full"), 1,
                     "cannot write to standard output: No space left on device");
        expect_error(run(std::string(command) + " >&-"), 1,
                     "cannot write to standard output: Bad file descriptor");
    }
}

TEST_F(HostilePlace, ClosedStreamsDoNotMixWithFiles)
{
    run("tractus grow small.l -o open.glb");
    run("tractus grow small.l -o closed.glb <&- >&- 2>&-");
    EXPECT_EQ(read("closed.glb"), read("open.glb"));
    EXPECT_EQ(run("tractus grow oak -o x.glb <&- >&- 2>&-").exit_code, 1);
    EXPECT_EQ(run("tractus grow oak -o x.glb 2>/dev/full").exit_code, 1);
}

TEST_F(HostilePlace, AFolderThatCannotBe)
{
    record();
    for (std::string const folder : { "small.l", "/dev/null" })
        expect_error(run("tractus replay hand.tractus-log --plant small.l -o " + folder), 1,
                     folder + " is no folder");
    expect_error(run("tractus grow small.l -o hand.toml/x.glb"), 1, "hand.toml is no folder");
    for (std::string const command : { "grow none.l", "replay none.tractus-log --plant small.l" })
        expect_error(run("tractus " + command + " -o /proc/tractus/x.glb"), 1,
                     "cannot write /proc/tractus/x.glb");
    expect_error(run("tractus decode hand.tractus-log --csv -o /dev/full"), 1, "No space left");
}

TEST_F(HostilePlace, AFolderThatMayNotBeWritten)
{
    run("mkdir locked; chmod 0555 locked; chmod 0755 .");
    // Root may write everywhere, so root runs the program as user nobody.
    std::string const as_user = ::geteuid() == 0
        ? "HOME=/ setpriv --reuid=65534 --regid=65534 --clear-groups '" TRACTUS_PROGRAM "'"
        : "tractus";
    expect_error(run(as_user + " grow none.l -o locked/x.glb"), 1, "in locked: Permission denied");
    expect_error(run(as_user + " grow none.l -o locked/a/b/x.glb"), 1,
                 "in locked: Permission denied");
}

TEST_F(HostilePlace, ARecordingIsNeverWrittenOver)
{
    record();
    auto const before = read("hand.tractus-log");
    expect_error(run("tractus record --simulate hand.toml --plant small.l -o hand.tractus-log"), 1,
                 "never written over");
    expect_error(run("tractus decode hand.tractus-log --csv -o ./hand.tractus-log"), 1,
                 "is the log itself");
    EXPECT_EQ(read("hand.tractus-log"), before);
}

TEST_F(HostilePlace, NamesMayHaveBlanksAndAnyBytes)
{
    record();
    for (char const* const name : { "my plant", "Pflänzchen", "\xff\xfe", "-n" }) {
        auto const named = "'./" + std::string(name) + "'";
        EXPECT_EQ(run("mkdir " + named + " && cp small.l " + named + "/m.l && tractus grow " + named
                      + "/m.l -o " + named + "/m.glb && tractus render " + named + "/m.glb -o "
                      + named + "/m.png --size 32x32 && tractus decode hand.tractus-log --csv -o "
                      + named + "/m.csv")
                      .exit_code,
                  0)
            << name;
    }
}

TEST_F(HostilePlace, ALinkStaysAndWhatItLeadsToIsWritten)
{
    EXPECT_EQ(run("ln -s target.glb link.glb; ln -s small.l link.l; "
                  "tractus grow link.l -o link.glb && test -L link.glb && test -s target.glb")
                  .exit_code,
              0);
}

TEST_F(HostilePlace, NumbersDoNotDependOnTheLocale)
{
    if (run("localedef -i de_DE -f UTF-8 ./de_DE.UTF-8").exit_code != 0)
        GTEST_SKIP() << "the German locale cannot be made here (Debian package locales)";
    record();
    run("tractus decode hand.tractus-log --csv -o plain.csv");
    run("LOCPATH=$PWD LC_ALL=de_DE.UTF-8 tractus decode hand.tractus-log --csv -o german.csv");
    EXPECT_FALSE(read("plain.csv").empty());
    EXPECT_EQ(read("german.csv"), read("plain.csv"));
    run("mkdir plain german");
    run("tractus grow small.l -o plain/tree.obj");
    run("LOCPATH=$PWD LC_ALL=de_DE.UTF-8 tractus grow small.l -o german/tree.obj");
    for (std::string const file : { "tree.obj", "tree.mtl" }) {
        EXPECT_FALSE(read("plain/" + file).empty());
        EXPECT_TRUE(read("german/" + file) == read("plain/" + file)) << file;
    }
}

// Command lines of all commands that write files. {} stands for the folder.
constexpr std::array kWriting {
    "grow small.l -o {}/a.glb",
    "grow small.l --sequence 2 -o {}/a.obj",
    "vary small.l --count 2 -o {}/a.glb",
    "vary small.l --count 2 -o {}/a",
    "replay hand.tractus-log --plant small.l -o {}/a --session {}/b.tractus",
    "render small.glb -o {}/a.png",
    "sketch line.txt -o {}/a",
    "session export small.tractus -o {}/a",
    "session repair small.tractus -o {}/a.tractus",
    "record --simulate hand.toml --plant small.l -o {}/a.tractus-log",
    "record --device hand.tractus-log --seconds 0.1 -o {}/b.tractus-log",
    "decode hand.tractus-log --csv -o {}/a.csv",
    "convert hand.tractus-log -o {}/a.hid",
    "calibrate height --simulate --rig {}/a.rig.toml",
};

TEST_F(HostilePlace, FoldersThatAreNotThereAreMade)
{
    record();
    write("line.txt", "0 0 0\n0 0 200\n");
    run("tractus grow small.l -o small.glb");
    run("tractus replay hand.tractus-log --plant small.l --session small.tractus -o drawn");
    for (std::size_t i = 0; i < kWriting.size(); ++i) {
        auto const folder = fmt::format("new{}/deep", i);
        auto const outcome
            = run("tractus " + fmt::format(fmt::runtime(kWriting[i]), folder, folder));
        EXPECT_EQ(outcome.exit_code, 0) << kWriting[i] << ": " << outcome.err;
        EXPECT_GE(exists(folder) ? count_files(folder) : 0, 1u) << kWriting[i];
    }
}

// A command must detect that its output cannot be written before it reads anything: here its inputs
// do not exist.
TEST_F(HostilePlace, APlaceThatCannotBeWrittenIsFoundOutBeforeTheWork)
{
    run("mv small.l place; rm hand.toml");
    for (auto const* const command : kWriting) {
        auto const outcome
            = run("tractus " + fmt::format(fmt::runtime(command), "place/in", "place/in"));
        expect_error(outcome, 1, "place is no folder");
    }
    EXPECT_FALSE(exists("place/in"));
}

TEST_F(HostilePlace, AWindowWithoutADisplaySaysWhatElseThereIs)
{
    record();
    expect_error(run("env -u DISPLAY -u WAYLAND_DISPLAY '" TRACTUS_PROGRAM
                     "' window hand.tractus-log --plant small.l"),
                 1, TRACTUS_HAS_WINDOW ? "display" : "this build of tractus has no window");
}

// Whenever the program is ended, its output file must be either complete or absent. After a signal
// that can be caught, there must be no temporary file either.
TEST_F(HostilePlace, EndedInTheMiddleItLeavesNothingHalfWritten)
{
    run("tractus grow broadleaf -o whole.glb");
    auto const whole = read("whole.glb");
    for (char const* const signal : { "KILL", "INT", "TERM" })
        for (char const* const wait_s : { "0.02", "0.05", "0.08", "0.12" }) {
            run(std::string("timeout -s ") + signal + " " + wait_s
                + " '" TRACTUS_PROGRAM "' grow broadleaf -o plant.glb");
            EXPECT_TRUE(!exists("plant.glb") || read("plant.glb") == whole) << signal << wait_s;
            if (std::string(signal) != "KILL") {
                EXPECT_EQ(run("ls").out.find(".part"), std::string::npos) << signal << wait_s;
            }
            run("rm -f plant.glb *.part");
        }
}

TEST_F(HostilePlace, InterruptedAJobLeavesWholeFiles)
{
    record();
    auto const job = [&](std::string const& folder, std::string const& before) {
        return run(before
                   + " '" TRACTUS_PROGRAM "' replay hand.tractus-log --plant small.l --count 1 -o "
                   + folder)
            .exit_code;
    };
    ASSERT_EQ(job("whole", ""), 0);
    EXPECT_NE(job("ended", "timeout -s INT 0.6"), 1);
    for (std::string const name : { "base.png", "strokes.png", "varied.png", "collection.glb" })
        EXPECT_TRUE(!exists("ended/" + name) || read("ended/" + name) == read("whole/" + name))
            << name;
    EXPECT_EQ(run("ls ended 2>&1 | grep -c part").out, "0\n");
}

} // namespace
} // namespace tractus
