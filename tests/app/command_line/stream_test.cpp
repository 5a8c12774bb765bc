#include "tests/app/command_line/workshop.h"
#include "tests/file_bytes.h"

#include <gtest/gtest.h>
#include <sstream>

namespace tractus {
namespace {

class StreamCommand : public Workshop {
protected:
    // Returns the path of a fixture with two strokes, in the format of the given ending: see
    // tests/fixtures/stream_small.
    static std::string small(char const* ending)
    {
        return std::string(TRACTUS_FIXTURES "/small.") + ending;
    }

    // Returns only the devices and the rig of the log small.tractus-log.
    static std::string small_without_reports()
    {
        std::ifstream in(small("tractus-log"));
        std::string text;
        for (std::string line; std::getline(in, line) && line[0] != 'E';)
            text += line + "\n";
        return text;
    }
};

TEST_F(StreamCommand, GivesASmallLogToTheByte)
{
    auto const outcome = run("tractus stream " + small("tractus-log"));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(outcome.out, file_bytes(small("jsonl")));
}

TEST_F(StreamCommand, PlaysALogAsIfItsDevicesWereThere)
{
    auto const outcome
        = run("tractus stream --strokes --device " + small("tractus-log") + " && echo whole");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("\"number\":2"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("{\"type\":\"end\"}\nwhole\n"), std::string::npos) << outcome.out;
}

TEST_F(StreamCommand, WaitsAtASocketForItsReaderAndTakesTheSocketAway)
{
    // The program is terminated while it waits for a connection. The command uses the program's
    // path, so that $! is the process number of the program itself.
    auto const outcome = run("'" TRACTUS_PROGRAM "' stream " + small("tractus-log")
                             + " --socket there & until [ -S there ]; do sleep 0.05; done; "
                               "kill -TERM $!; wait $!; echo $?");
    EXPECT_EQ(outcome.out, "0\n");
    EXPECT_FALSE(exists("there"));
}

TEST_F(StreamCommand, SaysWhatItCannotDo)
{
    write("no.tractus-log", "R: 1 c0\nN: mouse\nE: 0.0 1 01\n");
    write("taken", "mine");
    expect_error(run("tractus stream no.tractus-log"), 1, "there is no pen to draw with");
    expect_error(run("tractus stream nothing.tractus-log"), 1, "nothing.tractus-log");
    expect_error(run("tractus stream " + small("tractus-log") + " --socket taken"), 1,
                 "taken is there already, and is no socket");
    EXPECT_EQ(read("taken"), "mine");
    expect_error(run("tractus stream --device " + small("tractus-log") + " --height rise"), 1,
                 "a made-up movement needs a recording");
    expect_error(run("tractus stream --speed 1"), 2, "--speed");
    expect_error(run("tractus stream a.tractus-log --seconds 1"), 2, "--seconds");
}

TEST_F(StreamCommand, WritesCurvesThatOtherProgramsReadAndWeReadBack)
{
    auto const text = run("tractus convert " + small("tractus-log") + " -o strokes.txt");
    EXPECT_EQ(text.out, "strokes.txt: 2 strokes of 14 points\n") << text.err;
    auto const points = read("strokes.txt");
    EXPECT_EQ(points.substr(0, points.find('\n')), "# x y z in mm, pressure, time in ms");
    auto const second = points.find("\n\n");
    ASSERT_NE(second, std::string::npos) << points;
    std::istringstream first_point(points.substr(second));
    for (double const expected : { 50.0, 40.0, 150.0, 1.0, 905.0 }) {
        double value = 0;
        ASSERT_TRUE(first_point >> value) << points;
        EXPECT_NEAR(value, expected, 1e-9) << points;
    }

    EXPECT_EQ(run("tractus convert strokes.txt -o again.strokes").exit_code, 0);
    EXPECT_EQ(read("again.strokes"), points);

    EXPECT_EQ(run("tractus convert strokes.txt -o strokes.glb").exit_code, 0);
    EXPECT_EQ(read("strokes.glb").substr(0, 4), "glTF");
    auto const grown = run("tractus render strokes.glb -o lines.png --size 64x64");
    EXPECT_EQ(grown.exit_code, 0) << grown.err; // A file of lines can be read as a skeleton.

    EXPECT_EQ(run("tractus convert strokes.txt -o top.svg --view top").exit_code, 0);
    EXPECT_NE(read("top.svg").find("points=\"50.000,-40.000 "), std::string::npos);
    EXPECT_EQ(run("xmllint --noout top.svg").exit_code, 0);
}

TEST_F(StreamCommand, WritesNoFileWhereNothingWasDrawn)
{
    write("idle.tractus-log", small_without_reports());
    expect_error(run("tractus convert idle.tractus-log -o idle.glb"), 1,
                 "idle.tractus-log: nothing was drawn in it");
    EXPECT_FALSE(exists("idle.glb"));
}

} // namespace
} // namespace tractus
