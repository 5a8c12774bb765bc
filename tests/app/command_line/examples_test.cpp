#include "app/options/examples.h"
#include "tests/app/command_line/workshop.h"

#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace tractus {
namespace {

// Commands that methods bring, which also bring their examples. An earlier one may write a file
// that a later one reads.
constexpr char const* kCommandsOfMethods[] = {
    "brush",        "construct",    "silhouette",  "sketch",       "leaves fit",   "leaves list",
    "leaves check", "leaves count", "leaves draw", "leaves paint", "leaves atlas", "leaves",
};

class Examples : public Workshop {
protected:
    // Returns the example lines at the end of a command's help.
    std::vector<std::string> lines_in_help_of(std::string const& command)
    {
        auto const help = run("tractus " + command + " --help").out;
        std::vector<std::string> lines;
        auto const heading = help.find("\nExamples:\n");
        if (heading == std::string::npos)
            return lines;
        std::istringstream text(help.substr(heading));
        for (std::string line; std::getline(text, line);)
            if (line.starts_with("  tractus "))
                lines.push_back(line.substr(2));
        return lines;
    }

    // Writes the files that examples of methods read, as a user would have drawn them.
    void write_drawings()
    {
        write("crown.json",
              R"({"outline": [[-2, 20], [-40, 50], [-32, 90], [-16, 110], [0, 120], [18, 108],
            [34, 88], [40, 52], [2, 20]], "trunk": [[0, 0], [0, 40]]})");
        write("sketch.json", R"({"pattern": "decussate", "stem": [[0, 0], [0, 300]],
            "left": [[-60, 20], [-80, 150], [-10, 290]], "right": [[60, 20], [80, 150], [10, 290]],
            "sizes": "linear", "nodes_per_layer": [5],
            "inclinations": [[[-40, 60], [40, 60]], [[-30, 220], [30, 220]]]})");
        write("leaf.json", R"({"strokes": [
            [[0, 0, 0], [12, 10, 0], [20, 30, 0], [14, 55, 0], [0, 80, 0]],
            [[0, 0, 0], [-12, 10, 0], [-20, 30, 0], [-14, 55, 0], [0, 80, 0]],
            [[0, 0, 0], [0, 40, 0], [0, 80, 0]]]})");
    }
};

TEST_F(Examples, RunInAnEmptyFolderOneAfterAnother)
{
    run("rm small.l hand.toml");
    for (auto const& example : options::examples()) {
        if (!example.runs)
            continue;
        auto const outcome = run(std::string("tractus ") + example.line);
        EXPECT_EQ(outcome.exit_code, 0) << example.line << '\n' << outcome.err;
    }
}

TEST_F(Examples, BelongToCommandsThatThereAreAndEndTheirHelp)
{
    std::set<std::string> commands;
    for (auto const& example : options::examples())
        if (commands.insert(example.command).second) {
            auto const help = run(std::string("tractus ") + example.command + " --help");
            EXPECT_EQ(help.exit_code, 0) << example.command;
            EXPECT_NE(help.out.find(std::string("Examples:\n  tractus ") + example.line + "\n"),
                      std::string::npos)
                << help.out;
        }
}

TEST_F(Examples, OfMethodsRunToo)
{
    ASSERT_EQ(run("tractus record --device simulated --seconds 4 -o hand.tractus-log").exit_code,
              0);
    write_drawings();
    for (std::string const command : kCommandsOfMethods) {
        auto const lines = lines_in_help_of(command);
        EXPECT_FALSE(lines.empty()) << command;
        for (auto const& line : lines) {
            EXPECT_TRUE(line.starts_with("tractus " + command + " ")
                        || line == "tractus " + command)
                << line;
            auto const outcome = run(line);
            EXPECT_EQ(outcome.exit_code, 0) << line << '\n' << outcome.err;
        }
    }
}

// Some examples are not run by any test. At least the options in them must exist.
TEST_F(Examples, NameOptionsThatThereAre)
{
    for (auto const& example : options::examples()) {
        auto const help = run(std::string("tractus ") + example.command + " --help").out;
        std::string const line = example.line;
        for (auto at = line.find(" --"); at != std::string::npos; at = line.find(" --", at + 1)) {
            auto const name = line.substr(at + 1, line.find(' ', at + 1) - at - 1);
            EXPECT_NE(help.find(name), std::string::npos) << example.line;
        }
    }
}

} // namespace
} // namespace tractus
