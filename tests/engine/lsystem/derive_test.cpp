#include "engine/lsystem/derivation/derive.h"
#include "engine/lsystem/rewriting/homomorphism.h"

#include "tests/engine/lsystem/small_model.h"

#include <cmath>
#include <gtest/gtest.h>

namespace tractus::lsystem {
namespace {

TEST(Rules, ApplyInParallel)
{
    EXPECT_EQ(derived("Axiom: AB\nA --> B\nB --> A"), "BA");
}

TEST(Rules, FirstThatMatchesWins)
{
    EXPECT_EQ(derived("Axiom: A(1)A(5)\nA(x) : x<3 --> B\nA(x) --> C(x)"), "BC(5)");
}

TEST(Rules, MatchTheNumberOfParameters)
{
    EXPECT_EQ(derived("Axiom: AA(1)A(1,2)\nA(x) --> B"), "ABA(1,2)");
}

TEST(Rules, ReplaceSeveralModulesAtOnce)
{
    EXPECT_EQ(derived("Axiom: ABAAB\nAB --> x"), "xAx");
    EXPECT_EQ(derived("Axiom: @o(2)o(2)\n@o(s) --> *"), "o(2)");
}

TEST(Rules, EndAtTheLinesEndUnlessATabFollows)
{
    EXPECT_EQ(derived("Axiom: AC\nA --> B\n\tB\n  B\nC --> D"), "BBBD");
    EXPECT_EQ(derived("Axiom: AC\nA\n\t--> B\n C --> D"), "BD");
}

TEST(Contexts, RightPassesOverBranches)
{
    EXPECT_EQ(derived("Axiom: A[X][Y[Z]]B\nA > B --> 1"), "1[X][Y[Z]]B");
    EXPECT_EQ(derived("Axiom: [A]B\nA > B --> 1"), "[A]B");
    EXPECT_EQ(derived("Axiom: A[X]B\nA > [X]B --> 1"), "1[X]B");
    EXPECT_EQ(derived("Axiom: A[XY]B\nA > [X=]B --> 1"), "1[XY]B");
}

TEST(Contexts, LeftClimbsDownTheBranch)
{
    EXPECT_EQ(derived("Axiom: A[X][YB]B\nA < B --> 1"), "A[X][YB]1");
    EXPECT_EQ(derived("Axiom: A[[B]]\nA < B --> 1"), "A[[1]]");
    EXPECT_EQ(derived("Axiom: CA[X]B\nCA < B --> 1"), "CA[X]1");
}

TEST(Contexts, PassOverIgnoredSymbols)
{
    EXPECT_EQ(derived("ignore: +-\nAxiom: A+B-C\nA < B > C --> 1"), "A+1-C");
    EXPECT_EQ(derived("consider: ABC\nAxiom: A+B-C\nA < B > C --> 1"), "A+1-C");
    EXPECT_EQ(derived("Axiom: A+B\nA < B --> 1"), "A+B");
}

TEST(Contexts, GiveTheirParameters)
{
    EXPECT_EQ(derived("Axiom: A(1)B(2)[X]C(3)D(4)\nA(a) < B(b) > C(c)D(d) --> E(a,b,c,d)"),
              "A(1)E(1,2,3,4)[X]C(3)D(4)");
    EXPECT_EQ(derived("Axiom: A(1)B(2)C(3)\nA(a)B(b) < C(c) --> E(a,b,c)"), "A(1)B(2)E(1,2,3)");
}

TEST(Contexts, GoRoundARing)
{
    EXPECT_EQ(derived("ring L-system\nAxiom: ABBB\nA < B --> A\nB < A --> B"), "BABB");
    EXPECT_EQ(derived("ring L-system\nAxiom: A\nB < A --> C"), "A");
}

TEST(Expressions, HaveCpfgsPrecedence)
{
    EXPECT_EQ(derived("Axiom: A(-2^2, 2^3^2, 2+3*4, 10-2-3, 7%4, !0, 1<2, 2==2&&0||1, 1?2:3)", 0),
              "A(4,64,14,5,3,1,1,1,2)");
    EXPECT_EQ(derived("Axiom: A(1/0, trunc(2.5), floor(-0.5), ceil(0.5), sign(-3), fabs(-2))", 0),
              "A(1,3,-1,1,-1,2)");
}

TEST(Expressions, CountAnglesInDegrees)
{
    EXPECT_EQ(derived("Axiom: A(sin(30), cos(60), atan(1), asin(1), atan2(0, 1))", 0),
              "A(0.5,0.5,45,90,90)");
}

TEST(Statements, RunBeforeAndAfterTheCondition)
{
    EXPECT_EQ(derived("Axiom: A(3)\nA(x) : {y=x*2; x=x+1;} y==6 {z=y+x;} --> B(x,y,z)"),
              "B(4,6,10)");
    EXPECT_EQ(derived("Axiom: A(5)\nA(n) : {s=0; i=1; while (i<=n) {s=s+i; i=i+1;} if (s>14) "
                      "{s=-s;} else {s=0;}} 1 --> B(s)"),
              "B(-15)");
}

TEST(Statements, KeepGlobalsAndArrays)
{
    EXPECT_EQ(
        derived(
            "define: {array a[2][2] = {1,2,3,4};}\nStart: {n=10;}\nStartEach: {n=n+1; a[1][0]=n;}\n"
            "Axiom: A\nA --> B(n, a[1][0], a[0][1], Q, Z)",
            1),
        "B(11,11,2,1,1)");
}

TEST(Statements, KeepLocalsFromMatchToMatch)
{
    EXPECT_EQ(derived("Axiom: A(1)A(0)\nA(x) : {if (x) {y=5;}} 1 --> B(y)"), "B(5)B(5)");
}

TEST(Statements, StopALoopThatDoesNotEnd)
{
    auto const model = compiled(with_header("Axiom: A\nA : {x=1; while (x) {x=1;}} 1 --> B"));
    auto const string = derive(model);
    ASSERT_FALSE(string);
    EXPECT_EQ(string.error().message,
              "model.l: in step 1 a loop did not end within 10 million rounds; look whether its "
              "condition ever becomes 0");
}

// Returns the text that a model prints while it is derived.
std::string printed(std::string const& axiom_and_rules, int steps = 1)
{
    auto const model = compiled(with_header(axiom_and_rules, steps));
    // Short examples have letters without a rule, which cause a warning.
    for (auto const& warning : model.warnings)
        EXPECT_NE(warning.find(" has no effect"), std::string::npos) << warning;
    std::string result;
    DeriveOptions options;
    options.print = [&](std::string_view text) { result += text; };
    EXPECT_TRUE(derive(model, options));
    return result;
}

TEST(Printing, FormatsNumbers)
{
    EXPECT_EQ(printed("Start: {printf(\"%g %5.2f|%-4d|%04d|%x|100%%\\n\", 0.5, 1/3, 7.9, -3, "
                      "255);}\nAxiom: A"),
              "0.5  0.33|7   |-003|ff|100%\n");
    EXPECT_EQ(printed("Start: {printf(\"\\\"a\\tb\\\"\");}\nAxiom: A"), "\"a\tb\"");
}

TEST(Printing, KeepsTheOrderOfModules)
{
    EXPECT_EQ(printed("Axiom: A(1)A(2)A(3)\nA(x) : {printf(\"<%g\", x);} x>1 "
                      "{printf(\">\");} --> B"),
              "<1<2><3>");
}

TEST(DerivationLength, IsChangedByTheModelUnlessTheStepsAreGiven)
{
    auto const rules = "EndEach: {if (Q==2) {SetDerivationLength(5);}}\nAxiom: A(0)\n"
                       "A(x) --> A(GetDerivationLength(0))";
    EXPECT_EQ(derived(rules, 2), "A(5)");
    EXPECT_EQ(derived("EndEach: {SetDerivationLength(3);}\nAxiom: A\nA --> AB", 9), "ABBB");
    auto const model = compiled(with_header(rules, 2));
    EXPECT_EQ(to_string(model, *derive(model, { .steps = 2 })), "A(2)");
}

TEST(Cut, RemovesTheRestOfTheBranch)
{
    EXPECT_EQ(derived("Axiom: A[B%C[D]E]F"), "A[B]F");
    EXPECT_EQ(derived("Axiom: A%B"), "A");
    EXPECT_EQ(derived("Axiom: A\nA --> B%C"), "B%C");
}

TEST(Decomposition, RewritesUntilNoRuleMatches)
{
    EXPECT_EQ(derived("Axiom: A(5)\ndecomposition\nmaximum depth: 10\nA(n) : n>0 --> BA(n-1)"),
              "BBBBBA(0)");
    EXPECT_EQ(derived("Axiom: A(5)\ndecomposition\nmaximum depth: 2\nA(n) : n>0 --> BA(n-1)"),
              "BBA(3)");
    EXPECT_EQ(derived("Axiom: X\nX --> A(2)\ndecomposition\nA(n) --> B(n)C"), "B(2)C");
}

TEST(Homomorphism, ChangesWhatIsDrawnOnly)
{
    auto const model = compiled(
        with_header("Axiom: A(2)\nhomomorphism\nmaximum depth: 2\nA(n) --> ;B(n)\nB(n) --> F(n)F"));
    auto const string = derive(model);
    ASSERT_TRUE(string);
    EXPECT_EQ(to_string(model, *string), "A(2)");
    auto const drawn_string = apply_homomorphism(model, *string);
    ASSERT_TRUE(drawn_string);
    EXPECT_EQ(to_string(model, *drawn_string), ";F(2)F");
}

TEST(Stochastic, HasTheGivenFrequencies)
{
    std::string axiom = "Axiom: ";
    for (int i = 0; i < 10'000; ++i)
        axiom += 'A';
    auto const string = derived(axiom + "\nA --> B : 1\nA --> C : 2\nA --> D : 1");
    // The standard deviations of these counts are 43 and 50.
    EXPECT_NEAR(static_cast<double>(std::count(string.begin(), string.end(), 'B')), 2500, 200);
    EXPECT_NEAR(static_cast<double>(std::count(string.begin(), string.end(), 'C')), 5000, 220);
    EXPECT_NEAR(static_cast<double>(std::count(string.begin(), string.end(), 'D')), 2500, 200);
}

TEST(Stochastic, DependsOnTheSeedAlone)
{
    auto const rules = "Axiom: AAAAAAAAAAAAAAAA\nA --> AB : 0.5\nA --> BA : 0.5";
    EXPECT_EQ(derived(rules, 4, 7), derived(rules, 4, 7));
    EXPECT_NE(derived(rules, 4, 7), derived(rules, 4, 8));
    EXPECT_NE(derived(std::string("seed: 1\n") + rules, 4, 7),
              derived(std::string("seed: 2\n") + rules, 4, 7));
}

TEST(Stochastic, DrawsTheDistributionsOfTheLanguage)
{
    auto const model = compiled(
        with_header("Axiom: A(20000)\ndecomposition\nmaximum depth: 30000\n"
                    "A(n) : n>0 --> B(ran(2),nran(3,2),bran(5,16),biran(10,0.3))A(n-1)"));
    auto const string = derive(model);
    ASSERT_TRUE(string) << string.error().message;
    ASSERT_EQ(string->size(), 20001u);
    std::array<double, 4> sum {};
    for (std::size_t i = 0; i < 80000; ++i)
        sum[i % 4] += static_cast<double>(string->parameters[i]);
    EXPECT_NEAR(sum[0] / 20000, 1, 0.03);
    EXPECT_NEAR(sum[1] / 20000, 3, 0.08);
    EXPECT_NEAR(sum[2] / 20000, 5.0 / 21, 0.01);
    EXPECT_NEAR(sum[3] / 20000, 3, 0.08);
}

TEST(Limits, StopARunawayModel)
{
    auto const model = compiled(with_header("Axiom: A\nA --> AA", 1'000'000));
    auto const string
        = derive(model, { .steps = {}, .seed = 1, .limits = { .max_modules = 1000 } });
    ASSERT_FALSE(string);
    EXPECT_EQ(string.error().fault, Fault::User);
    EXPECT_EQ(string.error().message,
              "model.l: step 10 makes more than 1000 modules; derive fewer steps or raise the "
              "limit of modules");
}

TEST(Parameters, AreSingleFloats)
{
    EXPECT_EQ(derived("Axiom: A(16777217)\nA(x) : x==16777216 --> B(0.1*10)"), "B(1)");
}

TEST(Counts, JoinTheTurtlesLongSymbols)
{
    auto const model = compiled(with_header("Axiom: @Ts(1,2)@o(3)o~l(2)?P(0,0,0)FFF(2)", 0));
    auto const counts = count_symbols(model, *derive(model));
    std::map<std::string, std::size_t> const expected { { "@Ts", 1 }, { "@o", 1 }, { "o", 1 },
                                                        { "~l", 1 },  { "?P", 1 }, { "F", 3 } };
    EXPECT_EQ(counts, expected);
}

} // namespace
} // namespace tractus::lsystem
