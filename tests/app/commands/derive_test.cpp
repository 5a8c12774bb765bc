#include "engine/base/file.h"
#include "tests/app/commands/outcome.h"

#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>
#include <string>
#include <unistd.h>
#include <vector>

namespace tractus::commands {
namespace {

namespace fs = std::filesystem;

class DeriveCommand : public ::testing::Test {
protected:
    void SetUp() override { fs::create_directories(folder_); }
    void TearDown() override { fs::remove_all(folder_); }

    std::string write(std::string const& name, std::string const& text)
    {
        auto const path = folder_ / name;
        EXPECT_TRUE(write_file(path, text));
        return path.string();
    }

    fs::path const folder_
        = fs::temp_directory_path() / ("tractus_derive_test_" + std::to_string(getpid()));
};

constexpr char const* kRules = "Lsystem: 1\nderivation length: 2\nAxiom: A(1)\n"
                               "A(x) --> F(x/3)[+A(x*2)]\nendlsystem\n";

TEST_F(DeriveCommand, PrintsTheStringOnOneLine)
{
    auto const outcome = run({ "derive", write("m.l", kRules), "--string" });
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "F(0.333333)[+F(0.666667)[+A(4)]]\n");
    EXPECT_EQ(outcome.err, "");
}

TEST_F(DeriveCommand, CountsSymbolsAfterSoManySteps)
{
    auto const outcome = run({ "derive", write("m.l", kRules), "-n", "1", "--count" });
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "{\"+\":1,\"A\":1,\"F\":1,\"[\":1,\"]\":1}\n");
}

TEST_F(DeriveCommand, NamesThePlaceOfAnError)
{
    auto const path = write("bad.l", "Lsystem: 1\nAxiom: A\nA --> F(\n");
    auto const outcome = run({ "derive", path, "--string" });
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.err,
              "error: " + path
                  + ":3:9: found the end of the line, expected a number, a name or '('\n");
}

TEST_F(DeriveCommand, ReadsIncludesFromTheModelsFolderOnly)
{
    write("constants.h", "#define LENGTH 7\n");
    auto const good
        = write("good.l", "#include \"constants.h\"\nLsystem: 1\nAxiom: F(LENGTH)\nendlsystem\n");
    EXPECT_EQ(run({ "derive", good, "--string" }).out, "F(7)\n");
    auto const bad
        = write("bad.l", "#include \"../constants.h\"\nLsystem: 1\nAxiom: F\nendlsystem\n");
    auto const outcome = run({ "derive", bad, "--string" });
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_NE(outcome.err.find("outside the model's folder"), std::string::npos) << outcome.err;
}

// cpfg has colour files as arguments of its command line; here they are found beside the model.
TEST_F(DeriveCommand, FindsColorsBesideTheModel)
{
    auto const path = write("m.l", kRules);
    write("m.v", "material: 1 wood kind=bark color=0.4,0.3,0.2\n");
    write("m.map", std::string(9, 'x')); // Three colours; the view already defines one of them.
    auto const outcome = run({ "lsystem", "check", path });
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("3 materials"), std::string::npos) << outcome.out;
    write("other.mat", std::string("\x07") + std::string(14, 'x')); // The folder's only .mat file.
    EXPECT_NE(run({ "lsystem", "check", path }).out.find("4 materials"), std::string::npos);
    write("m.mat", "");
    EXPECT_NE(run({ "lsystem", "check", path }).err.find("expected materials"), std::string::npos);
}

TEST_F(DeriveCommand, WantsOneKindOfOutput)
{
    auto const path = write("m.l", kRules);
    EXPECT_EQ(run({ "derive", path }).exit_code, 2);
    EXPECT_EQ(run({ "derive", path, "--count", "--string" }).exit_code, 2);
}

TEST_F(DeriveCommand, StopsARunawayModel)
{
    auto const path
        = write("m.l", "Lsystem: 1\nderivation length: 90\nAxiom: A\nA --> AA\nendlsystem\n");
    auto const outcome = run({ "derive", path, "--count", "--max-modules", "1000" });
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_NE(outcome.err.find("more than 1000 modules"), std::string::npos) << outcome.err;
}

TEST_F(DeriveCommand, StopsAModelThatNeverEnds)
{
    auto const path = write("m.l",
                            "Lsystem: 1\nderivation length: 1000000000\nAxiom: A\n"
                            "A : {x=Q;} 1 --> A\nendlsystem\n");
    for (auto const* const command : { "derive", "grow" }) {
        std::vector<std::string> arguments { command, path, "--max-seconds", "0.01" };
        if (command == std::string("grow"))
            arguments.insert(arguments.end(), { "-o", (folder_ / "x.glb").string() });
        else
            arguments.emplace_back("--count");
        auto const outcome = run(arguments);
        EXPECT_EQ(outcome.exit_code, 1);
        EXPECT_NE(outcome.err.find("was not done when 0.01 s had passed"), std::string::npos)
            << outcome.err;
    }
}

