#include "engine/lsystem/rewriting/homomorphism.h"
#include "tests/engine/lsystem/small_model.h"

#include <gtest/gtest.h>
#include <string>
#include <tbb/global_control.h>
#include <vector>

namespace tractus::lsystem {
namespace {

// Derives a model with and without the context table, and expects equal results. An additional rule
// with a parameter, which never applies, prevents the use of the table.
std::string derived_both_ways(std::string const& model, int steps = 1)
{
    auto const fast = derived(model, steps);
    EXPECT_EQ(derived(model + "\nZ(x) --> Z(x)", steps), fast);
    return fast;
}

TEST(RightContext, LooksThroughBranchesWhereBracketsAreIgnored)
{
    std::string const rules = "\nAxiom: A[+B]Q\nA > Q --> X\nB > Q --> Y";
    EXPECT_EQ(derived_both_ways("consider: QA" + rules), "X[+Y]Q");
    EXPECT_EQ(derived_both_ways("ignore: []+B" + rules), "X[+Y]Q");
    EXPECT_EQ(derived_both_ways("ignore: +" + rules), "X[+B]Q");
}

TEST(RightContext, EntersBranchesWhereBracketsAreIgnored)
{
    std::string const rules = "\nAxiom: A[+B]Q[C]D\nA > B --> X\nQ > C --> Y";
    EXPECT_EQ(derived_both_ways("ignore: +[]" + rules), "X[+B]Y[C]D");
    EXPECT_EQ(derived_both_ways("ignore: +" + rules), "A[+B]Q[C]D");
}

TEST(RightContext, IgnoresOneBracketAlone)
{
    std::string const rules = "\nAxiom: A[B]Q\nA > B --> X\nA > Q --> W\nB > Q --> Y";
    EXPECT_EQ(derived_both_ways("ignore: ]" + rules), "W[Y]Q");
    EXPECT_EQ(derived_both_ways("ignore: [" + rules), "X[B]Q");
}

TEST(LeftContext, ClimbsOutOfBranchesWhateverIsIgnored)
{
    std::string const rules = "\nAxiom: A[C]+[B]Q\nA < B --> X\nA < Q --> Y\nC < Q --> Z";
    EXPECT_EQ(derived_both_ways("consider: ABCQ" + rules), "A[C]+[X]Y");
    EXPECT_EQ(derived_both_ways("ignore: +[]" + rules), "A[C]+[X]Y");
    EXPECT_EQ(derived_both_ways("ignore: +" + rules), "A[C]+[X]Y");
}

TEST(LocalVariables, KeepTheirLastValue)
{
    EXPECT_EQ(derived("Axiom: A(7)A(0)A(0)\nA(x) : {if (x > 0) {y = x;}} 1 --> B(y)"),
              "B(7)B(7)B(7)");
    EXPECT_EQ(derived("Axiom: AAA\nA : 1 {n = n + 1;} --> B(n)"), "B(1)B(2)B(3)");
    // Variables keep their values from step to step. Values that a rule has set are kept even if
    // its condition then fails.
    EXPECT_EQ(derived("Axiom: A\nA : 1 {n = n + 1;} --> B(n)A", 3), "B(1)B(2)B(3)A");
    EXPECT_EQ(derived("Axiom: A(3)A(1)\nA(x) : {y = y + x;} y > 3 --> B(y)\nA(x) --> C(x)"),
              "C(3)B(4)");
}

TEST(LocalVariables, BelongToOneRule)
{
    EXPECT_EQ(derived("Axiom: A(1)C(2)A(0)\nA(x) : {if (x > 0) {y = x;}} 1 --> B(y)\n"
                      "C(x) : {y = 5;} 1 --> D(y)"),
              "B(1)D(5)B(1)");
}

TEST(LocalVariables, KeepTheirValuesInHomomorphismAndDecomposition)
{
    auto const model
        = compiled(with_header("Axiom: AAA\nhomomorphism\nA : 1 {n = n + 1;} --> F(n)", 0));
    auto const string = derive(model);
    ASSERT_TRUE(string);
    auto const drawn = apply_homomorphism(model, *string);
    ASSERT_TRUE(drawn);
    EXPECT_EQ(to_string(model, *drawn), "F(1)F(2)F(3)");
    EXPECT_EQ(derived("Axiom: SS\nS --> A\ndecomposition\nA : 1 {n = n + 1;} --> F(n)"),
              "F(1)F(2)");
}

TEST(LocalVariables, GiveTheSameStringOnAnyNumberOfThreads)
{
    std::string const model = "Axiom: A(1)\nA(x) : {if (x > 3) {y = x;}} 1 --> A(x+1)A(y)A(1)";
    std::string one;
    {
        tbb::global_control const single(tbb::global_control::max_allowed_parallelism, 1);
        one = derived(model, 11);
    }
    EXPECT_EQ(derived(model, 11), one);
    EXPECT_GT(one.size(), 500'000u);
}

TEST(LocalVariables, AreWarnedOfWhereTheyAreUsedBeforeTheyAreSet)
{
    auto const warnings = [](std::string const& rule) {
        return compiled(with_header("Axiom: A(1)\n" + rule)).warnings;
    };
    auto const kept = warnings("A(x) : {if (x > 0) {y = x;}} 1 --> B(y)");
    ASSERT_EQ(kept.size(), 1u);
    EXPECT_EQ(kept[0],
              "model.l:4:38: y is used before it is set; it then has the value that this "
              "rule gave it last, or 0");
    EXPECT_EQ(warnings("A(x) --> B(y)"),
              std::vector<std::string> { "model.l:4:12: y is not defined; its value is 0" });
    EXPECT_TRUE(warnings("A(x) : {y = x;} y > 0 --> B(y)").empty());
    EXPECT_TRUE(warnings("A(x) : {if (x > 0) {y = x;} else {y = 1;}} 1 --> B(y)").empty());
    EXPECT_TRUE(
        warnings("A(x) : {i = 0; do {i = i + 1; z = i;} while (i < 3);} 1 --> B(z)").empty());
    EXPECT_EQ(warnings("A(x) : {i = 0; while (i < x) {i = i + 1; z = i;}} 1 --> B(z)").size(), 1u);
}

} // namespace
} // namespace tractus::lsystem
