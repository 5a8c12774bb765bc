#include "engine/lsystem/text/source_text.h"
#include "tests/engine/lsystem/small_model.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <string>

namespace tractus::lsystem {
namespace {

// Returns the preprocessed text, without blanks and empty lines.
std::string preprocessed(std::string const& text)
{
    auto const source = preprocess("model.l", text, {});
    if (!source)
        return source.error().message;
    std::string result;
    for (char const c : source->text)
        if (c != ' ' && c != '\n' && c != '\t')
            result += c;
    return result;
}

bool is_on(std::string const& expression, std::string const& before = {})
{
    auto const result = preprocessed(before + "#if " + expression + "\nyes\n#else\nno\n#endif\n");
    EXPECT_TRUE(result == "yes" || result == "no") << result;
    return result == "yes";
}

TEST(Preprocessor, WarnsWhereACommentCutsAProduction)
{
    // The text is figure 1.25 of The Algorithmic Beauty of Plants, as printed.
    auto const bush = preprocess("bush.l",
                                 "Axiom: A\nA --> [&FL!A]/////'[&FL!A]///////'[&FL!A]\n"
                                 "F --> S/////F\nS --> FL\n",
                                 {});
    ASSERT_TRUE(bush);
    ASSERT_EQ(bush->warnings.size(), 2U);
    EXPECT_EQ(bush->warnings[0].substr(0, 12), "bush.l:2:14:");
    EXPECT_EQ(bush->warnings[1].substr(0, 11), "bush.l:3:8:");
    for (auto const* comment :
         { "A --> B // grows", "A --> B//grows", "A --> B ////////", "A --> B / / C",
           "// A --> B//C", "/* A --> B//[C] */", "/*\nA --> B//[C]\n*/", "x//[C]" }) {
        auto const text = preprocess("model.l", comment, {});
        ASSERT_TRUE(text) << comment;
        EXPECT_TRUE(text->warnings.empty()) << comment << ": " << text->warnings.front();
    }
}

TEST(Preprocessor, ComputesConditionsAsC)
{
    for (auto const* expression : { "1",
                                    "2 - 1",
                                    "-1 < 0",
                                    "1 + 2 * 3 == 7",
                                    "(1 + 2) * 3 == 9",
                                    "7 / 2 == 3",
                                    "7 % 4 == 3",
                                    "1 << 4 == 16",
                                    "0x10 == 020",
                                    "!0 && ~0 == -1",
                                    "0 || 1",
                                    "1 ? 2 : 0",
                                    "0 ? 0 : 3",
                                    "5 & 4 && 5 | 2 && 5 ^ 4",
                                    "10 - 4 - 3 == 3",
                                    "1 ? 2 : 0 ? 0 : 0",
                                    "3UL > 2u",
                                    "!name",
                                    "1 || 1 / 0",
                                    "!(0 && 1 % 0)",
                                    "8 >> 2 == 2",
                                    "- - 1",
                                    "-8 / -1 == 8" })
        EXPECT_TRUE(is_on(expression)) << expression;
    for (auto const* expression : { "0", "name", "1 == 2", "1 > 2", "2 != 2", "!5", "00" })
        EXPECT_FALSE(is_on(expression)) << expression;
}

TEST(Preprocessor, AsksWhetherNamesAreDefined)
{
    EXPECT_TRUE(is_on("defined X", "#define X 0\n"));
    EXPECT_TRUE(is_on("defined(X) && !defined ( Y )", "#define X\n"));
    EXPECT_FALSE(is_on("defined X", "#define X\n#undef X\n"));
    EXPECT_TRUE(is_on("X == 4 && twice(X) > 7",
                      "#define X (Y+1)\n#define Y 3\n"
                      "#define twice(a) (2 * (a))\n"));
    EXPECT_EQ(preprocessed("#ifndef X\na\n#else\nb\n#endif"), "a");
}

TEST(Preprocessor, TakesTheFirstPartWhoseConditionHolds)
{
    auto const parts = [](int which) {
        return preprocessed("#define X " + std::to_string(which)
                            + "\n#if X == 1\none\n#elif X == 2\ntwo\n#elif X < 4\nthree\n#else\n"
                              "more\n#endif\nend");
    };
    EXPECT_EQ(parts(1), "oneend");
    EXPECT_EQ(parts(2), "twoend");
    EXPECT_EQ(parts(3), "threeend");
    EXPECT_EQ(parts(4), "moreend");
}

TEST(Preprocessor, ComputesNothingInWhatItLeavesOut)
{
    EXPECT_EQ(
        preprocessed("#if 0\n#if 1 / 0 nonsense\n#elif )\n#else\na\n#endif\n#else\nb\n#endif"),
        "b");
    EXPECT_EQ(preprocessed("#if 1\na\n#elif 1 / 0\nb\n#endif"), "a");
}

TEST(Preprocessor, SaysWhereAConditionIsWrong)
{
    EXPECT_EQ(preprocessed("\n#if 1 +\n#endif"),
              "model.l:2:8: found the end of the line in #if, expected a number or a name");
    EXPECT_EQ(preprocessed("#if 1.5\n#endif"),
              "model.l:1:5: found '1.5' in #if, expected an integer");
    EXPECT_EQ(preprocessed("#if 4 / (2 - 2)\n#endif"), "model.l:1:7: #if divides by zero");
    EXPECT_EQ(preprocessed("#if (1\n#endif"),
              "model.l:1:7: an opening parenthesis in #if is not "
              "closed");
    EXPECT_EQ(preprocessed("#if 1 2\n#endif"),
              "model.l:1:7: found '2' in #if, expected an operator "
              "or the end of the line");
    EXPECT_EQ(preprocessed("#if defined 3\n#endif"),
              "model.l:1:5: found 'defined', expected a name or (NAME) behind it");
    EXPECT_EQ(preprocessed("a\n  #if 1\nb"), "model.l:2:3: this #if has no #endif");
    EXPECT_EQ(preprocessed("#if 1\n#else\n#elif 1\n#endif"),
              "model.l:3:1: found #elif behind the #else of the #if at line 1");
    EXPECT_EQ(preprocessed("#elif 1\n"), "model.l:1:1: found #elif without #if");
    EXPECT_NE(preprocessed("#if " + std::string(100'000, '(') + "\n").find("nested deeper"),
              std::string::npos);
    EXPECT_EQ(preprocessed("#error too old\n"), "model.l:1:1: #error too old");
}

// A conditional part must begin and end in the same file, as in C.
TEST(Preprocessor, ConditionsEndInTheirFile)
{
    for (auto const* const directive : { "#endif", "#else", "#elif 1" }) {
        auto const include
            = [&](std::string const&) -> Result<std::string> { return std::string(directive); };
        auto const source = preprocess("model.l", "#if 1\n#include \"part.l\"\nA\n", include);
        ASSERT_FALSE(source) << directive;
        EXPECT_NE(source.error().message.find("part.l:1:1: found #"), std::string::npos)
            << source.error().message;
        EXPECT_NE(source.error().message.find("without #if"), std::string::npos);
    }
    auto const whole = [](std::string const&) -> Result<std::string> { return "#if 0\n#endif\nB"; };
    EXPECT_TRUE(preprocess("model.l", "#if 1\n#include \"part.l\"\n#endif\n", whole));
}

TEST(Preprocessor, JoinsTokens)
{
    EXPECT_EQ(preprocessed("#define organ(n) leaf ## n\norgan(3)"), "leaf3");
    EXPECT_EQ(preprocessed("#define join(a, b) a##b\n#define AB it\njoin(A, B)"), "it");
    EXPECT_EQ(preprocessed("#define join(a, b) a##b\njoin(, B) join(A,) join(,)x"), "BAx");
    EXPECT_EQ(preprocessed("#define X 1\n#define join(a) a ## X\n#define glue(a) join(a)\njoin(X) "
                           "glue(X)"),
              "XX1X");
    EXPECT_EQ(preprocessed("#define AB A ## B\nAB"), "AB");
    EXPECT_EQ(preprocessed("A --> ##F"), "A-->##F"); // ## stands for two turtle symbols.
    EXPECT_NE(preprocessed("#define W ##F\n").find("write # #"), std::string::npos);
    EXPECT_EQ(derived("#define organ(n) N ## n\n#define N1 F(2)\nAxiom: organ(1)", 0), "F(2)");
}

TEST(Preprocessor, MakesStrings)
{
    EXPECT_EQ(preprocessed("#define label(n) @L(#n)\nlabel( a  \"b\" )"), "@L(\"a\\\"b\\\"\")");
    EXPECT_EQ(preprocessed("#define wide(w) #(w)F\nwide(3)"), "#(3)F");
    EXPECT_EQ(preprocessed("#define wide #(3)\nwide"), "#(3)");
}

// The examples are 3 and 7 of the C standard (C11, 6.10.3.5).
TEST(Preprocessor, ReadsResultsAgain)
{
    EXPECT_EQ(
        preprocessed("#define x 3\n#define f(a) f(x * (a))\n#undef x\n#define x 2\n"
                     "#define g f\n#define z z[0]\n#define h g(~\n#define m(a) a(w)\n"
                     "#define w 0,1\n#define t(a) a\n"
                     "f(y+1) + f(f(z)) % t(t(g)(0) + t)(1);\ng(x+(3,4)-w) | h 5) & m\n(f)^m(m);"),
        "f(2*(y+1))+f(2*(f(2*(z[0]))))%f(2*(0))+t(1);"
        "f(2*(2+(3,4)-0,1))|f(2*(~5))&f(2*(0,1))^m(0,1);");
    EXPECT_EQ(preprocessed("#define all(...) A(__VA_ARGS__)\n#define rest(a, ...) a[__VA_ARGS__]\n"
                           "all(1,2) rest(F, G, H) rest(F)"),
              "A(1,2)F[G,H]F[]");
    EXPECT_EQ(preprocessed("#define a b\n#define b a\na b"), "ab");
}

TEST(Preprocessor, ReadsCallsThatGoOnInTheNextLine)
{
    EXPECT_EQ(preprocessed("#define add(a,b) (a+b)\nA(add(1,\n  2)) B\nC"), "A((1+2))BC");
    EXPECT_EQ(preprocessed("#define add(a,b) (a+b)\nadd(1,\n#define X\n2)"),
              "model.l:2:4: the call of macro add has no closing parenthesis");
}

TEST(Preprocessor, ReadsCallsWhoseNamesComeOutOfMacros)
{
    EXPECT_EQ(preprocessed("#define f(x) <x>\n#define F f\nA F\n(1) f\nB"), "A<1>fB");
    EXPECT_EQ(preprocessed("#define f(x) <x>\n#define open f (\n#define F f\nF (1,\n"),
              "model.l:4:3: the call of macro f has no closing parenthesis");
}

TEST(Preprocessor, KnowsWhereItIs)
{
    EXPECT_EQ(preprocessed("\n__LINE__ __FILE__\n#if __LINE__ == 3 && defined __FILE__\na\n#endif"),
              "2\"model.l\"a");
    EXPECT_EQ(preprocessed("#define here(a) a __LINE__ #a\n\nhere(\n__LINE__)"), "43\"__LINE__\"");
}

TEST(Preprocessor, LeavesTheCommaOutWithTheArgumentsBehindIt)
{
    EXPECT_EQ(preprocessed("#define F(a, ...) F(a, ## __VA_ARGS__)\nF(1) F(1,2,3) F(1,)"),
              "F(1)F(1,2,3)F(1,)");
}

TEST(Preprocessor, KeepsTokensApart)
{
    auto const text = [](std::string const& source) {
        auto const result = preprocess("model.l", source, {});
        return result ? result->text : result.error().message;
    };
    EXPECT_EQ(text("#define id(a) a\nid(x)y id(2)x 2id(x) id(F)(1)\n"), "\nx y 2 x 2id(x) F(1)\n");
    // According to the C standard, 1e-X is a single number, so X in it is not replaced.
    EXPECT_EQ(text("#define X 3\n1e-X 1-X\n"), "\n1e-X 1-3\n");
}

TEST(Preprocessor, PassesWarningsOn)
{
    auto const source
        = preprocess("model.l", "a\n #warning soon gone\n#pragma once\n#line 7\n", {});
    ASSERT_TRUE(source) << source.error().message;
    ASSERT_EQ(source->warnings.size(), 1u);
    EXPECT_EQ(source->warnings[0], "model.l:2:2: #warning soon gone");
}

TEST(Preprocessor, GoesOnBehindABackslashAsC)
{
    EXPECT_EQ(preprocessed("#define pair F\\\nG\npair"), "FG");
    EXPECT_EQ(preprocessed("#if 0 || \\\n 1\na\n#endif"), "a");
}

TEST(Preprocessor, WarnsOfADefinitionThatSwallowsAStatement)
{
    auto const swallowing = preprocess("model.l", "\n#define TURN \\\\\nAxiom: TURN F\n", {});
    ASSERT_TRUE(swallowing);
    ASSERT_EQ(swallowing->warnings.size(), 1u);
    EXPECT_EQ(
        swallowing->warnings[0],
        "model.l:2:1: the \\ at the end of this definition joins the next line to it ('Axiom: "
        "TURN F'); for the turtle symbol, write another one behind it, such as \\(a)");
    auto const fine = preprocess("model.l", "#define LONG F\\\n  G\nLONG\n", {});
    ASSERT_TRUE(fine);
    EXPECT_TRUE(fine->warnings.empty());
}

TEST(Preprocessor, SaysWhatLineSays)
{
    EXPECT_EQ(preprocessed("#line 40 \"made.l\"\na\n#error no\n"), "made.l:41:1: #error no");
    EXPECT_EQ(preprocessed("# 40 \"made.l\" 1\n\n#error no\n"), "made.l:41:1: #error no");
    EXPECT_EQ(preprocessed("#line x\n"),
              "model.l:1:1: found #line x, expected a line's number, and perhaps \"FILE\"");
    EXPECT_NE(preprocessed("#line 40 made.l\n").find("found #line 40 made.l"), std::string::npos);
    EXPECT_NE(preprocessed("#line 4000000000\n").find("found #line"), std::string::npos);
    EXPECT_EQ(preprocessed("# 40 A\n#40F\n"), "#40A#40F"); // Here # is a symbol of the turtle.
    std::string many;
    for (int i = 0; i < 2000; ++i)
        many += "#line 1 \"" + std::to_string(i) + "\"\n";
    EXPECT_NE(preprocessed(many).find("more than 1000"), std::string::npos);
}

// At the end of an included file, line numbers are again those of the file that includes it.
TEST(Preprocessor, ForgetsAtTheEndOfAFileWhatLineSaid)
{
    auto const include
        = [](std::string const&) -> Result<std::string> { return "#line 70 \"x.l\"\n__LINE__\n"; };
    auto const source
        = preprocess("model.l", "#line 10\n#include \"a.l\"\n__LINE__ __FILE__\n", include);
    ASSERT_TRUE(source) << source.error().message;
    EXPECT_EQ(source->text, "\n\n70\n\n11 \"model.l\"\n");
}

TEST(Preprocessor, IncludesOnceWhereAPragmaSaysSo)
{
    auto const include = [](std::string const& name) -> Result<std::string> {
        return name == "once.l" ? "#pragma once\nA\n" : "B\n#if 0\n#pragma once\n#endif\n";
    };
    auto const source = preprocess("model.l",
                                   "#define PART \"once.l\"\n#include \"once.l\"\n#include PART\n"
                                   "#include \"b.l\"\n#include <b.l>\n",
                                   include);
    ASSERT_TRUE(source) << source.error().message;
    EXPECT_EQ(std::count(source->text.begin(), source->text.end(), 'A'), 1);
    EXPECT_EQ(std::count(source->text.begin(), source->text.end(), 'B'), 2);
}

TEST(Preprocessor, LeavesStringsAlone)
{
    EXPECT_EQ(preprocessed("#define b 1\n\"a//b\" \"/*b\\\"*/\" b//c"), "\"a//b\"\"/*b\\\"*/\"1");
    EXPECT_EQ(preprocessed("A \" B // c\nD"), "A\"BD"); // A single quote does not begin a string.
    EXPECT_EQ(derived("Start: { printf(\"// %g /* \", 1); }\nAxiom: A // b", 0), "A");
    std::string quotes; // A text of many escaped quotes, none of which ends a string.
    for (int i = 0; i < 100'000; ++i)
        quotes += "\\\"";
    EXPECT_EQ(preprocessed(quotes), quotes);
}

TEST(Preprocessor, SaysWhereAnOpenCommentBegan)
{
    EXPECT_EQ(preprocessed("a\n  b /* c\nd\n"),
              "model.l:2:5: the comment that begins here has no */");
    EXPECT_EQ(preprocessed("/*/"), "model.l:1:1: the comment that begins here has no */");
}

TEST(Preprocessor, NamesTheDirectiveThatWasMeant)
{
    EXPECT_EQ(preprocessed("#defin X 3\n"),
              "model.l:1:1: found '#defin X 3', expected '#define', perhaps");
    EXPECT_EQ(preprocessed("a\n  # iff X\n#endif\n"),
              "model.l:2:3: found '# iff X', expected '#if', perhaps");
    EXPECT_EQ(preprocessed("#if 1\n#esle\n#endif\n"),
              "model.l:2:1: found '#esle', expected '#else', perhaps");
    EXPECT_EQ(preprocessed("#if 0\n#defin X 3\n#iff\n#endif\n"), "");
    // In these lines, # is a symbol of the turtle.
    for (std::string const line : { "#F", "#FFF", "#(2)F", "#fF(3)", "#iffF", "#fi", "#els(3)" })
        EXPECT_EQ(preprocessed(line), line);
}

TEST(Preprocessor, BoundsWhatHostileMacrosCost)
{
    std::string deep = "#define f(a) a a\n";
    for (int i = 0; i < 10'000; ++i)
        deep += "f(";
    EXPECT_NE(preprocessed(deep + "x" + std::string(10'000, ')')).find("nested deeper"),
              std::string::npos);
    std::string chain = "#define A0 x\n";
    for (int i = 1; i <= 300; ++i)
        chain += "#define A" + std::to_string(i) + " A" + std::to_string(i - 1) + "\n";
    EXPECT_NE(preprocessed(chain + "A300\n").find("nested deeper"), std::string::npos);
    EXPECT_EQ(preprocessed(chain + "A150\n"), "x");
    // Macros that double their number of calls without producing text.
    std::string empty = "#define A0\n";
    for (int i = 1; i < 60; ++i)
        empty += "#define A" + std::to_string(i) + " A" + std::to_string(i - 1) + " A"
            + std::to_string(i - 1) + "\n";
    EXPECT_NE(preprocessed(empty + "A59\n").find("16 MB"), std::string::npos);
}

} // namespace
} // namespace tractus::lsystem