TEST_F(DeriveCommand, StopsAModelThatNeedsTooMuchMemory)
{
    auto const path
        = write("m.l", "Lsystem: 1\nderivation length: 90\nAxiom: A\nA --> AA\nendlsystem\n");
    auto const outcome = run({ "lsystem", "check", path, "--max-memory", "4" });
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_NE(outcome.err.find("needs more than 4 MB of memory"), std::string::npos) << outcome.err;
}

TEST_F(DeriveCommand, PrintsWhatTheModelPrintsToStandardError)
{
    auto const path = write("m.l",
                            "Lsystem: 1\nderivation length: 2\n"
                            "EndEach: {printf(\"step %d\\n\", Q);}\nAxiom: A\n"
                            "A --> B\nendlsystem\n");
    auto const outcome = run({ "derive", path, "--string" });
    EXPECT_EQ(outcome.out, "B\n");
    EXPECT_EQ(outcome.err, "step 1\nstep 2\n");
}

TEST_F(DeriveCommand, EndsWhatTheModelPrintsSomewhere)
{
    auto const path = write("m.l",
                            "Lsystem: 1\nderivation length: 20000\n"
                            "EndEach: {printf(\"0123456789\");}\nAxiom: F\n"
                            "endlsystem\n");
    auto const outcome = run({ "derive", path, "--string" });
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.err.substr(100'000),
              "\nwarning: the model prints more than 100000 characters; the rest is left out\n");
}

TEST_F(DeriveCommand, TellsWhatAModelUses)
{
    auto const path = write("m.l",
                            "Lsystem: 1\nderivation length: 2\nSeed: 0\nAxiom: A(1)\n"
                            "A(x) : x > 0 --> F(x)[+A(x*2)]@Q : 2\nB < A(x) --> B\nendlsystem\n");
    auto const outcome = run({ "lsystem", "check", path });
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.out,
              path
                  + ": understood\n\nUses\n  2 rules\n  conditions\n  left context\n"
                    "  rules chosen at random\n  parameters\n\n"
                    "Step      modules   parameters\n"
                    "   0            1            1\n"
                    "   1            7            2\n"
                    "   2           13            3\n\n"
                    "Draws 2 segments on 2 axes, 0 organs, 0 polygons\n\n"
                    "Warnings\n  "
                  + path
                  + ": the turtle symbol @Q is not supported; it draws nothing\n\n"
                    "Cannot be grown along a stroke: it has not the places for it that the manual "
                    "lists (models.md)\n");
    EXPECT_EQ(outcome.err, "");
}

TEST_F(DeriveCommand, TellsWhatAModelUsesOfSubLSystemsAndQueries)
{
    auto const path = write("m.l",
                            "Lsystem: 1\nAxiom: A%?(2)B$?P(0,0,0)\n"
                            "Start: {n=1; printf(\"%d\", n);}\nA --> B\nendlsystem\n"
                            "Lsystem: 2\ndefine: { external n; }\n"
                            "B : {SetDerivationLength(n);} 1 --> B\nendlsystem\n");
    auto const outcome = run({ "lsystem", "check", path });
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("Uses\n  1 rule\n  parameters\n  cuts\n  query modules\n"
                               "  Start block\n  1 global variable\n  printf\n"
                               "  a derivation length that the model changes\n"
                               "  sub-L-system 2: 1 rule, conditions, 1 external name\n"),
              std::string::npos)
        << outcome.out;
    EXPECT_EQ(outcome.err, "1");
}

TEST_F(DeriveCommand, ChecksOurModelsWithoutWarnings)
{
    auto const outcome = run({ "lsystem", "check", "daisy", "-n", "5" });
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("homomorphism of 14 rules, to depth 40"), std::string::npos)
        << outcome.out;
    EXPECT_NE(outcome.out.find("\nNo warnings\n"), std::string::npos) << outcome.out;
}

TEST_F(DeriveCommand, PrintsWhatTheTurtleReads)
{
    auto const model
        = write("m.l", "Lsystem: 1\nAxiom: A(2)\nhomomorphism\nA(x) --> F(x)F(x/2)\nendlsystem\n");
    EXPECT_EQ(run({ "derive", model, "--string" }).out, "A(2)\n");
    EXPECT_EQ(run({ "derive", model, "--string", "--homomorphism" }).out, "F(2)F(1)\n");
}

