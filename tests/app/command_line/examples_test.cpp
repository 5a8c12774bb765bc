#include "app/options/examples.h"
#include "tests/app/command_line/workshop.h"

#include <set>
#include <string>

namespace tractus {
namespace {

using Examples = Workshop;

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
