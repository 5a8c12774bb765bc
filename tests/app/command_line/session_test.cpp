#include "tests/app/command_line/workshop.h"

namespace tractus {
namespace {

// Fixture with the session "hand.tractus", which is drawn only once for all tests of a process.
class SessionCommand : public Workshop {
protected:
    void SetUp() override
    {
        static std::string session;
        Workshop::SetUp();
        record();
        if (!session.empty()) {
            write("hand.tractus", session);
            return;
        }
        auto const drawn = run("tractus replay hand.tractus-log --plant small.l --count 1 -o out "
                               "--session hand.tractus");
        ASSERT_EQ(drawn.exit_code, 0) << drawn.err;
        EXPECT_NE(drawn.out.find("wrote hand.tractus\n"), std::string::npos) << drawn.out;
        session = read("hand.tractus");
    }

    std::string out(std::string const& command) const
    {
        auto const outcome = run(command);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        return outcome.out;
    }
};

// Files that are given to others must not reveal the author's folders.
TEST_F(SessionCommand, NothingThatIsGivenToOthersHasFolders)
{
    auto const folder = path("anna").string();
    out("mkdir anna && cp small.l anna && tractus record --simulate hand.toml --plant "
        "$PWD/anna/small.l "
        "-o anna.tractus-log");
    out("tractus replay $PWD/hand.tractus-log --plant $PWD/anna/small.l --count 1 -o made "
        "--session "
        "made/anna.tractus");
    for (char const* const ending : { "glb", "obj", "mtg" })
        out(std::string("tractus grow $PWD/anna/small.l -o made/model.") + ending
            + " && tractus grow $PWD/made/anna.tractus -o made/session." + ending);
    out("tractus vary $PWD/made/anna.tractus --count 1 -o made/many");
    EXPECT_EQ(out("tractus session log made/anna.tractus").find(folder), std::string::npos);
    out("rm made/report.txt; mv anna.tractus-log made"); // The report is for its author only.
    EXPECT_EQ(run("grep -r -l -F '" + folder + "' made").out, "");
}

// The name of a plant is arbitrary text; parts of it could be escape sequences for a terminal.
TEST_F(SessionCommand, WhatItsFileSaysDoesNotCommandATerminal)
{
    out("cp small.l \"$(printf 'a\\033]0;x\\a.l')\"");
    out("tractus replay hand.tractus-log --plant \"$(printf 'a\\033]0;x\\a.l')\" --count 1 -o made "
        "--session loud.tractus");
    for (char const* const part : { "info", "log", "export" }) {
        auto const outcome = run(std::string("tractus session ") + part + " loud.tractus");
        EXPECT_EQ(outcome.out.find('\033'), std::string::npos) << part;
        EXPECT_EQ(outcome.err.find('\033'), std::string::npos) << part;
        EXPECT_NE(outcome.out.find("\\x1b]0;x"), std::string::npos) << outcome.out;
    }
}

TEST_F(SessionCommand, InfoSaysWhatItHolds)
{
    auto const info = out("tractus session info hand.tractus");
    for (char const* const line :
         { "plant                 small\n", "steps to undo         3\n",
           "steps to redo         0\n", "strokes               1\n", "motion indicators     1\n",
           "plants                1\n", "segments              10\n", "begun                 20" })
        EXPECT_NE(info.find(line), std::string::npos) << line << info;
}

TEST_F(SessionCommand, LogSaysWhatWasDoneEditByEdit)
{
    auto const log = out("tractus session log hand.tractus");
    EXPECT_EQ(std::count(log.begin(), log.end(), '\n'), 5);
    for (char const* const what :
         { "takes the model small.l: ", "grows as \"usual\"", "selects 1 path, 4 segments",
           "shapes what is selected and bears by a stroke: ", "leans the plant by (" })
        EXPECT_NE(log.find(what), std::string::npos) << what << log;
}

// A session contains its model, so it can be opened on another machine without any other file.
TEST_F(SessionCommand, NeedsNoOtherFile)
{
    auto const before = out("tractus session info hand.tractus; tractus session log hand.tractus");
    out("tractus grow hand.tractus -o before.glb");
    run("rm small.l hand.tractus-log");
    EXPECT_EQ(out("tractus session info hand.tractus; tractus session log hand.tractus"), before);
    out("tractus grow hand.tractus -o after.glb");
    EXPECT_FALSE(read("before.glb").empty());
    EXPECT_EQ(read("after.glb"), read("before.glb"));
}

TEST_F(SessionCommand, GivesTheSamePlantsAsItsDrawing)
{
    out("tractus vary small.l --drawing hand.tractus-log --count 2 -o drawn");
    out("tractus vary hand.tractus --count 2 -o kept");
    EXPECT_EQ(count_files("kept"), 3u);
    EXPECT_NE(read("kept/hand-1.glb").size(), 0u);
    // The files of both folders are equal except for the names of the plants.
    EXPECT_EQ(out("tractus render drawn/small-2.glb -o drawn.png --size 200x200;"
                  "tractus render kept/hand-2.glb -o kept.png --size 200x200"),
              "");
    EXPECT_FALSE(read("kept.png").empty());
    EXPECT_EQ(read("kept.png"), read("drawn.png"));
    out("tractus vary hand.tractus --count 2 --growth calm -o calm");
    EXPECT_NE(read("calm/hand-1.glb"), read("kept/hand-1.glb"));
}

TEST_F(SessionCommand, IsDrawnAsAPicture)
{
    out("tractus grow hand.tractus -o grown.png; tractus grow small.l -o plain.png");
    EXPECT_NE(read("grown.png"), read("plain.png"));
    out("tractus grow hand.tractus -o own.glb; tractus grow hand.tractus --seed 1 -o first.glb;"
        "tractus grow hand.tractus --seed 2 -o second.glb");
    EXPECT_EQ(read("own.glb"), read("first.glb"));
    EXPECT_NE(read("own.glb"), read("second.glb"));
    out("tractus render hand.tractus -o shown.png --size 100x100");
    EXPECT_EQ(read("shown.png").substr(1, 3), "PNG");
}

TEST_F(SessionCommand, MayBeDrawnOnFurther)
{
    out("tractus replay hand.tractus-log --plant hand.tractus --count 1 -o out "
        "--session more.tractus");
    auto const info = out("tractus session info more.tractus");
    EXPECT_NE(info.find("motion indicators     2\n"), std::string::npos) << info;
    EXPECT_NE(info.find("steps to undo         3\n"), std::string::npos) << info;
}

TEST_F(SessionCommand, ExportGivesBackTheModelAndTheStrokes)
{
    auto const written = out("tractus session export hand.tractus -o files");
    EXPECT_EQ(written, "wrote files/small.l\nwrote files/strokes.txt\n");
    EXPECT_EQ(read("files/small.l"), read("small.l"));
    out("tractus replay files/strokes.txt --plant files/small.l --count 1 -o again "
        "--session again.tractus");
    auto const info = out("tractus session info again.tractus");
    EXPECT_NE(info.find("strokes               1\n"), std::string::npos) << info;
}

TEST_F(SessionCommand, ExportGivesBackASkeleton)
{
    write("tree.obj", "v 0 0 0\nv 0 0.1 0\nv 0.05 0.13 0.01\nl 1 2\nl 2 3\n");
    out("tractus replay hand.tractus-log --plant tree.obj --count 1 -o out --session t.tractus");
    run("mv tree.obj first.obj");
    out("tractus session export t.tractus -o .; tractus grow first.obj -o first.glb;"
        "mv tree.obj first.obj; tractus grow first.obj -o second.glb");
    EXPECT_FALSE(read("first.glb").empty());
    EXPECT_EQ(read("second.glb"), read("first.glb"));
}

TEST_F(SessionCommand, ExportGivesBackWhatTheModelIncludes)
{
    run("mkdir inner; printf '#include \"length.h\"\\n' >inner/m.l; cat small.l >>inner/m.l; "
        "printf '#define LENGTH 3\\n' >inner/length.h");
    out("tractus replay hand.tractus-log --plant inner/m.l --count 1 -o out --session m.tractus");
    out("tractus session export m.tractus -o files");
    EXPECT_EQ(read("files/m.l"), read("inner/m.l"));
    EXPECT_EQ(read("files/length.h"), read("inner/length.h"));
}

TEST_F(SessionCommand, WhatIsNoSessionIsRefused)
{
    write("empty.tractus", "");
    write("text.tractus", std::string(9000, 'x'));
    run("mkdir folder.tractus");
    auto const session = read("hand.tractus");
    write("cut.tractus", session.substr(0, 5000));
    for (std::string const command : { "session info ", "session log ", "session export -o out ",
                                       "grow -o x.glb ", "render -o x.png ", "vary -o x.glb " }) {
        expect_error(run("tractus " + command + "empty.tractus"), 1, "is not a session of tractus");
        expect_error(run("tractus " + command + "text.tractus"), 1, "is not a session of tractus");
        expect_error(run("tractus " + command + "cut.tractus"), 1, "cut.tractus is damaged");
    }
    expect_error(run("tractus session info missing.tractus"), 1, "there is no such file");
    expect_error(run("tractus session info folder.tractus"), 1, "it is no file");
    expect_error(run("tractus grow hand.tractus -n 3 -o x.glb"), 1, "leave --steps out");
    EXPECT_FALSE(exists("x.glb"));
}

TEST_F(SessionCommand, IsNeverWrittenOver)
{
    auto const before = read("hand.tractus");
    expect_error(run("tractus replay hand.tractus-log --plant small.l -o again --session "
                     "hand.tractus"),
                 1, "never written over");
    EXPECT_EQ(read("hand.tractus"), before);
    expect_error(run("tractus replay hand.tractus-log --plant small.l --session x.db"), 2,
                 "must end in .tractus");
    expect_error(run("tractus session"), 2, "see \"tractus session --help\"");
    expect_error(run("tractus session info"), 2, "FILE is required");
}

TEST_F(SessionCommand, AFullDiskIsSaidAndWhatWasKeptStays)
{
    // The limit is in blocks of 512 bytes. It lets the session begin, but not save its first
    // stroke.
    expect_error(run("ulimit -f 40; tractus replay hand.tractus-log --plant small.l -o full "
                     "--session full.tractus"),
                 1, "full.tractus");
    if (exists("full.tractus")) {
        EXPECT_EQ(run("tractus session info full.tractus").exit_code, 0);
    }
}

} // namespace
} // namespace tractus
