#include "engine/lsystem/notations/book_text.h"
#include "engine/lsystem/notations/foreign_text.h"
#include "tests/engine/lsystem/small_model.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace tractus::lsystem {
namespace {

// Returns the warnings for rules, one in each line, without the file name "model.l:".
std::string warned(std::string const& rules)
{
    std::string text;
    for (auto const& warning : compiled(rules).warnings)
        text += (warning.starts_with("model.l:") ? warning.substr(8) : warning) + '\n';
    return text;
}

void expect_begins(std::string const& text, std::string const& beginning)
{
    EXPECT_EQ(text.substr(0, beginning.size()), beginning);
}

TEST(OtherNotations, LettersWithoutEffectAreWarnedOfOnce)
{
    expect_begins(warned(with_header("Axiom: F'F'$F")),
                  "3:9: ' has no effect here; books print it for the next colour, which is ;");
    EXPECT_NE(warned(with_header("Axiom: F'F'$F")).find("\n3:12: $ has no effect here"),
              std::string::npos);
    EXPECT_EQ(warned(with_header("Axiom: A\nA --> FXA[Y]X")),
              "4:8: X has no effect: no rule replaces it, and the turtle does not know it\n"
              "4:11: Y has no effect: no rule replaces it, and the turtle does not know it\n");
    expect_begins(warned(with_header("Axiom: F\u2212F")),
                  "3:9: \u2212 is not the keyboard's minus sign");
    auto const many = warned(with_header("Axiom: FABCDEFHIJ"));
    EXPECT_EQ(std::count(many.begin(), many.end(), '\n'), 5) << many;
    EXPECT_NE(many.find("\n4 more letters have no effect\n"), std::string::npos) << many;
}

TEST(OtherNotations, LettersWithARoleAreNotWarnedOf)
{
    for (auto const* const rules :
         { "Axiom: A\nA --> FB\nB --> B",    // B is replaced by itself.
           "Axiom: A\nA --> B",              // B is the state in which A rests.
           "Axiom: MA\nM < A --> FA",        // M is a context.
           "Axiom: MA\nM < A --> FAX",       // X separates modules that see each other.
           "ignore: X\nAxiom: XA\nA --> FA", // X is ignored on purpose.
           // X, v, G and others are names of organs or parts of other symbols.
           "Axiom: A\nA --> ~XF@vF@Gs@Gc@DiF?P(0,0,0)",
           "Axiom: 'F\n' --> F",     // The symbol ' has a rule of its own.
           "Axiom: ?(1)F$\nF --> F", // ?(1) calls an L-system.
           "Axiom: A\nA --> FX\nhomomorphism\nX --> F" })
        EXPECT_EQ(warned(with_header(rules)), "") << rules;
}

TEST(OtherNotations, NamesOfSeveralLettersAreWarnedOf)
{
    EXPECT_EQ(warned(with_header("Axiom: Apex(1)\nApex(t) --> Node[+Leaf]Apex(t+1)")),
              "3:8: Apex is read as the modules A, p, e and x, since names have one letter here: "
              "call it B, for example\n"
              "4:13: Node is read as the modules N, o, d and e, since names have one letter here: "
              "call it N, for example\n"
              "4:19: Leaf is read as the modules L, e, a and f, since names have one letter here: "
              "call it L, for example\n");
    expect_begins(warned(with_header("Axiom: Fl\nFl --> Fl+Fr+\nFr --> -Fl-Fr")),
                  "4:1: Fl is read as the modules F and l");
    // These are single letters that stand together, or modules that are replaced together.
    for (auto const* const rules : { "Axiom: Xab\nX --> Fab\na --> b\nb --> a",
                                     "Axiom: AB\nAB --> BAF\nA --> B\nB --> A", "Axiom: FFFfffgg" })
        EXPECT_EQ(warned(with_header(rules)), "") << rules;
}

TEST(OtherNotations, LabelsAreWarnedOf)
{
    auto const label = "4:1: p1: is read as a rule for the modules p and 1, since rules have no "
                       "labels here; leave it out";
    expect_begins(warned(with_header("Axiom: A\np1: A --> F[+A]A")), label);
    EXPECT_EQ(warned(with_header("Axiom: A\np1: A --> F[+A]A")).find("A has no effect"),
              std::string::npos);
    for (std::string const rule : { "p12 : A(t) : t > 0 --> A(t-1)", "p3: B < A --> B",
                                    "p5: A(s*(t)) < B --> B", "q1:A(t) --> B" }) {
        auto const text = with_header("Axiom: A(1)\n" + rule);
        auto const error = compile_error(text);
        EXPECT_NE(
            (error == "no error" ? warned(text) : error).find("is read as a rule for the modules"),
            std::string::npos)
            << rule;
    }
    expect_begins(compile_error(with_header("Axiom: A(1)\np1 : A(t) : t > 0 --> A(t-1)")),
                  std::string("model.l:") + label);
    // A rule for the two modules p and 1, with a variable in its condition. They must not be taken
    // for a label.
    EXPECT_EQ(warned(with_header("Start: {n = 1;}\nAxiom: pF1p\np1 : n > 0 --> F")).find("label"),
              std::string::npos);
}

TEST(OtherNotations, ArrowsAreNamed)
{
    for (std::string const arrow : { "->", "\u2192", "=>", "\u2014>" })
        EXPECT_EQ(compile_error(with_header("Axiom: A\nA " + arrow + " FA")),
                  "model.l:4:1: found 'A " + arrow
                      + " FA', expected -->: the arrow of rules has two dashes here (--dialect "
                        "book reads both)");
    expect_begins(compile_error("Lsystem: 1\n\u03c9 : A\nA --> FA\n"),
                  "model.l:2:1: found '\u03c9 : A', expected 'Axiom:'");
    EXPECT_EQ(compile_error("n=5, \u03b4=22.5\u00b0\n\u03c9 : A\n"),
              "model.l:1:1: found 'n=5, \u03b4=22.5\u00b0', expected 'Lsystem:'; --dialect book "
              "reads models as books print them");
}

TEST(OtherNotations, ChanceWithoutASeedIsWarnedOf)
{
    std::string const rules = "Axiom: A\nA --> FA : 0.5\nA --> A : 0.5";
    expect_begins(warned(with_header(rules)),
                  "4:1: rules have probabilities, but there is no seed");
    EXPECT_EQ(warned(with_header("Seed: 0\n" + rules)), "");
    // With the seed that the warning suggests, the plant stays the same.
    EXPECT_EQ(derived("Seed: 0\n" + rules, 9), derived(rules, 9));
}

TEST(OtherNotations, UndefinedNamesComeLastAndAreCounted)
{
    auto const text = warned(with_header("Axiom: F(a)F(b)F(c)F(d)F(e)'"));
    EXPECT_EQ(text.find("3:28: ' has no effect"), 0u) << text;
    EXPECT_NE(text.find("\n3:10: a is not defined; its value is 0\n"), std::string::npos) << text;
    EXPECT_NE(text.find("\n2 more names are not defined; their values are 0\n"), std::string::npos)
        << text;
}

// Returns the string derived from a model that is written in the book's notation.
std::string derived_of_book(std::string const& text, int steps)
{
    auto const model = compiled(read_book_model(text).text);
    EXPECT_TRUE(model.warnings.empty()) << model.warnings.front();
    auto const string = derive(model, { .steps = steps });
    return string ? to_string(model, *string) : string.error().message;
}

TEST(BookNotation, IsReadBesideCpfgsStatements)
{
    EXPECT_EQ(derived_of_book("Lsystem: 1\nderivation length: 2\nAxiom: A\n"
                              "A --> F///'[$A] // grows\nendlsystem\n",
                              2),
              "F///;[@vF///;[@vA]]");
    EXPECT_EQ(derived_of_book("/* A bush. */\nn=2, \u03b4=22.5\u00b0\n\u03c9: F\n"
                              "p1 : F \u2192 F[+F]\u2212F // a comment\n",
                              1),
              "F[+F]-F");
    EXPECT_EQ(read_book_model("n = 2, d = 22.5\nw: F\n").view, "angle increment: 22.5\n");
    EXPECT_EQ(derived_of_book("\u03c9 : A(1,3)\np1: A(s,t) : t=3 & s\u22641 -> F(s)\n"
                              "    //[+A(s,t)]\n",
                              1),
              "F(1)//[+A(1,3)]");
}

TEST(BookNotation, KeepsTheNumbersOfLines)
{
    ModelSource source;
    source.text = read_book_model("/* two\nlines */\nn=3\n\u03c9 : F\n\np1 : F -> F(\n").text;
    auto const model = compile_model(source);
    ASSERT_FALSE(model);
    EXPECT_EQ(model.error().message.substr(0, 10), "model.l:6:") << model.error().message;
}

TEST(BookNotation, GivesNamesALetter)
{
    // Figure 1.10 a, the dragon curve, in which the turtle draws both kinds of edges.
    auto const model
        = compiled(read_book_model("w : Fl\np1 : Fl -> Fl+Fr+\np2 : Fr -> -Fl-Fr\n").text);
    EXPECT_TRUE(model.warnings.empty()) << model.warnings.front();
    auto const string = derive(model, { .steps = 10 });
    ASSERT_TRUE(string);
    auto const plant = interpret(model, *string);
    ASSERT_TRUE(plant);
    EXPECT_EQ(plant->segment_count(), 1024u);
}

TEST(BookNotation, ReadsProbabilitiesAtArrows)
{
    auto const text = read_book_model("w : F\np1 : F -> .33 F[+F]F\np2 : F ->.67 F[-F]F\n").text;
    EXPECT_NE(text.find("F --> F[+F]F : .33\n"), std::string::npos) << text;
    auto const model = compiled(text);
    EXPECT_TRUE(model.warnings.empty()) << model.warnings.front();
    EXPECT_TRUE(model.rules.rules.front().has_probability);
}

// A text must do no harm if it is cut off anywhere, or is not in the book's notation at all.
TEST(BookNotation, SurvivesCutsAndNoise)
{
    std::string const text = "#ignore : +-\nn=5, \u03b4=22.5\u00b0\n\u03c9 : A(1)\n"
                             "p1 : B < A_1(t) > C : t\u22653 \u2192.5 F[//'$F]A_1(t)\n/* end";
    for (std::size_t size = 0; size <= text.size(); ++size) {
        // The result is an error or the text "no error"; the program must not crash.
        EXPECT_FALSE(compile_error(read_book_model(text.substr(0, size)).text).empty());
        auto const reversed = std::string(text.rbegin(), text.rend()).substr(0, size);
        EXPECT_FALSE(compile_error(read_book_model(reversed).text).empty());
    }
}

struct Foreign {
    char const* text;
    char const* name;
    std::uint32_t line;
};

TEST(ForeignLanguages, AreNamedWithTheLineThatShowsThem)
{
    std::vector<Foreign> const foreign {
        { "from openalea.plantgl.all import *\nAxiom: A(0)\n", "L-Py (Python)", 1 },
        { "Axiom: A\nderivation length: 4\nproduction:\nA --> F[+A]A\nendlsystem\n",
          "L-Py (Python)", 3 },
        { "Axiom: A(1)\n\nA(t) :\n  if t > 0:\n    nproduce F(t)\n  produce A(t-1)\n",
          "L-Py (Python)", 5 },
        { "#include <lpfgall.h>\nLsystem: 1\n", "L+C (lpfg)", 1 },
        { "derivation length: 5;\nmodule A(float);\n", "L+C (lpfg)", 1 },
        { "# tree\n7 # recursion\n22.5\n80\nA\nA=[&FL!A]>>>>>[&FL!A]\n@\n", "LParser's notation",
          4 },
        { "recursion 12\nangle 10\nthickness 80\naxiom FS\nrule S = WZ'!cS\n", "LParser's notation",
          3 },
        { "Premise: A\nRule 1: A=F[+A]A\n", "Houdini's notation", 1 },
        { "premise = FFA\nrule1 = A=!\"[B]////[B]////B\n", "Houdini's notation", 1 },
        { "Koch1 { ; a snowflake\n Angle 6\n Axiom F--F--F\n F=F-F++F-F\n}\n",
          "Fractint's notation", 2 },
        { "module A(float len) extends Sphere(0.1);\nprotected void init()\n[ Axiom ==> A(1); ]\n",
          "XL (GroIMP)", 2 },
        { "\n{ \"axiom\": \"F\" }\n", "JSON", 2 },
    };
    for (auto const& [text, name, line] : foreign) {
        auto const found = find_foreign_notation(text);
        ASSERT_TRUE(found) << text;
        EXPECT_EQ(found->name, name) << text;
        EXPECT_EQ(found->line, line) << text;
        auto const sentence = describe_foreign_text("x.l", *found);
        EXPECT_EQ(sentence.find("x.l:" + std::to_string(line) + ": this is " + name), 0u)
            << sentence;
    }
}

TEST(ForeignLanguages, AreNotSeenInCpfgsModels)
{
    for (auto const* const text :
         { "Lsystem: 1\nAxiom: A\nA --> FA\nendlsystem\n",
           "/* import this:\nproduce more\npremise: none */\nLsystem: 1\n",
           "#define N 3\n  LSYSTEM: 2\nimport --> F\n", "Axiom: A\nA --> F\n", "", "\n\n",
           "organ: l leaf kind=blade\n" })
        EXPECT_FALSE(find_foreign_notation(text)) << text;
}

} // namespace
} // namespace tractus::lsystem
