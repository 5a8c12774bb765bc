#include "engine/lsystem/fast_rewriting/range_rewriter.h"
#include "tests/engine/lsystem/small_model.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <rapidcheck/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#include <vector>

namespace tractus::lsystem {
namespace {

// Fixes the seed of the property tests, unless the environment variable RC_PARAMS sets other
// parameters.
[[maybe_unused]] bool const has_parameters
    = setenv("RC_PARAMS", "seed=1 max_success=500", 0) == 0; // NOLINT(concurrency-mt-unsafe)

// Generates a string of random modules of a few kinds, with mostly closed branches.
rc::Gen<std::string> random_string(std::string const& symbols)
{
    return rc::gen::map(
        rc::gen::container<std::string>(rc::gen::elementOf(symbols + "[[]]")),
        [](std::string text) {
            auto const depth = std::count(text.begin(), text.end(), '[')
                - std::count(text.begin(), text.end(), ']');
            return text
                + std::string(static_cast<std::size_t>(std::max<std::ptrdiff_t>(depth, 0)), ']');
        });
}

// Generates the text of a rule, which may have a context of one module on each side.
rc::Gen<std::string> random_rule_text()
{
    auto const context = [] { return rc::gen::element<std::string>("", "", "A", "B", "C", "+"); };
    return rc::gen::map(rc::gen::tuple(context(), rc::gen::element<std::string>("A", "B", "C", "+"),
                                       context(), random_string("ABC+-")),
                        [](auto const& parts) {
                            auto const& [left, predecessor, right, successor] = parts;
                            return (left.empty() ? "" : left + " < ") + predecessor
                                + (right.empty() ? "" : " > " + right) + " --> "
                                + (successor.empty() ? "*" : successor) + "\n";
                        });
}

std::string derived_by(int threads, Model const& model, DeriveOptions const& options)
{
    tbb::global_control const allow(tbb::global_control::max_allowed_parallelism, 4);
    tbb::task_arena arena(threads);
    return arena.execute([&] { return to_string(model, derive(model, options).value()); });
}

// The context table must give the same result as the search for contexts. A rule with a parameter,
// which never applies, prevents the use of the table.
RC_GTEST_PROP(LSystemProperty, ContextTableAgreesWithTheSearch, ())
{
    auto const rules = *rc::gen::container<std::vector<std::string>>(random_rule_text());
    auto const seen = *rc::gen::element<std::string>("", "ignore: +-\n", "consider: ABC\n");
    std::string text = seen + "Axiom: A" + *random_string("ABC+-") + "\n";
    for (auto const& rule : rules)
        text += rule;
    auto const steps = *rc::gen::inRange(1, 5);
    auto const tabled = compiled(with_header(text, steps));
    auto const searched = compiled(with_header(text + "Z(x) --> Z(x)", steps));
    DeriveOptions options;
    options.limits.max_modules = 100'000;
    auto const expected = derive(searched, options);
    auto const string = derive(tabled, options);
    RC_ASSERT(string.has_value() == expected.has_value());
    if (string)
        RC_ASSERT(to_string(tabled, *string) == to_string(searched, *expected));
}

// The strings include unbalanced brackets, and brackets that contexts ignore.
RC_GTEST_PROP(LSystemProperty, PiecesAgreeOnTheNeighboursAcrossThem, ())
{
    auto const rules = *rc::gen::container<std::vector<std::string>>(random_rule_text());
    auto const seen
        = *rc::gen::element<std::string>("", "ignore: +-\n", "consider: ABC\n", "ignore: []+\n");
    std::string text = seen + "Axiom: A"
        + *rc::gen::container<std::string>(rc::gen::elementOf(std::string("ABC+-[[]]"))) + "\n";
    for (auto const& rule : rules)
        text += rule;
    auto const model = compiled(with_header(text, *rc::gen::inRange(1, 6)));
    DeriveOptions options;
    options.limits.max_modules = 100'000;
    auto const serial = derive(model, options);
    RC_PRE(serial.has_value());
    auto const expected = to_string(model, *serial);
    options.piece = *rc::gen::inRange<std::size_t>(1, 12);
    RC_ASSERT(derived_by(1, model, options) == expected);
    RC_ASSERT(derived_by(4, model, options) == expected);
}

// Uses rules of all kinds, and splits every string into pieces.
RC_GTEST_PROP(LSystemProperty, ParallelAgreesWithSerial, ())
{
    auto const rule = rc::gen::element<std::string>(
        "A(x) : x > 1 --> F(x)[+(30)A(x*0.5)]A(x-1)", "A(x) --> B(ran(x))A(x+1) : 0.5",
        "A(x) --> C[A(x)] : x + 1", "B(x) > A(y) --> CB(nran(x,y))", "A(y) < B(x) --> A(x)C",
        "B(x) : {z = x*2;} z < 5 {z = z+1;} --> B(z)", "B(x)C --> C", "C --> [C]A(2)", "C --> *",
        "F(x) --> F(x)F(x/2)", "+(x) --> +(x)G", "G --> [GG]");
    auto const module = rc::gen::element<std::string>("A(2)", "A(0.5)", "B(1)", "C", "C", "F(1)",
                                                      "+(10)", "G", "[A(1)]", "[", "]");
    std::string text = *rc::gen::element<std::string>("", "ignore: +G\n") + "Axiom: A(3)";
    for (auto const& part : *rc::gen::container<std::vector<std::string>>(module))
        text += part;
    for (auto const& line : *rc::gen::container<std::vector<std::string>>(rule))
        text += '\n' + line;
    auto const model = compiled(with_header(text, *rc::gen::inRange(1, 5)));
    auto const serial = derive(model);
    RC_PRE(serial.has_value()); // Uses only cases that stay within the limits.
    auto const expected = to_string(model, *serial);
    DeriveOptions options;
    options.piece = *rc::gen::inRange<std::size_t>(1, 12);
    RC_ASSERT(derived_by(1, model, options) == expected);
    RC_ASSERT(derived_by(4, model, options) == expected);
}

// The rules replace each module by a known number of modules. So pieces are written directly to
// their positions, and some pieces are smaller than one memory copy.
RC_GTEST_PROP(LSystemProperty, PiecesOfKnownSizesAreWrittenToTheirPlaces, ())
{
    auto const module = rc::gen::element<std::string>("A(2)", "B(1)", "C", "D", "E", "F(1)",
                                                      "+(10)", "[A(1)]", "C", "C");
    std::string text = "seed: 3\nAxiom: A(3)B(1)";
    for (auto const& part : *rc::gen::container<std::vector<std::string>>(module))
        text += part;
    for (std::string const line : { "A(x) --> F(x)[+(30)A(x*0.5)]A(x-1)", "C --> *", "C --> E",
                                    "B(x) --> CB(nran(x,1)) : 0.3\nB(x) --> DA(x+1) : 0.7",
                                    "D --> DDDDDDDDDDF(1)DDDDDDDDDDDDDD", "F(x) --> F(x/2)E" })
        if (*rc::gen::arbitrary<bool>())
            text += '\n' + line;
    auto const model = compiled(with_header(text, *rc::gen::inRange(1, 5)));
    auto const serial = derive(model);
    RC_PRE(serial.has_value());
    auto const expected = to_string(model, *serial);
    DeriveOptions options;
    options.piece = *rc::gen::inRange<std::size_t>(1, 40);
    RC_ASSERT(derived_by(1, model, options) == expected);
    RC_ASSERT(derived_by(4, model, options) == expected);
}

// Generates a module whose two parameters a rule computes from those of its predecessor.
rc::Gen<std::string> random_module()
{
    auto const value = [] {
        return rc::gen::element<std::string>(
            "x", "y", "x*0.5", "y*0.7", "x+y", "x-y*2", "y/x", "x/(y-y)", "sin(x*50)^2", "x<y",
            "-x", "0.1", "sqrt(y*y)", "floor(x)%2", "atan2(x,y)", "x==y", "(x+y)*0.3-x*y*0.01");
    };
    return rc::gen::map(
        rc::gen::tuple(rc::gen::element<std::string>("A", "B", "C", "F", "[+]"), value(), value()),
        [](auto const& parts) {
            auto const& [symbol, first, second] = parts;
            return symbol == "[+]" ? symbol : symbol + "(" + first + "," + second + ")";
        });
}

// Returns stochastic rules for the modules A, B and C, each with `condition`.
std::string rules_of_chance(std::vector<std::string> const& successors,
                            std::string const& condition)
{
    static constexpr std::array kWeights { "0.2", "1", "3", "0.6" };
    std::string text;
    for (std::size_t i = 0; i < successors.size(); ++i)
        text += std::string(1, "ABC"[i % 3]) + "(x,y)" + condition + " --> "
            + (successors[i].empty() ? "*" : successors[i]) + " : " + kWeights[i % kWeights.size()]
            + "\n";
    return text;
}

// Without conditions, modules with the same rules are rewritten together. With a condition that
// always holds, rules are tried for one module after another. D's rule draws random numbers itself,
// E's rule has a condition in either case, and F's rule needs no program.
RC_GTEST_PROP(LSystemProperty, ModulesRewrittenTogetherAreAsThoseRewrittenAlone, ())
{
    std::vector<std::string> successors(*rc::gen::inRange<std::size_t>(3, 9));
    for (auto& successor : successors)
        for (auto const& module : *rc::gen::container<std::vector<std::string>>(random_module()))
            successor += module;
    successors[0] += "A(x*0.9,y)B(y,x)";
    successors[1] += "D(x)C(y,1)E(y)";
    std::string const others = "D(x) --> D(ran(x))B(x,ran(1))\nE(x) : x > 0.5 --> E(x*0.9)F(x,x)\n"
        + *rc::gen::element<std::string>("", "F(x,y) --> F(y,x)[F(x,1)]\n");
    auto const axiom = "seed: 5\nAxiom: " + *rc::gen::element<std::string>("", "FF[+]+F(1,2)")
        + "A(1,2)B(3,0.5)C(0.2,7)E(1)D(2)A(1,1)A(2,2)\n";
    auto const steps = *rc::gen::inRange(1, 6);
    auto const together
        = compiled(with_header(axiom + others + rules_of_chance(successors, ""), steps));
    auto const alone
        = compiled(with_header(axiom + others + rules_of_chance(successors, " : 1"), steps));
    RC_ASSERT(RulePlan(together, together).has_batches());
    RC_ASSERT(!RulePlan(alone, alone).has_batches());
    DeriveOptions options;
    options.limits.max_modules = 3'000;
    auto const expected = derive(alone, options);
    auto const string = derive(together, options);
    RC_ASSERT(string.has_value() == expected.has_value());
    if (!string)
        return;
    RC_ASSERT(to_string(together, *string) == to_string(alone, *expected));
    options.piece = *rc::gen::inRange<std::size_t>(1, 300);
    RC_ASSERT(derived_by(1, together, options) == to_string(alone, *expected));
    RC_ASSERT(derived_by(4, together, options) == to_string(alone, *expected));
}

// An additional rule precedes a rule with the same effect, but applies only in some contexts. It
// must not change the result.
RC_GTEST_PROP(LSystemProperty, ContextsThatChangeNothingChangeNothing, ())
{
    auto const context = [] { return rc::gen::element<std::string>("", "A", "B", "C", "+"); };
    auto const axiom = "Axiom: A" + *random_string("ABC+-");
    std::string plain = axiom;
    std::string contexts = axiom;
    for (std::string const predecessor : { "A", "B", "C" }) {
        auto successor = *random_string("ABC+-");
        if (successor.empty())
            successor = "*";
        auto const left = *context();
        auto const right = *context();
        plain += '\n' + predecessor + " --> " + successor;
        contexts += '\n' + (left.empty() ? "" : left + " < ") + predecessor
            + (right.empty() ? "" : " > " + right) + " --> " + successor;
        contexts += '\n' + predecessor + " --> " + successor;
    }
    auto const steps = *rc::gen::inRange(1, 4);
    // Without the additional text, the table finds contexts. A rule with a parameter makes the
    // search find them.
    for (std::string const more : { "", "\nZ(x) --> Z(x)" }) {
        auto const one = compiled(with_header(plain + more, steps));
        auto const other = compiled(with_header(contexts + more, steps));
        DeriveOptions options;
        options.limits.max_modules = 100'000;
        auto const expected = derive(one, options);
        auto const string = derive(other, options);
        RC_ASSERT(string.has_value() == expected.has_value());
        if (string)
            RC_ASSERT(to_string(other, *string) == to_string(one, *expected));
    }
}

// A branch that %(x) keeps must be derived as if it were a string of its own.
RC_GTEST_PROP(LSystemProperty, KeptBranchesDeriveByThemselves, ())
{
    std::string rules = *rc::gen::element<std::string>("", "ignore: +-%\n", "consider: ABC%\n");
    auto const balanced = [] {
        return rc::gen::suchThat(random_string("ABC+-"), [](std::string const& text) {
            int depth = 0;
            for (char const c : text)
                if ((depth += (c == '[') - (c == ']')) < 0)
                    return false;
            return true;
        });
    };
    std::string successors = "\nZ(x) --> Z(x)";
    for (auto const& rule : *rc::gen::container<std::vector<std::string>>(random_rule_text()))
        successors += '\n' + rule;
    auto const derive_one = [&](std::string const& axiom) {
        return derived(rules + "Axiom: " + axiom + successors, 1);
    };
    auto const first = "A" + *balanced();
    auto const second = "B" + *balanced();
    RC_ASSERT(derive_one(first + "%(3,0)" + second)
              == derive_one(first) + "%(3,0)" + derive_one(second));
}

RC_GTEST_PROP(LSystemProperty, StringsPrintAndParse, ())
{
    auto const text = "A" + *random_string("ABC+-F");
    auto const model = compiled(with_header("Axiom: " + text, 0));
    RC_ASSERT(to_string(model, derive(model).value()) == text);
}

TEST(LSystemThreads, ParametersAndChanceDoNotDependOnTheirNumber)
{
    auto const model
        = compiled(with_header("Axiom: A(1)\n"
                               "A(x) : x > 0.2 --> F(x)[+(30)A(x*0.97)]B(x)A(x*0.95) : 0.5\n"
                               "A(x) : x > 0.1 --> F(x)[-(30)A(x*0.96)][B(ran(1))]A(x*0.94) : 0.5\n"
                               "B(x) > A(y) --> C(x,y)B(nran(0,1)) : 2\n"
                               "B(x) --> B(x) : 1",
                               14));
    auto const one = derived_by(1, model, {});
    EXPECT_GT(std::count(one.begin(), one.end(), 'F'), 10'000);
    EXPECT_TRUE(derived_by(2, model, {}) == one);
    EXPECT_TRUE(derived_by(4, model, {}) == one);
}

// Neighbouring pieces may become empty, or nearly empty.
TEST(LSystemThreads, PiecesMayBecomeNothing)
{
    EXPECT_EQ(derived("Axiom: AAA\nA --> *"), "");
    auto const model = compiled(with_header("Axiom: " + std::string(40, 'A') + "BBB"
                                                + std::string(40, 'A') + "\nA --> *\nB --> CD",
                                            1));
    for (std::size_t const piece : { 1u, 2u, 7u, 50u })
        EXPECT_EQ(derived_by(4, model, { .piece = piece }), "CDCDCD") << piece;
}

TEST(LSystemThreads, KnownSuccessorsDoNotDependOnTheirNumber)
{
    auto const model = compiled(
        with_header("Axiom: F(1)\nF(x) --> F(x)[+F(2)]G(x,3)[-XXXXXXXXXXXXXXXXXXXXF(x)]", 11));
    auto const one = derived_by(1, model, {});
    EXPECT_GT(one.size(), 1'000'000u);
    EXPECT_TRUE(derived_by(2, model, {}) == one);
    EXPECT_TRUE(derived_by(4, model, {}) == one);
}

// A rule that sets the seed must affect all later modules, even those whose own rules only do plain
// arithmetic.
TEST(LSystemThreads, SeedsThatARuleSetsHoldFromThereOn)
{
    std::string const start
        = "Axiom: A(1)A(1)S(3)A(1)A(1)A(1)S(4)A(1)\nS(x) : 1 {srand(x);} --> S(x)\n";
    auto const with = [&](std::string const& condition) {
        std::string text = start;
        for (auto const* const sign : { "+", "-" })
            text += "A(x)" + condition + " --> A(x" + sign + "0.25)A(x*2) : 1\n";
        return derived(text, 8);
    };
    EXPECT_EQ(with(""), with(" : 1"));
}

TEST(LSystemThreads, GlobalVariablesKeepTheOrderOfModules)
{
    auto const model = compiled(
        with_header("Start: {n = 0;}\nAxiom: A\nA : Q == 18 {n = n + 1;} --> B(n)\nA --> AA", 18));
    auto const string = derived_by(4, model, {});
    EXPECT_EQ(string.substr(0, 12), "B(1)B(2)B(3)");
}

} // namespace
} // namespace tractus::lsystem
