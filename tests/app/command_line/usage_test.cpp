#include "tests/app/command_line/workshop.h"

#include <algorithm>
#include <cctype>
#include <sstream>
#include <string>
#include <vector>

namespace tractus {
namespace {

// Names of the commands that every list of them must contain; an empty name stands for the program
// itself.
std::vector<std::string> const kCommands { "",
                                           "convert",
                                           "decode",
                                           "demo",
                                           "derive",
                                           "devices",
                                           "doctor",
                                           "grow",
                                           "lsystem check",
                                           "record",
                                           "render",
                                           "replay",
                                           "session",
                                           "session info",
                                           "session log",
                                           "session export",
                                           "sim",
                                           "tools",
                                           "stream",
                                           "vary",
                                           "watch",
                                           "window",
                                           "tour",
                                           "brush",
                                           "construct",
                                           "silhouette",
                                           "sketch",
                                           "leaves",
                                           "leaves atlas",
                                           "leaves draw",
                                           "leaves paint" };

// Returns the names of the commands in the lists of a help page: words that are indented by two
// spaces and explained.
std::vector<std::string> listed_commands(std::string const& help)
{
    std::vector<std::string> names;
    std::istringstream lines(help);
    bool is_list = false;
    for (std::string line; std::getline(lines, line);) {
        if (!line.empty() && line.front() != ' ')
            is_list = line.back() == ':' && line != "Arguments:" && line != "Options:"
                && line != "Examples:";
        else if (is_list && line.size() > 2 && std::islower(line[2]))
            names.push_back(line.substr(2, line.find(' ', 2) - 2));
    }
    return names;
}

class Usage : public Workshop {
protected:
    // Returns the help pages of the program, its commands and their commands.
    std::vector<std::string> help_pages()
    {
        std::vector<std::string> pages { run("tractus --help").out };
        for (auto const& command : listed_commands(pages.front())) {
            pages.push_back(run("tractus " + command + " --help").out);
            for (auto const& below : listed_commands(std::string(pages.back())))
                pages.push_back(run("tractus " + command + " " + below + " --help").out);
        }
        return pages;
    }
};

TEST_F(Usage, HelpGoesToStandardOutputAndIsNoFailure)
{
    for (auto const& command : kCommands) {
        auto const help = run("tractus " + command + " --help");
        EXPECT_EQ(help.exit_code, 0) << command;
        EXPECT_EQ(help.err, "") << command;
        EXPECT_NE(help.out.find("Usage: tractus" + (command.empty() ? "" : " " + command)),
                  std::string::npos)
            << help.out;
    }
}

TEST_F(Usage, HelpNamesEveryCommandAndTheExitCodes)
{
    auto const help = run("tractus --help").out;
    for (auto const& command : kCommands)
        EXPECT_NE(help.find("\n  " + command.substr(0, command.find(' '))), std::string::npos)
            << command;
    EXPECT_NE(help.find("\nExit codes: "), std::string::npos);
}

TEST_F(Usage, HelpFitsInto85Columns)
{
    for (auto const& page : help_pages()) {
        std::istringstream help(page);
        for (std::string line; std::getline(help, line);)
            EXPECT_LE(line.size(), 85u) << line;
    }
}

TEST_F(Usage, HelpHasExamplesOfEveryCommand)
{
    for (auto const& command : kCommands) {
        auto const help = run("tractus " + command + " --help").out;
        bool const is_list_of_commands = help.find(" COMMAND\n") != std::string::npos
            || help.find("Usage: tractus [OPTIONS...] [COMMAND]") != std::string::npos;
        if (is_list_of_commands)
            continue;
        auto const examples = help.find("\nExamples:\n");
        ASSERT_NE(examples, std::string::npos) << help;
        EXPECT_GE(std::ranges::count(help.substr(examples), '\n'), 3) << help;
    }
}

TEST_F(Usage, HelpSaysDefaultsAndWhatIsRequired)
{
    auto const help = run("tractus replay --help").out;
    EXPECT_NE(help.find("(default: 1)"), std::string::npos) << help;
    EXPECT_NE(help.find("(required)"), std::string::npos) << help;
}

TEST_F(Usage, PrintsItsVersion)
{
    auto const version = run("tractus --version");
    EXPECT_EQ(version.exit_code, 0);
    EXPECT_EQ(version.out.substr(0, 8), "tractus ");
}

TEST_F(Usage, WrongUsageSaysWhereToReadOn)
{
    expect_error(run("tractus"), 2, "see \"tractus --help\"");
    expect_error(run("tractus sow"), 2, "sow");
    expect_error(run("tractus replay"), 2, "LOG is required; see \"tractus replay --help\"");
    expect_error(run("tractus replay hand.tractus-log"), 2, "--plant is required");
    expect_error(run("tractus sim cp2112 --channel 8"), 2,
                 "'8' is not a whole number from 0 to 7; see \"tractus sim cp2112 --help\"");
    expect_error(run("tractus window --scale 9"), 2, "'9' is not a number from 0 to 8");
    expect_error(run("tractus demo here"), 2, "here; see \"tractus demo --help\"");
    expect_error(run("tractus grow small.l"), 2,
                 "say what to write, such as -o small.glb or -o small.png; see \"tractus grow");
    expect_error(run("tractus grow smal"), 1, "there is no model smal");
    expect_error(run("tractus grow small.l --age 2"), 2,
                 "--age: '2' is not a number from 0.01 to 1");
    expect_error(run("tractus render x.glb --stand 3"), 2, "no option --stand; grow has it");
    expect_error(run("tractus derive small.l"), 2, "--count or --string");
    expect_error(run("tractus derive small.l --count --string"), 2, "excludes");
    expect_error(run("tractus decode x --raw"), 2, "requires --csv");
    expect_error(run("tractus record -o x --simulate hand.toml --seconds 1"), 2, "excludes");
}

TEST_F(Usage, HelpIsACommandToo)
{
    EXPECT_EQ(run("tractus help").out, run("tractus --help").out);
    EXPECT_EQ(run("tractus help grow").out, run("tractus grow --help").out);
    EXPECT_EQ(run("tractus help session log").out, run("tractus session log --help").out);
    expect_error(run("tractus help gorw"), 2, "there is no command gorw (did you mean grow?)");
}

TEST_F(Usage, AMistypedWordIsNamedBeforeWhatIsMissing)
{
    expect_error(run("tractus gorw shrub"), 2,
                 "there is no command gorw (did you mean grow?); see \"tractus --help\"");
    expect_error(run("tractus session expotr x"), 2,
                 "there is no command expotr (did you mean export?)");
    expect_error(run("tractus grow shrub --sede 2"), 2,
                 "there is no option --sede (did you mean --seed?); see \"tractus grow --help\"");
    expect_error(run("tractus grow shrub --girth=2 -o x.glb"), 2, "there is no option --girth;");
    expect_error(run("tractus derive brich --count"), 1,
                 "there is no model brich (did you mean birch?)");
    expect_error(run("tractus leaves count okk --steps 2"), 1,
                 "there is no leaf okk (did you mean oak?)");
    EXPECT_FALSE(exists("x.glb"));
}

TEST_F(Usage, HelpShowsNoNamesOfItsParser)
{
    auto const pages = help_pages();
    EXPECT_GE(pages.size(), 48u);
    for (auto const& help : pages)
        for (char const* const name :
             { "INT:", "TEXT:", "FLOAT:", "FILE:FILE", "ubcommand", ":{", "INT ", "TEXT " })
            EXPECT_EQ(help.find(name), std::string::npos) << name << '\n' << help;
}

TEST_F(Usage, TheShellCompletesLeavesSeasonsRulesAndHabits)
{
    auto const offers = [&](std::string const& typed, std::string const& word) {
        auto const words = "\n" + run("tractus complete -- " + typed).out;
        EXPECT_NE(words.find("\n" + word + "\n"), std::string::npos) << typed << words;
    };
    for (auto const* const word : { "summer", "October" })
        offers("vary shrub --season ''", word);
    for (auto const* const typed :
         { "grow shrub --leaves ''", "leaves count ''", "leaves paint ''" }) {
        offers(typed, "oak");
        offers(typed, ":files");
    }
    offers("grow --habit ''", "larch");
    offers("brush hand.txt --habit l", "larch");
    offers("sketch hand.txt --rule ''", "birch");
    offers("sketch hand.txt --rule ''", ":files");
    offers("silhouette outline.json --style ''", "birch");
    offers("construct lines.json --sizes ''", "half-ellipses");
}

TEST_F(Usage, ALeafIsFoundBesideAFolderOfItsName)
{
    EXPECT_EQ(run("mkdir oak && tractus leaves count oak --steps 2").exit_code, 0);
}

TEST_F(Usage, AReplayHasAFolderOfItsOwnAndWritesOverNobodysFiles)
{
    ASSERT_EQ(
        run("tractus record --simulate hand.toml --plant small.l -o hand.tractus-log").exit_code,
        0);
    auto const replay = std::string("tractus replay hand.tractus-log --plant small.l --count 1 ");
    EXPECT_EQ(run(replay).exit_code, 0);
    EXPECT_TRUE(exists("hand-plants/collection.glb"));
    // A replay may overwrite files that an earlier replay wrote.
    EXPECT_EQ(run(replay).exit_code, 0);
    EXPECT_FALSE(exists("report.txt"));
    run("mkdir mine && echo mine >mine/base.png");
    expect_error(run(replay + "-o mine"), 1, "mine/base.png is there");
    EXPECT_EQ(run("cat mine/base.png").out, "mine\n");
    EXPECT_EQ(run(replay + "-o mine --force").exit_code, 0);
}

TEST_F(Usage, AWindowReplaysOrDraws)
{
    expect_error(run("tractus window hand.tractus-log --record x.tractus-log"), 1,
                 "hand.tractus-log is replayed: --device, --log, --record and --socket are for "
                 "drawing");
    expect_error(run("tractus window none.tractus"), 1, "there is no session none.tractus");
    expect_error(run("tractus window none.tractus --session x.tractus"), 1,
                 "there is no session none.tractus");
    EXPECT_FALSE(exists("x.tractus"));
}

TEST_F(Usage, AValueThatAnOptionCannotHaveIsWrongUsage)
{
    expect_error(run("tractus grow small.l -o x.glb --seed -1"), 2, "'-1' is not a whole number");
    expect_error(run("tractus grow small.l -o x.glb --seed 99999999999999999999"), 2, "--seed");
    expect_error(run("tractus grow small.l -o x.glb -n -1"), 2, "--steps");
    expect_error(run("tractus grow small.l -o x.glb -n many"), 2, "'many' is not a whole number");
    expect_error(run("tractus grow small.l -o x.gif"), 2,
                 "must end in .glb or .obj or .usda or .ply or .stl or .mtg or .html or .png");
    expect_error(run("tractus render x.glb -o x.jpg"), 2, "must end in .png");
    expect_error(run("tractus render x.glb -o x.png --size 0x0"), 2, "WIDTHxHEIGHT");
    expect_error(run("tractus render x.glb -o x.png --size banana"), 2, "'banana' is no size");
    expect_error(run("tractus render x.glb -o x.png --azimuth nan"), 2, "'nan' is not a number");
    expect_error(run("tractus replay x --plant small.l --count 0"), 2, "from 1 to 100");
    for (char const* const height : { "wobble", "nan", "12,5", "120mm", "''", "1e300" })
        expect_error(run(std::string("tractus replay x --plant small.l --height ") + height), 2,
                     "--height: ");
    expect_error(run("tractus demo --plant oak"), 2, "broadleaf, conifer, daisy, shrub, station");
    expect_error(run("tractus record -o x --seconds 0"), 2, "--seconds");
    expect_error(run("tractus window --frames -1"), 2, "--frames");
    EXPECT_FALSE(exists("x.glb"));
}

TEST_F(Usage, OneOfOurModelsIsFoundByItsName)
{
    EXPECT_EQ(run("tractus derive shrub -n 2 --count").exit_code, 0);
    expect_error(run("tractus derive oak --count"), 1, "one of birch, broadleaf, calla");
}

TEST_F(Usage, DevicesAreListedAsTextAndAsJson)
{
    EXPECT_EQ(run("tractus devices").exit_code, 0);
    auto const json = run("tractus devices --json");
    EXPECT_EQ(json.exit_code, 0);
    EXPECT_EQ(json.out.front(), '[');
}

} // namespace
} // namespace tractus