TEST_F(DeriveCommand, AsksAnEnvironment)
{
    auto const model = write("m.l", "Lsystem: 1\nAxiom: ?E(0,1)?E(0,1)\nendlsystem\n");
    EXPECT_EQ(run({ "derive", model, "--string" }).out, "?E(0,1)?E(0,1)\n");
    EXPECT_EQ(run({ "derive", model, "--string", "--environment", "space" }).out,
              // Both queries are at the same place, so the second counts as the same organ asking
              // again.
              "?E(1,1)?E(1,1)\n");
    EXPECT_EQ(run({ "derive", model, "--string", "--environment", "light:shade=0.25" }).out,
              "?E(0.75,1)?E(0.75,1)\n");
    auto const wrong = run({ "derive", model, "--string", "--environment", "sun" });
    EXPECT_EQ(wrong.exit_code, 1);
    EXPECT_EQ(wrong.err,
              "error: there is no environment 'sun'; there are light, space, terrain and water\n");
}

// A control panel's file is not a model. With only one model in the folder, all colour files belong
// to it.
TEST_F(DeriveCommand, WarnsOfColoursThatItDoesNotUse)
{
    auto const model = write("m.l", kRules);
    auto const colors = write("other.map", std::string(768, 'c'));
    write("panel.l", "control panel:\nbackground: 1,2,3\n");
    EXPECT_EQ(run({ "derive", model, "--string" }).err, "");
    write("second.l", kRules);
    auto const unused = run({ "derive", model, "--string" });
    EXPECT_EQ(unused.exit_code, 0);
    EXPECT_EQ(unused.err,
              "warning: " + colors + " is not used, since its name is not the model's; --colors "
                  + colors + " uses it\n");
    EXPECT_EQ(run({ "derive", model, "--string", "--colors", colors }).err, "");
    EXPECT_EQ(run({ "derive", model, "--string", "--colors", model }).exit_code, 1);
}

// Views and colours with the name of another model belong to that model, so there is no warning for
// them.
TEST_F(DeriveCommand, WarnsOfWhatLiesBesideWhatItUses)
{
    auto const model = write("m.l", kRules);
    write("m.v", "angle increment: 90\n");
    write("m.map", std::string(768, 'c'));
    EXPECT_EQ(run({ "derive", model, "--string" }).err, "");
    write("second.l", kRules);
    write("second.v", "angle increment: 30\n");
    EXPECT_EQ(run({ "derive", model, "--string" }).err, "");
    auto const colors = write("autumn.map", std::string(768, 'c'));
    auto const view = write("near.v", "angle increment: 30\n");
    auto const warnings = "warning: " + view + " is not used, since its name is not the model's; "
        + "--view " + view + " uses it\nwarning: " + colors
        + " is not used, since its name is not the model's; --colors " + colors + " uses it\n";
    auto const out = (folder_ / "out.glb").string();
    EXPECT_EQ(run({ "derive", model, "--string" }).err, warnings);
    EXPECT_EQ(run({ "lsystem", "check", model }).err, warnings);
    EXPECT_EQ(run({ "grow", model, "-o", out }).err, warnings);
    EXPECT_EQ(run({ "vary", model, "--count", "1", "-o", out }).err.substr(0, warnings.size()),
              warnings);
    EXPECT_EQ(run({ "derive", model, "--string", "--view", view, "--colors", colors }).err, "");
}

TEST_F(DeriveCommand, TakesTheViewThatItIsGiven)
{
    auto const model = write("m.l", "Lsystem: 1\nAxiom: ?E(0)\nendlsystem\n");
    auto const view = write("other.v", "environment: terrain\n");
    EXPECT_NE(run({ "derive", model, "--string" }).err.find("--view"), std::string::npos);
    write("m.v", "environment: light\n");
    EXPECT_EQ(run({ "derive", model, "--string" }).out, "?E(1)\n");
    EXPECT_EQ(run({ "derive", model, "--string", "--view", view }).out, "?E(0)\n");
}

// Warnings about the model come before those about unused files, and only three unused files are
// named.
TEST_F(DeriveCommand, TellsOfThreeUnusedFilesAfterTheModelsWarnings)
{
    auto const model = write("m.l", "Lsystem: 1\nAxiom: F'\nendlsystem\n");
    for (auto const* const name : { "a.v", "b.v", "c.v", "d.v", "e.v" })
        write(name, "angle increment: 30\n");
    auto const out = (folder_ / "out.obj").string();
    for (std::vector<std::string> const& command :
         { std::vector<std::string> { "derive", model, "--count" },
           std::vector<std::string> { "grow", model, "-o", out } }) {
        auto const err = run(command).err;
        EXPECT_EQ(err.find("warning: " + model + ":2:9: ' has no effect here"), 0u) << err;
        EXPECT_EQ(std::count(err.begin(), err.end(), '\n'), 5) << err;
        EXPECT_NE(err.find("c.v is not used"), std::string::npos) << err;
        EXPECT_NE(err.find("\nwarning: 2 more views and colour files beside " + model
                           + " are not used\n"),
                  std::string::npos)
            << err;
    }
}

