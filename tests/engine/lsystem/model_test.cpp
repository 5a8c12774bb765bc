#include "engine/lsystem/model.h"

#include "tests/engine/lsystem/small_model.h"

#include <gtest/gtest.h>

namespace tractus {
namespace {

TEST(ModelErrors, NameTheLineAndColumn)
{
    EXPECT_EQ(compile_error("Lsystem: 1\nAxiom: A\nA -> B\n"),
              "model.l:3:7: found the end of the line, expected '-->'");
    EXPECT_EQ(compile_error("Axiom: A\n"), "model.l:1:1: found 'A', expected 'Lsystem:'");
    EXPECT_EQ(compile_error("Lsystem: 1\nAxiom: A(1\n"),
              "model.l:2:11: found the end of the line, expected ',' or ')'");
    EXPECT_EQ(compile_error("Lsystem: 1\nAxiom: A\nA(x) : x>>1 --> B\n"),
              "model.l:3:10: found '>', expected a number, a name or '('");
    EXPECT_EQ(compile_error("Lsystem: 1\nAxiom: A\nA(1) --> B\n"),
              "model.l:3:3: found '1', expected the name of a parameter");
    EXPECT_EQ(compile_error("Lsystem: 1\nAxiom: A\nA(x) --> B(foo(x))\n"),
              "model.l:3:12: found the function foo, expected one of cpfg's");
    EXPECT_EQ(compile_error(""), "model.l:1:1: found the end of the file, expected 'Lsystem:'");
}

TEST(ModelErrors, RefuseASecondAxiom)
{
    EXPECT_EQ(compile_error("Lsystem: 1\nAxiom: A(1)\nAxiom: A(2,3)\n"),
              "model.l:3:7: found a second axiom, expected one");
}

TEST(ModelErrors, CountLinesOfCommentsAndNameTheMacrosPlace)
{
    EXPECT_EQ(compile_error("/* one\n two */\n#define BAD (1\nLsystem: 1\nAxiom: A(BAD)\n"),
              "model.l:5:14: found the end of the line, expected ',' or ')'");
}

TEST(ModelErrors, NameTheIncludedFile)
{
    ModelSource source;
    source.text = "#include \"constants.h\"\nLsystem: 1\nAxiom: A\nendlsystem\n";
    auto const model = compile_model(
        source, [](std::string const&) -> Result<std::string> { return "\nhello\n"; });
    ASSERT_FALSE(model);
    EXPECT_EQ(model.error().message, "constants.h:2:1: found 'h', expected 'Lsystem:'");
    EXPECT_EQ(compile_error(source.text),
              "model.l:1:1: cannot include constants.h: this model has no folder");
}

TEST(ModelErrors, StopAFileThatIncludesItself)
{
    ModelSource source;
    source.text = "#include \"model.l\"\n";
    auto const model = compile_model(
        source, [&](std::string const&) -> Result<std::string> { return source.text; });
    ASSERT_FALSE(model);
    EXPECT_NE(model.error().message.find("does it include itself?"), std::string::npos)
        << model.error().message;
}

TEST(Preprocessor, ReplacesNamesNotPartsOfThem)
{
    EXPECT_EQ(derived("#define F G\nAxiom: F FF xF", 0), "GFFxF");
    EXPECT_EQ(derived("#define N 3\nAxiom: A(N, 2*N)", 0), "A(3,6)");
}

TEST(Preprocessor, ReplacesMacrosWithParameters)
{
    EXPECT_EQ(derived("#define twice(x) ((x)+(x))\nAxiom: A(twice(2+1), twice(twice(1)))", 0),
              "A(6,4)");
    EXPECT_EQ(compile_error("#define f(x) x\nLsystem: f(1,2)\n"),
              "model.l:2:11: macro f has 1 parameters, found 2 arguments");
}

TEST(Preprocessor, LeavesTheTurtlesSymbolsAlone)
{
    EXPECT_EQ(derived("Axiom: A\nA -->\n\t#(0.5) F", 1), "#(0.5)F");
    EXPECT_EQ(derived("Axiom: \\(90)/(90) / /", 0), "\\(90)/(90)//");
}

TEST(Preprocessor, ReadsConditions)
{
    EXPECT_EQ(derived("#define X 1\n#ifdef X\nAxiom: A\n#else\nAxiom: B\n#endif", 0), "A");
    EXPECT_EQ(derived("#ifdef X\nAxiom: A\n#else\nAxiom: B\n#endif", 0), "B");
    EXPECT_EQ(derived("#if 0\nnot read\n#endif\nAxiom: B", 0), "B");
}

TEST(Preprocessor, StopsMacrosThatGrowWithoutEnd)
{
    std::string text = "#define A0 xxxxxxxxxxxxxxxx\n";
    for (int i = 1; i < 40; ++i)
        text += "#define A" + std::to_string(i) + " A" + std::to_string(i - 1) + " A"
            + std::to_string(i - 1) + "\n";
    EXPECT_NE(compile_error(text + "Lsystem: A39\n").find("more than 16 MB"), std::string::npos);
}

TEST(Model, WarnsOnceOfWhatItLacks)
{
    auto const model = compiled("Lsystem: 1\nStart: {printf(\"%f\", 1); printf(\"again\"); y = "
                                "z;}\nAxiom: A\nendlsystem\n");
    ASSERT_EQ(model.warnings.size(), 3u);
    EXPECT_EQ(model.warnings[0], "model.l:2:9: printf() is not supported; its value is 0");
    EXPECT_EQ(model.warnings[2], "model.l:2:47: z is not defined; its value is 0");
}

} // namespace
} // namespace tractus
