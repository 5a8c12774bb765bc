#include "engine/methods/leaves/leaf.h"
#include "engine/methods/leaves/leaf_grammar.h"

#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <variant>

namespace tractus::leaf {
namespace {

std::string const kFaces = "#define A(4,1,0,0,0,1,1)\n"
                           "#define P(5,1,0,0,0,1,1)\n"
                           "#define T(3,1,0,0,0,1,1)\n"
                           "#axiom : A\n";

std::string error_of(std::string const& text)
{
    auto const grammar = parse_grammar(text, "my.leaf");
    return grammar ? "understood" : grammar.error().message;
}

// Returns the value of a name that `definitions` define; NaN if they do not define it.
double defined(std::string const& definitions, std::string_view name)
{
    auto grammar = parse_grammar(kFaces + definitions, "my.leaf");
    EXPECT_TRUE(grammar.has_value()) << (grammar ? "" : grammar.error().message);
    if (!grammar)
        return std::nan("");
    auto const found = grammar->variables.find(grammar->names.number_of(name));
    return found == grammar->variables.end() ? std::nan("") : found->second;
}

TEST(ParseLeafGrammar, ExpressionsAreThoseOfC)
{
    EXPECT_EQ(defined("#define k = 2 * 3\n", "k"), 6);
    EXPECT_EQ(defined("#define k = 6\n#define h = (k > 5 && !0 ? .5 : max(1, 2)) @half@\n", "h"),
              0.5);
    EXPECT_EQ(defined("#define k = 7 % 4 - 2 ^ 3 / -4", "k"), 5);
    EXPECT_EQ(defined("#define k = 2 ^ 3 ^ 2", "k"), 512);
    EXPECT_EQ(defined("#define k = 10 - 4 - 3", "k"), 3);
    EXPECT_EQ(defined("#define k = 1e2 + 1.5E-1", "k"), 100.15);
    EXPECT_EQ(defined("#define k = 1 < 2 == 1 || 1 / 0", "k"), 1);
    EXPECT_EQ(defined("#define k = 0 && 1 / 0", "k"), 0);
    EXPECT_EQ(defined("#define k = 1 ? 2 : 0 ? 3 : 4", "k"), 2);
    EXPECT_NEAR(defined("#define k = sin(30) + cos(60) + atan(1)", "k"), 46, 1e-12);
    EXPECT_EQ(defined("#define k = floor(-1.5) + ceil(1.2) + pow(2, 3) + min(4, 5)", "k"), 12);
}

TEST(ParseLeafGrammar, ALineEndsADefinitionHoweverItEnds)
{
    EXPECT_EQ(defined("#define k = 2 * 3\r\n#define h = 1\r\n", "k"), 6);
    EXPECT_EQ(defined("#define k = 2", "k"), 2);
    EXPECT_EQ(defined("#define k = 2 @and a remark@\n#define h = k + 1\n", "h"), 3);
    EXPECT_EQ(defined("@#define k = 1\n@#define k = 2\n", "k"), 2);
}

TEST(ParseLeafGrammar, RulesMaySpanLinesAndHaveAnyOfTheArrows)
{
    for (auto const* const arrow : { "→", "->", "-->", "\r\n →\r\n" }) {
        auto const grammar
            = parse_grammar(kFaces + "r A {k = 1;} {} { } " + arrow + " A[T]E", "my.leaf");
        ASSERT_TRUE(grammar.has_value()) << arrow << grammar.error().message;
        ASSERT_EQ(grammar->rules.size(), 1U);
        EXPECT_EQ(grammar->rules[0].always.size(), 1U);
        EXPECT_TRUE(grammar->rules[0].condition.empty());
    }
}

TEST(ParseLeafGrammar, RulesOfEachKindAreTold)
{
    auto const grammar = parse_grammar(
        kFaces + "g A -> A[P[T]C1]E[T]C1\ns A -> C1AA\nz A : A_C2 < P_C1 -> A_C2|P_C1", "my.leaf");
    ASSERT_TRUE(grammar.has_value()) << grammar.error().message;
    ASSERT_EQ(grammar->rules.size(), 3U);
    auto const& growing = std::get<Growing>(grammar->rules[0].kind);
    ASSERT_EQ(growing.children.size(), 2U);
    EXPECT_EQ(growing.children[0].children.size(), 1U);
    EXPECT_EQ(growing.children[1].edge, side_label(1));
    EXPECT_EQ(std::get<Splitting>(grammar->rules[1].kind).edge, side_label(1));
    EXPECT_EQ(std::get<Gluing>(grammar->rules[2].kind).second.face, 'P');
}

TEST(ParseLeafGrammar, OptionsAreRead)
{
    auto const grammar = parse_grammar(
        "#base\n#bare : A, P @stalks@\n#margin : teeth(3, .2, max(0, .5))\n" + kFaces, "my.leaf");
    ASSERT_TRUE(grammar.has_value()) << grammar.error().message;
    EXPECT_TRUE(grammar->has_base);
    EXPECT_EQ(grammar->bare, (std::set { 'A', 'P' }));
}

TEST(ParseLeafGrammar, WhatIsWrongIsSaidWithItsPlace)
{
    struct Case {
        char const* text; // Text that follows kFaces, from line 5 on.
        char const* message;
    };
    for (auto const& [text, message] : {
             Case { "r A -> A[T]C3", "my.leaf:5:12: a face A has 4 edges and no C3" },
             Case { "r T -> OAA", "my.leaf:5:8: a face T of 3 edges cannot be split along O" },
             Case { "r P -> C1AA", "my.leaf:5:8: a face P of 5 edges cannot be split along C1" },
             Case { "r A {a = 1\nb = 2} {} {} -> A[T]E", "my.leaf:6:1: " },
             Case { "r A {} {} -> A[T]E", "my.leaf:5:11: a rule has three blocks or none" },
             Case { "#define X(2,1,0,0,0,1,1)", "my.leaf:5:9: a face has 3 to 9999 edges" },
             Case { "r A -> A[X]E", "my.leaf:5:10: no face X is defined" },
             Case { "r A -> A[T(,,,,,,,1)]E", "my.leaf:5:19: a face has no more than 7 fields" },
             Case { "r A -> A[T(,,,,,1 +)]E", "my.leaf:5:20: " },
             Case { "r A -> OAX", "my.leaf:5:8: no face X is defined" },
             Case { "#bare : X", "my.leaf:5:9: no face X is defined" },
             Case { "#colour : red", "my.leaf:5:2: #colour is none of" },
             Case { "r P -> A[T]E", "my.leaf:5:8: a growing rule goes on with its own face P" },
             Case { "r A {} {unknown > 1} {} -> A[T]E", "my.leaf:5:1: rule r reads unknown" },
             Case { "#define k = later\n#define later = 1", "my.leaf:5:13: " },
             Case { "#define k = 1 2", "my.leaf:5:15: " },
             Case { "@ never ended", "my.leaf:5:1: " },
             Case { "r A -> A[T]E $", "my.leaf:5:14: " },
             Case { "#margin : zigzag(1,2)", "my.leaf:5:11: \"zigzag\" is none of" },
         })
        EXPECT_EQ(error_of(kFaces + text).substr(0, std::string(message).size()), message) << text;
    EXPECT_EQ(error_of("#define A(4,1,0,0,0,1,1)\n").substr(0, 14), "my.leaf:2:1: t");
    EXPECT_EQ(error_of("").substr(0, 26), "my.leaf:1:1: there is no a");
}

// The text is truncated at every position, and each of its letters is changed. No such text may
// cause a hang or a crash, nor may an error be accepted.
TEST(ParseLeafGrammar, AnyTextIsSafe)
{
    std::string const text = kFaces
        + "#base\nr A(n,,x) {k = n; h = k * .5;} {step == 1} {} -> A[P(,,<max(n, (h + 1)) * 1>)]E\n"
          "s A {} {} {} → OAP\nz A : A_C2 < P_C1 -> A_C2|P_C1\n";
    ASSERT_EQ(error_of(text), "understood");
    for (std::size_t i = 0; i < text.size(); ++i) {
        auto const cut = parse_grammar(text.substr(0, i), "cut");
        for (char const letter : { '\0', '(', '[', '{', '@', '<', '9', 'A', '-', '\xff' }) {
            auto changed = text;
            changed[i] = letter;
            auto const grammar = parse_grammar(changed, "changed");
            if (!grammar)
                continue;
            auto leaf = Leaf::begin(*grammar, {});
            if (leaf && leaf->derive()) {
                EXPECT_EQ(leaf->map().fault(), "") << changed;
            }
        }
    }
    EXPECT_NE(error_of(kFaces + "#define k = " + std::string(100'000, '(')), "understood");
    EXPECT_NE(error_of(kFaces + "#define k = " + std::string(100'000, '-') + "1"), "");
    std::string nested = "r A -> A";
    for (int i = 0; i < 100'000; ++i)
        nested += "[A";
    EXPECT_NE(error_of(kFaces + nested), "understood");
}

} // namespace
} // namespace tractus::leaf