TEST_F(DeriveCommand, ReadsTheBooksNotation)
{
    // Figure 1.25 of The Algorithmic Beauty of Plants, as printed: 3 ** 7 apices are left.
    auto const bush = write("bush.l",
                            "n=7, \u03b4=22.5\u00b0\n\u03c9: A\n"
                            "p1 : A \u2192 [&FL!A]/////'[&FL!A]///////'[&FL!A]\n"
                            "p2 : F \u2192 S/////F\np3 : S \u2192 FL\n"
                            "p4 : L \u2192 ['''^^{-f+f+f-|-f+f+f}]\n");
    auto const checked = run({ "lsystem", "check", bush, "--dialect", "book" });
    EXPECT_EQ(checked.exit_code, 0) << checked.err;
    EXPECT_NE(checked.out.find("\nDraws 3891 segments on "), std::string::npos) << checked.out;
    EXPECT_NE(checked.out.find("\nNo warnings\n"), std::string::npos) << checked.out;
    auto const counts = run({ "derive", bush, "--dialect", "book", "--count" });
    EXPECT_NE(counts.out.find("\"A\":2187"), std::string::npos) << counts.out;
    auto const made = (folder_ / "made.l").string();
    EXPECT_EQ(run({ "lsystem", "import", bush, "-o", made }).exit_code, 0);
    EXPECT_EQ(run({ "derive", made, "--count" }).out, counts.out);
    EXPECT_EQ(run({ "lsystem", "import", bush, "-o", made }).exit_code, 1);
    EXPECT_EQ(run({ "derive", bush, "--dialect", "latin", "--count" }).exit_code, 2);
}

TEST_F(DeriveCommand, NamesForeignFilesAndImportsLParsers)
{
    auto const lpy = write("a.lpy", "Axiom: A\nproduction:\nA --> F[+A]A\n");
    auto const out = (folder_ / "out.obj").string();
    for (std::vector<std::string> const& command :
         { std::vector<std::string> { "lsystem", "check", lpy },
           std::vector<std::string> { "derive", lpy, "--count" },
           std::vector<std::string> { "grow", lpy, "-o", out },
           std::vector<std::string> { "vary", lpy, "--count", "1", "-o", out },
           std::vector<std::string> { "lsystem", "import", lpy, "-o", out } }) {
        auto const outcome = run(command);
        EXPECT_EQ(outcome.exit_code, 1);
        EXPECT_EQ(outcome.err.find("error: " + lpy + ":2: this is L-Py (Python), not cpfg's"), 0u)
            << outcome.err;
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    }
    auto const tree = write("tree.ls", "3\n30\n20\nA\nA=F['+A][-A]\n@\n");
    EXPECT_NE(run({ "grow", tree, "-o", out }).err.find("\"tractus lsystem import " + tree),
              std::string::npos);
    auto const made = (folder_ / "tree.l").string();
    EXPECT_EQ(run({ "lsystem", "import", tree, "-o", made }).exit_code, 0);
    EXPECT_NE(run({ "lsystem", "check", made }).out.find("Draws 7 segments on 7 axes"),
              std::string::npos);
}

TEST_F(DeriveCommand, DerivesTheModelThatIsWrittenToBeginWith)
{
    auto const path = (folder_ / "mine.l").string();
    EXPECT_EQ(run({ "lsystem", "new", path }).exit_code, 0);
    auto const derived = run({ "derive", path, "--count" });
    EXPECT_EQ(derived.exit_code, 0);
    EXPECT_EQ(derived.err, "");
    EXPECT_NE(derived.out.find("\"F\":255"), std::string::npos) << derived.out;
    auto const checked = run({ "lsystem", "check", path });
    EXPECT_NE(checked.out.find("\nNo warnings\n"), std::string::npos) << checked.out;
    EXPECT_NE(checked.out.find("255 segments on 255 axes, 128 organs"), std::string::npos);
    auto const view = run({ "lsystem", "new", (folder_ / "mine.v").string() });
    EXPECT_NE(view.err.find("mine.v is the name of a view"), std::string::npos);
    auto const again = run({ "lsystem", "new", path });
    EXPECT_EQ(again.exit_code, 1);
    EXPECT_NE(again.err.find("is there already"), std::string::npos);
}

} // namespace
} // namespace tractus::commands
