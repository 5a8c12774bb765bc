#include "engine/lsystem/language/model.h"

#include "tests/engine/lsystem/small_model.h"

#include <cmath>
#include <gtest/gtest.h>

namespace tractus::lsystem {
namespace {

TEST(ModelErrors, NameTheLineAndColumn)
{
    EXPECT_EQ(compile_error("Lsystem: 1\nAxiom: A\nA -> B\n"),
              "model.l:3:1: found 'A -> B', expected -->: the arrow of rules has two dashes here "
              "(--dialect book reads both)");
    EXPECT_EQ(compile_error("Axiom: A\n"), "model.l:1:1: found 'Axiom: A', expected 'Lsystem:'");
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
    EXPECT_EQ(model.error().message, "constants.h:2:1: found 'hello', expected 'Lsystem:'");
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
    auto const model = compiled("Lsystem: 1\nStart: {stop(1); stop(1); y = z; y = z;}\nAxiom: "
                                "A%(1)\nA --> B(stop(z))\nendlsystem\n");
    ASSERT_EQ(model.warnings.size(), 2u);
    EXPECT_EQ(model.warnings[0],
              "model.l:2:9: stop() is about cpfg's window; stop, play and Display do nothing here, "
              "and vvXmin to vvScale are 0");
    EXPECT_EQ(model.warnings[1], "model.l:2:31: z is not defined; its value is 0");
}

TEST(Model, GivesFunctionsItLacksTheValuesThatModelsExpect)
{
    auto const model = compiled("Lsystem: 1\nAxiom: F(stop(7), Display(2), vvXmin(1), "
                                "vvScale(1), play(\"bell\"), inblob(1,0,0,0), stop(1)+1)\n"
                                "endlsystem\n");
    EXPECT_EQ(to_string(model, *derive(model)), "F(7,2,0,0,0,0,2)");
    // One warning is for the window, whatever is asked about it, and one is for blobs.
    ASSERT_EQ(model.warnings.size(), 2u);
    EXPECT_EQ(model.warnings[1],
              "model.l:2:68: inblob() is not supported; its value is 0, as outside of all blobs");
}

TEST(Model, RefusesFilesWithOneWarning)
{
    auto const model = compiled("Lsystem: 1\nStart: {f = fopen(\"x\", \"w\"); fprintf(f, "
                                "\"%f\", 1); fscanf(f, \"%f\", &y); fclose(f);}\nAxiom: "
                                "F(f)\nendlsystem\n");
    ASSERT_EQ(model.warnings.size(), 2u); // The second warning is about the variable y.
    EXPECT_EQ(model.warnings[0],
              "model.l:2:13: models read and write no files here: fopen() gives -1, and fprintf, "
              "fscanf, fflush and fclose do nothing");
    EXPECT_EQ(to_string(model, *derive(model)), "F(-1)");
}

TEST(Model, ChecksFormatsWhenItIsCompiled)
{
    EXPECT_EQ(compile_error("Lsystem: 1\nStart: {printf(\"%s\", 1);}\nAxiom: A\n"),
              "model.l:2:16: found '%s' in a format, expected %d %i %u %x %o %f %e or %g, with a "
              "width and a precision of at most 99, or %%");
    EXPECT_EQ(compile_error("Lsystem: 1\nStart: {printf(1);}\nAxiom: A\n"),
              "model.l:2:16: found '1', expected a format in double quotes");
    EXPECT_EQ(compile_error("Lsystem: 1\nStart: {printf(\"x);}\nAxiom: A\n"),
              "model.l:2:16: the string has no closing '\"'");
    auto const model
        = compiled("Lsystem: 1\nStart: {printf(\"%f %f\", 1);}\nAxiom: F\nendlsystem\n");
    ASSERT_EQ(model.warnings.size(), 1u);
    EXPECT_EQ(model.warnings[0],
              "model.l:2:9: the format of printf asks for 2 values, found 1; "
              "those missing are 0");
}

TEST(Model, LooksUpCurvesByNumberAndName)
{
    ModelSource source;
    source.text = with_header("Axiom: A(curveX(1,0.5), curveY(bow,0.5), curveZ(1,9), curveX(2,0), "
                              "curveGAL(1), curveGAL(bow), curveGAL(2))",
                              0);
    source.view_text = "curve: bow.cur\n";
    auto const model = compile_model(source, [](std::string const&) -> Result<std::string> {
        return "points: 4\ndim: 3\ntype: bezier\n0 0 0\n1 0 3\n2 0 6\n3 0 9\n";
    });
    ASSERT_TRUE(model) << model.error().message;
    auto const string = derive(*model);
    ASSERT_EQ(string->parameters.size(), 7u);
    EXPECT_NEAR(static_cast<double>(string->parameters[0]), 1.5, 1e-4);
    EXPECT_NEAR(static_cast<double>(string->parameters[1]), 0, 1e-4);
    EXPECT_NEAR(static_cast<double>(string->parameters[2]), 9, 1e-4);
    EXPECT_EQ(string->parameters[3], 0.0f);
    // The curve ends at (3, 0, 9).
    EXPECT_NEAR(static_cast<double>(string->parameters[4]), std::sqrt(90), 1e-4);
    EXPECT_EQ(string->parameters[5], string->parameters[4]);
    EXPECT_EQ(string->parameters[6], 0.0f);
}

TEST(Messages, NameTheWordOfAStatementThatWasMeant)
{
    auto const error_in = [](std::string const& statements) {
        return compile_error(with_header("Axiom: A\nA : { " + statements + " } 1 --> B"));
    };
    EXPECT_EQ(error_in("x = snn(3);"),
              "model.l:4:11: found the function snn, expected sin, perhaps");
    EXPECT_EQ(error_in("prinft(\"a\");"),
              "model.l:4:7: found the function prinft, expected printf, perhaps");
    EXPECT_EQ(error_in("whlie (1) x = 3;"),
              "model.l:4:7: found the function whlie, expected while, perhaps");
    EXPECT_EQ(error_in("if (1) x = 3; esle x = 4;"),
              "model.l:4:21: found 'esle', expected 'else', perhaps");
    EXPECT_EQ(error_in("y x = 4;"), "model.l:4:9: found 'x', expected ';'");
}

// A definition whose last character is a backslash continues with the next line, which is the
// axiom. So the error is found on a later line.
TEST(Messages, SayWhatThePreprocessorSawBefore)
{
    EXPECT_EQ(compile_error("Lsystem: 1\n#define TURN +\\\nAxiom: TURN F\nA --> B\nendlsystem\n"),
              "model.l:4:1: found 'A --> B', expected 'Axiom:' or another statement of the header; "
              "before that, model.l:2:1: the \\ at the end of this definition joins the next line "
              "to it ('Axiom: TURN F'); for the turtle symbol, write another one behind it, such "
              "as \\(a)");
}

// Text after the L-system does not belong to it, whatever character the text begins with.
TEST(Messages, WarnOfWhatFollowsTheSystem)
{
    for (auto const* const rest : { "more\n", "  more\n", "\tmore --> F\n" }) {
        auto const model = compiled(with_header("Axiom: A\nA --> B") + rest);
        ASSERT_EQ(model.warnings.size(), 1u) << rest;
        EXPECT_NE(model.warnings[0].find("what follows endlsystem is not read"), std::string::npos);
    }
    EXPECT_EQ(compile_error("Lsystem: 1\nAxiom: A\nendlsystem more\n"),
              "model.l:3:16: found more behind endlsystem, expected the end of the line");
}

TEST(Messages, NameTheStatementThatWasMeant)
{
    EXPECT_EQ(compile_error(with_header("Axiom: A\nignor +-\nA --> B")),
              "model.l:4:1: found 'ignor +-', expected 'ignore:', perhaps");
    EXPECT_EQ(compile_error(with_header("Axiom: A\nStat: { x = 1; }\nA --> B")),
              "model.l:4:1: found 'Stat: { x = 1; }', expected 'Start:', perhaps");
    EXPECT_EQ(compile_error(with_header("define: { aray a[3]; }\nAxiom: A")),
              "model.l:3:11: found 'aray', expected 'array' or 'external'");
    EXPECT_EQ(compile_error("Lsystem: 1\nderivation lenght: 5\nAxiom: A\nendlsystem\n"),
              "model.l:2:1: found 'derivation lenght: 5', expected 'derivation length:', perhaps");
    EXPECT_EQ(compile_error("Lsytem: 1\nAxiom: A\n"),
              "model.l:1:1: found 'Lsytem: 1', expected 'Lsystem:', perhaps");
    EXPECT_EQ(compile_error(with_header("Axoim: A\nA --> B")),
              "model.l:3:1: found 'Axoim: A', expected 'Axiom:', perhaps");
    EXPECT_EQ(compile_error(with_header("Axiom: A\nA --> B\nhomomorphsim\nB --> F")),
              "model.l:5:1: found 'homomorphsim', expected 'homomorphism', perhaps");
    EXPECT_EQ(compile_error(with_header("Axiom: A\nmaximum deph: 3\nA --> B")),
              "model.l:4:1: found 'maximum deph: 3', expected 'maximum depth:', perhaps");
    EXPECT_EQ(
        compile_error(with_header("Axiom: A\nwhatever I mean")),
        "model.l:4:1: found 'whatever I mean', expected a rule, which has -->, or a statement");
    EXPECT_EQ(compile_error("whatever: 3\n"),
              "model.l:1:1: found 'whatever: 3', expected 'Lsystem:'");
}

TEST(Messages, EscapeWhatIsNoText)
{
    EXPECT_EQ(compile_error("Lsystem: 1\n\x1b[31mred\nAxiom: A\n"),
              "model.l:2:1: found '\\x1b[31mred', expected 'Axiom:' or another statement of the "
              "header");
    EXPECT_EQ(compile_error(with_header("Axiom: A(\x01)")),
              "model.l:3:10: found '\\x01', expected a number, a name or '('");
    EXPECT_EQ(compile_error(with_header("Axiom: A(\xc3\xa4)")),
              "model.l:3:10: found '\xc3\xa4', expected a number, a name or '('");
    EXPECT_EQ(compile_error(with_header("Axiom: A(\xff)")),
              "model.l:3:10: found '\\xff', expected a number, a name or '('");
    EXPECT_EQ(compile_error("#if \x07\n#endif\n"),
              "model.l:1:5: found '\\x07' in #if, expected an integer");
}

} // namespace
} // namespace tractus::lsystem
