#include "engine/lsystem/rewriting/homomorphism.h"
#include "tests/engine/lsystem/small_model.h"

#include <gtest/gtest.h>

namespace tractus::lsystem {
namespace {

// Returns the text of a model with a main L-system and one sub-L-system, which has the number 2.
std::string two_systems(std::string const& main, std::string const& sub, int steps = 1)
{
    return with_header(main, steps) + "\nLsystem: 2\n" + sub + "\nendlsystem\n";
}

std::string derived_text(std::string const& text)
{
    auto const model = compiled(text);
    // Short examples have letters without a rule, which cause a warning.
    for (auto const& warning : model.warnings)
        EXPECT_NE(warning.find(" has no effect"), std::string::npos) << warning;
    auto const string = derive(model);
    EXPECT_TRUE(string) << string.error().message;
    return string ? to_string(model, *string) : std::string();
}

// Returns the text that blocks and rules print, in order.
std::string printed_by(std::string const& text)
{
    auto const model = compiled(text);
    std::string result;
    DeriveOptions options;
    options.print = [&](std::string_view printed) { result += printed; };
    auto const string = derive(model, options);
    EXPECT_TRUE(string) << string.error().message;
    return result;
}

std::string derive_error(std::string const& text)
{
    auto const string = derive(compiled(text));
    if (string)
        return "no error";
    EXPECT_EQ(string.error().fault, Fault::User);
    return string.error().message;
}

TEST(Subsystems, RewriteWhatFollowsUpToTheirEnd)
{
    EXPECT_EQ(derived_text(two_systems("Axiom: A?(2)A$A\nA --> B", "Axiom: A\nA --> C")),
              "B?(2)C$B");
    EXPECT_EQ(derived_text(two_systems("Axiom: A[?(2,0.5)AA$A]A\nA --> B", "A --> C")),
              "B[?(2,0.5)CC$B]B");
}

TEST(Subsystems, LeaveTheirCallToTheCallerAndRewriteTheirEnd)
{
    EXPECT_EQ(derived_text(two_systems("Axiom: ?(2,1)A$B\n?(n,s) --> ?(n,s/2)X\n$ --> Y",
                                       "?(n,s) --> Y\nA --> C\n$ --> Z$")),
              "?(2,0.5)XCZ$B");
}

TEST(Subsystems, AreCalledAndEndedByRules)
{
    auto const text
        = two_systems("Axiom: A\nA --> ?(2)A(3)$", "A(n) : n>0 --> BA(n-1)\nA(n) --> $C", 6);
    // The call appears in the first step. The last rule of its L-system ends it by a $, so the C
    // behind this $ belongs to the main L-system.
    EXPECT_EQ(derived_text(text), "?(2)BBB$C$");
}

TEST(Subsystems, KeepVariablesForEachCall)
{
    auto const sub = "define: { array a[2] = {5, 6}; }\nStart: { n = 10; }\n"
                     "StartEach: { n = n + 1; a[0] = a[0] + 1; }\nA --> A(n, a[0])\n"
                     "A(x,y) --> A(n, a[0])";
    EXPECT_EQ(derived_text(two_systems("Axiom: ?(2)A$B\nB --> ?(2)A$", sub, 1)),
              "?(2)A(11,6)$?(2)A$");
    EXPECT_EQ(derived_text(two_systems("Axiom: ?(2)A$B\nB --> ?(2)A$", sub, 4)),
              "?(2)A(14,9)$?(2)A(13,8)$");
}

TEST(Subsystems, RunTheirBlocksInOrder)
{
    auto const text = two_systems("Start: { printf(\"<\"); }\nStartEach: { printf(\"(\"); }\n"
                                  "EndEach: { printf(\")\"); }\nEnd: { printf(\">\"); }\n"
                                  "Axiom: ?(2)A$B\nB : { printf(\"B\"); } 1 --> B",
                                  "Start: { printf(\"s\"); }\nStartEach: { printf(\"[\"); }\n"
                                  "EndEach: { printf(\"]\"); }\nEnd: { printf(\"e\"); }\n"
                                  "A : { printf(\"A\"); } 1 --> A",
                                  2);
    EXPECT_EQ(printed_by(text), "<(s[A]B)([A]eB)>");
}

TEST(Subsystems, EndWhenTheirCallGoes)
{
    auto const sub = "EndEach: { printf(\"]\"); }\nEnd: { printf(\"e\"); }\nA --> A";
    EXPECT_EQ(printed_by(two_systems("Axiom: ?(2)A$\n?(n) : Q==2 --> X", sub, 4)), "]]e");
    EXPECT_EQ(printed_by(two_systems("Axiom: [B?(2)A$]\nB : Q==2 --> %", sub, 4)), "]]]e");
}

TEST(Subsystems, CutToTheEndOfTheirString)
{
    EXPECT_EQ(derived_text(two_systems("Axiom: ?(2)AB$B", "A --> A%", 2)), "?(2)A%$B");
    EXPECT_EQ(derived_text(two_systems("Axiom: ?(2)A%?(3)B$C$B", "A --> D")
                           + "Lsystem: 3\nB --> E\nendlsystem\n"),
              "?(2)D$B");
}

TEST(Subsystems, CallOthersAndShareExternalVariables)
{
    auto const text = with_header("Start: { n = 1; m = 5; }\nAxiom: ?(2)A?(3)A$A$A\nA --> A(n,m)")
        + "Lsystem: 2\ndefine: { external n; array a[2] = {7, 8}; }\nStart: { m = 9; }\n"
          "A : {n = n + 1;} 1 --> A(n,m)\nendlsystem\n"
          "Lsystem: 3\ndefine: { external n, m, a[2]; }\n"
          "A : {n = n * 10; a[1] = a[1] + 1;} 1 --> A(n,m,a[0],a[1])\nendlsystem\n";
    EXPECT_EQ(derived_text(text), "?(2)A(2,9)?(3)A(20,9,7,9)$A(21,9)$A(21,5)");
}

TEST(Subsystems, KeepTheirOwnContexts)
{
    EXPECT_EQ(derived_text(two_systems("ignore: +\nAxiom: A+B?(2)A+B$\nA < B --> X",
                                       "ignore: -\nA < B --> X\n+ < B --> Y")),
              "A+X?(2)A+Y$");
}

TEST(Subsystems, HaveDecompositionAndHomomorphismOfTheirOwn)
{
    auto const model = compiled(two_systems("Axiom: A?(2)A$A\nhomomorphism\nA --> F",
                                            "Start: { n = 3; }\nA --> B\ndecomposition\n"
                                            "B --> CD\nhomomorphism\nC --> G(n)\nA --> f"));
    auto const string = derive(model);
    ASSERT_TRUE(string) << string.error().message;
    EXPECT_EQ(to_string(model, *string), "A?(2)CD$A");
    auto const drawn_string = apply_homomorphism(model, *string);
    ASSERT_TRUE(drawn_string) << drawn_string.error().message;
    EXPECT_EQ(to_string(model, *drawn_string), "F?(2)G(3)D$F");
}

TEST(Subsystems, NameACallOfNothing)
{
    EXPECT_EQ(derive_error(two_systems("Axiom: ?(7)A$", "A --> B")),
              "model.l: found ?(7), expected the number of one of the file's sub-L-systems");
    EXPECT_EQ(derive_error(two_systems("Axiom: ?(2)A$", "A --> ?(2)A$", 3)),
              "model.l: found ?(2) between another ?(2) and its $; a sub-L-system cannot call "
              "itself");
    EXPECT_EQ(compile_error(two_systems("Axiom: A", "A --> B") + "Lsystem: 2\n"),
              "model.l:9:9: found a second L-system 2, expected another number");
}

TEST(Subsystems, ScaleWhatTheyDraw)
{
    auto const model = compiled(
        with_header("Axiom: !(2)F(1)?(2,0.5)F(1)?(3,0.5)F(1)$F(1)$F(1)", 0)
        + "Lsystem: 2\nhomomorphism\nF(l) --> F(l)%\nendlsystem\nLsystem: 3\nendlsystem\n");
    auto const plant = interpret(model, *derive(model), { .unit_mm = 1 });
    ASSERT_TRUE(plant) << plant.error().message;
    ASSERT_EQ(plant->axes.size(), 1u);
    std::vector<double> heights;
    std::vector<float> radii;
    for (std::size_t i = 0; i < plant->node_position_mm.size(); ++i) {
        heights.push_back(plant->node_position_mm[i].z());
        radii.push_back(plant->node_radius_mm[i]);
    }
    EXPECT_EQ(heights, (std::vector<double> { 0, 1, 1.5, 1.75, 2.25, 3.25 }));
    EXPECT_EQ(radii, (std::vector<float> { 1, 0.5f, 0.25f, 0.5f, 1, 1 }));
}

TEST(Subsystems, LeaveModelsWithoutThemAlone)
{
    EXPECT_EQ(derived("Axiom: ?(7)A$B\nA --> X"), "?(7)X$B");
    auto const model = compiled("Lsystem: 1\nAxiom: F\nendlsystem\nhello\n");
    ASSERT_EQ(model.warnings.size(), 1u);
    EXPECT_EQ(model.warnings[0],
              "model.l:4:1: what follows endlsystem is not read, since it is no 'Lsystem:'");
}

// Each text must be printed only once, in the order of the string.
TEST(Subsystems, PrintWhatTheirHomomorphismsPrint)
{
    auto const model = compiled("Lsystem: 1\nderivation length: 0\nAxiom: B?(2)A(1)$B\n"
                                "homomorphism\nB : 1 {printf(\"b\");} --> F\nendlsystem\n"
                                "Lsystem: 2\nderivation length: 0\nAxiom: A(0)\nhomomorphism\n"
                                "A(x) : 1 {printf(\"%g\", x);} --> F\nendlsystem\n");
    std::string printed;
    auto const plant = interpret(model, derive(model).value(),
                                 { .print = [&](std::string_view text) { printed += text; } });
    ASSERT_TRUE(plant) << plant.error().message;
    EXPECT_EQ(printed, "b1b");
}

} // namespace
} // namespace tractus::lsystem
