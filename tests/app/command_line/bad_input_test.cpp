#include "tests/app/command_line/workshop.h"

#include <sstream>
#include <utility>
#include <vector>

namespace tractus {
namespace {

class BadInput : public Workshop {
protected:
    // Writes a copy of the recorded log, with each line passed through `change`.
    template<typename Change>
    void write_changed_log(std::string const& name, Change const& change) const
    {
        std::istringstream log(read("hand.tractus-log"));
        std::string text;
        for (std::string line; std::getline(log, line);)
            text += change(line);
        write(name, text);
    }

    // Writes the rig of the recorded log to a file, with the line of `key` replaced.
    void write_rig(std::string const& name, std::string const& key, std::string const& line) const
    {
        std::istringstream log(read("hand.tractus-log"));
        std::string text;
        for (std::string read_line; std::getline(log, read_line);)
            if (read_line.starts_with("C: "))
                text += (read_line.starts_with("C: " + key) ? line : read_line.substr(3)) + "\n";
        write(name, text);
    }

    CommandOutcome replay(std::string const& log, std::string const& more = "") const
    {
        return run("tractus replay " + log + " --plant small.l --count 1 -o out " + more);
    }
};

TEST_F(BadInput, ALogThatIsNone)
{
    write("empty", "");
    write("binary", std::string("\x7f\x45\x4c\x46\0\xff\n\xfe", 8));
    run("mkdir folder");
    for (std::string const command : { "decode ", "decode --csv ", "replay --plant small.l " }) {
        expect_error(run("tractus " + command + "missing"), 1, "cannot open missing: No such file");
        expect_error(run("tractus " + command + "folder"), 1, "folder: it is a folder");
        expect_error(run("tractus " + command + "empty"), 1, "empty is not a log");
        expect_error(run("tractus " + command + "binary"), 1, "binary is not a log");
        expect_error(run("tractus " + command + "small.l"), 1, "small.l is not a log");
    }
}

TEST_F(BadInput, ALogThatIsCutOffGivesWhatItHas)
{
    record();
    auto const log = read("hand.tractus-log");
    write("cut", log.substr(0, log.size() * 9 / 10));
    auto const replayed = replay("cut");
    EXPECT_EQ(replayed.exit_code, 0) << replayed.err;
    EXPECT_EQ(count_files("out"), 6u);
    write("stump", log.substr(0, 300));
    expect_error(run("tractus decode stump"), 1, "stump:2: a report descriptor of");
}

TEST_F(BadInput, ReportsThatAreNotWhatTheDescriptorSays)
{
    record();
    write_changed_log("mismatch", [](std::string const& line) {
        return line.starts_with("E: ") ? line.substr(0, 17) + "3 09 02 03\n" : line + "\n";
    });
    for (std::string const command : { "decode", "decode --csv", "replay --plant small.l" })
        expect_error(run("tractus " + command + " mismatch"), 1,
                     "report 9 is not in the report descriptor");
    EXPECT_FALSE(exists("report.txt"));
}

TEST_F(BadInput, ADescriptorThatSaysNothingOrNonsense)
{
    record();
    for (auto const& [descriptor, reason] : { std::pair("R: 0", "the report descriptor is empty"),
                                              std::pair("R: 4 ff ff ff ff", "ends inside the item"),
                                              std::pair("R: 3 a1 01 c0", "no X, Y and tip"),
                                              std::pair("R: 2 05 0d 09", "announces 2") }) {
        bool is_first = true;
        write_changed_log("hostile", [&is_first, wrong = descriptor](std::string const& line) {
            return line.starts_with("R: ") && std::exchange(is_first, false)
                ? std::string(wrong) + "\n"
                : line + "\n";
        });
        expect_error(run("tractus decode hostile"), 1, reason);
        expect_error(replay("hostile"), 1, reason);
    }
}

TEST_F(BadInput, ALogWithoutHeightsNeedsThemGiven)
{
    record();
    bool in_height = false;
    write_changed_log("flat", [&](std::string const& line) {
        if (line.starts_with("D: "))
            in_height = line == "D: 1";
        return in_height || line.starts_with("C: ") ? std::string() : line + "\n";
    });
    expect_error(replay("flat"), 1, "give the height with --height");
    EXPECT_EQ(replay("flat", "--height 120").exit_code, 0);
}

TEST_F(BadInput, ARigThatCannotBe)
{
    record();
    write_rig("flat.toml", "mm_per_count", "mm_per_count = 0");
    write_rig("missing.toml", "zero_length_mm", "");
    write_rig("nan.toml", "offset_mm", "offset_mm = nan");
    write_rig("broken.toml", "base_mm", "base_mm = = 3");
    expect_error(replay("hand.tractus-log", "--rig flat.toml"), 1,
                 "height.mm_per_count is 0, expected a number other than 0");
    expect_error(replay("hand.tractus-log", "--rig missing.toml"), 1,
                 "height.zero_length_mm is missing");
    expect_error(replay("hand.tractus-log", "--rig nan.toml"), 1, "height.offset_mm is nan");
    expect_error(replay("hand.tractus-log", "--rig broken.toml"), 1, "broken.toml:");
    expect_error(replay("hand.tractus-log", "--rig nowhere.toml"), 1, "cannot open nowhere.toml");
}

TEST_F(BadInput, TextThatAnotherSystemsEditorHasSavedInUtf16)
{
    record();
    write_rig("a.rig.toml", "none", "");
    write("line.txt", "0 0 0\n0 0 200\n");
    write("lines.obj", "v 0 0 0\nv 0 1 0\nl 1 2\n");
    write("rule.toml", "l = 40\n");
    write("small.v", "angle factor: 2\n");
    std::vector<std::pair<std::string, std::string>> const readers {
        { "hand.tractus-log", "decode hand.tractus-log" },
        { "hand.toml", "record --simulate hand.toml --plant small.l -o x.tractus-log" },
        { "a.rig.toml", "replay hand.tractus-log --plant small.l --rig a.rig.toml -o out" },
        { "line.txt", "sketch line.txt -o out" },
        { "rule.toml", "sketch line.txt --rule rule.toml -o out" },
        { "lines.obj", "grow lines.obj -o x.glb" },
        { "small.v", "grow small.l -o x.glb" },
        { "small.l", "grow small.l -o x.glb" },
    };
    for (auto const& [file, command] : readers) {
        auto const as_it_was = read(file);
        std::string wide = "\xff\xfe";
        for (char const c : as_it_was)
            (wide += c) += '\0';
        write(file, wide);
        expect_error(run("tractus " + command), 1, file + " is text in UTF-16 or UTF-32");
        write(file, as_it_was);
    }
}

TEST_F(BadInput, AModelWithAFault)
{
    write("open.l", "Lsystem: 1\nderivation length: 3\nAxiom: A\nA --> F((1\nendlsystem\n");
    write("empty.l", "");
    write("bare.l", "Lsystem: 1\nderivation length: 3\nAxiom: A\nA --> A\nendlsystem\n");
    for (std::string const command : { "derive --count ", "grow -o x.glb " }) {
        expect_error(run("tractus " + command + "open.l"), 1, "open.l:4:11: ");
        expect_error(run("tractus " + command + "empty.l"), 1, "empty.l:1:1: ");
        expect_error(run("tractus " + command + "oak"), 1, "there is no model oak");
    }
    record();
    expect_error(run("tractus replay hand.tractus-log --plant bare.l"), 1, "no branch");
    EXPECT_FALSE(exists("x.glb"));
}

TEST_F(BadInput, AModelThatRunsAwayIsStoppedInTime)
{
    write("doubling.l", "Lsystem: 1\nderivation length: 40\nAxiom: F\nF --> FF\nendlsystem\n");
    expect_error(run("tractus derive doubling.l --count --max-modules 100000"), 1,
                 "more than 100000 modules");
    expect_error(run("tractus grow doubling.l -o x.glb"), 1, "more than 100000000 modules");
    expect_error(run("tractus grow doubling.l -n 23 -o x.glb"), 1, "more than 4000000 segments");
    EXPECT_FALSE(exists("x.glb"));
}

TEST_F(BadInput, AGlbThatIsNone)
{
    ASSERT_EQ(run("tractus grow small.l -o plant.glb").exit_code, 0);
    write("cut.glb", read("plant.glb").substr(0, 5000));
    expect_error(run("tractus render cut.glb -o x.png"), 1, "truncated: 5000 bytes");
    expect_error(run("tractus render small.l -o x.png"), 1, "not a binary glTF file");
    expect_error(run("tractus render missing.glb -o x.png"), 1, "cannot open missing.glb");
    expect_error(run("tractus grow plant.glb -o x.glb"), 1, "there are no lines");
    write("plant.gltf", "{}");
    expect_error(run("tractus grow plant.gltf -o x.glb"), 1, "export it as .glb");
    EXPECT_FALSE(exists("x.png"));
    EXPECT_FALSE(exists("x.glb"));
}

TEST_F(BadInput, AScriptForTheHandThatIsNone)
{
    expect_error(run("tractus record --simulate small.l -o x"), 1, "small.l:1:");
    write("far.toml", "version = 1\n[[gesture]]\ntool = \"select\"\ntrace = \"axis\"\naxis = 9\n");
    expect_error(run("tractus record --simulate far.toml --plant small.l -o x"), 1,
                 "the plant has no branch 9");
    EXPECT_FALSE(exists("x"));
}

} // namespace
} // namespace tractus
