#include "tests/engine/lsystem/reference.h"
#include "tests/engine/lsystem/small_model.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <rapidcheck/gtest.h>
#include <string>
#include <tuple>
#include <vector>

// Compares all ways in which the program rewrites and draws strings with the reference
// implementation.

namespace tractus::lsystem {
namespace {

using Texts = std::vector<std::string>;

std::string all_of(Texts const& parts)
{
    std::string text;
    for (auto const& part : parts)
        text += part;
    return text;
}

std::string text_of(Model const& model, ModuleString const& string)
{
    ReferenceString modules;
    auto const* parameter = string.parameters.data();
    for (auto const kind : string.kinds.span()) {
        modules.push_back({ kind });
        for (int i = 0; i < model.alphabet[kind].parameter_count; ++i)
            modules.back().parameters.push_back(*parameter++);
    }
    return to_string(model, modules);
}

// Derives the model as a whole and in pieces of length `piece`, and compares the strings with the
// reference.
void compare(std::string const& text, int steps, std::size_t piece)
{
    constexpr std::size_t kMax = 2000;
    RC_LOG(text);
    auto const model = compiled(with_header(text, steps));
    auto const expected = ReferenceRewriter(model, 1).derive(steps, kMax);
    DeriveOptions options;
    options.limits.max_modules = kMax;
    for (auto const length : { options.piece, piece }) {
        options.piece = length;
        auto const string = derive(model, options);
        if (!expected)
            RC_ASSERT(!string || string->size() > kMax / 2);
        else if (string)
            RC_ASSERT(text_of(model, *string) == to_string(model, *expected));
        else
            RC_FAIL(string.error().message);
    }
}

rc::Gen<std::string> any_of(Texts const& texts)
{
    return rc::gen::elementOf(texts);
}

Texts some(rc::Gen<std::string> const& gen, std::size_t most)
{
    auto texts = *rc::gen::container<Texts>(gen);
    texts.resize(std::min(texts.size(), most));
    return texts;
}

std::string plain_context()
{
    return all_of(some(any_of({ "A", "B", "C", "+", "A", "B" }), 3));
}

std::string right_context()
{
    return all_of(some(any_of({ "A", "B", "C", "+", "[A]", "[B", "B]", "[A]B" }), 2));
}

std::string string_of_plain_modules(std::size_t most)
{
    return all_of(some(any_of({ "A", "B", "C", "+", "-", "[", "]", "[", "]", "A[B]", "%" }), most));
}

// Rules that have no parameters and contexts of one module use the context table. All other rules
// do not.
RC_GTEST_PROP(Reference, RulesWithContextsAgree, ())
{
    std::string text = *any_of({ "", "", "ring L-system\n" })
        + *any_of({ "", "ignore: +-\n", "consider: ABC\n", "consider: AB[]\n", "ignore: -[]\n" })
        + "Axiom: A" + string_of_plain_modules(40) + "\n";
    for (auto const rules = *rc::gen::inRange(1, 6);
         std::count(text.begin(), text.end(), '>') < rules;) {
        auto const left = plain_context();
        auto const right = right_context();
        auto const successor = string_of_plain_modules(4);
        text += (left.empty() ? "" : left + " < ") + *any_of({ "A", "B", "C", "+", "AB", "B+" })
            + (right.empty() ? "" : " > " + right) + " --> " + (successor.empty() ? "*" : successor)
            + "\n";
    }
    compare(text, *rc::gen::inRange(1, 5), *rc::gen::inRange<std::size_t>(1, 20));
}

// The rules are a random choice of rules with programs, stochastic choice, conditions and blocks.
// Some are executed for many modules at once.
RC_GTEST_PROP(Reference, RulesWithProgramsAgree, ())
{
    static Texts const rules {
        "A(x,y) --> F(x)[+(30)A(x*0.5,y)]A(x-1,y+x)",
        "A(x,y) : x > y --> B(x*0.9,sin(y))",
        "A(x,y) : x <= y && y < 5 --> A(y+1,x)A(x/2,y)",
        "B(x,y) --> B(y,x) : 0.4",
        "B(x,y) --> B(x*2,ran(y))C : 1 + x",
        "B(x,y) --> * : 0.2",
        "A(a,b) < B(x,y) --> B(a+x,b+y)C",
        "B(x,y) > A(a,b) : a != x --> B(a,b)B(x,y)",
        "A(a,b) < B(x,y) > C --> B(a,y)",
        "C --> C[C]A(2,1)",
        "C --> D : 0.5",
        "C --> DD : 0.5",
        "D --> F(1)",
        "F(x) --> F(x*1.1)",
        "B(x,y) : {z = x*2; w = w+1;} z < 9 {z = z+w;} --> B(z,w)",
        "B(x,y)C --> C",
        "A(x,y) : Q%2 == 0 --> A(x+Q,nran(y,1))",
    };
    std::string text = *any_of({ "", "ignore: +F\n" }) + *any_of({ "", "seed: 7\n" }) + "Axiom: "
        + all_of(some(
            any_of({ "A(3,1)", "B(1,2)", "C", "D", "[A(0,1)]", "[", "]", "F(1)", "+(5)" }), 30))
        + "A(2,2)\n";
    for (auto const& rule : some(any_of(rules), 9))
        text += rule + "\n";
    if (*rc::gen::arbitrary<bool>())
        text += "decomposition\nmaximum depth: " + *any_of({ "1", "2", "5" })
            + "\nF(x) : x > 1 --> F(x/2)F(x/2)\n" + *any_of({ "", "D --> EF(3)\n" });
    compare(text, *rc::gen::inRange(1, 5), *rc::gen::inRange<std::size_t>(1, 40));
}

using Numbers = std::array<double, 7>;

std::vector<Numbers> in_some_order(std::vector<Numbers> segments)
{
    std::sort(segments.begin(), segments.end(), [](Numbers const& one, Numbers const& other) {
        auto const rounded = [](double value) { return std::round(value * 1e6); };
        for (std::size_t i = 0; i < one.size(); ++i)
            if (rounded(one[i]) != rounded(other[i]))
                return one[i] < other[i];
        return false;
    });
    return segments;
}

std::vector<Numbers> segments_of(Plant const& plant)
{
    std::vector<Numbers> segments;
    for (auto const& axis : plant.axes)
        for (auto i = axis.first_node; i < axis.first_node + axis.segment_count; ++i) {
            auto const& from = plant.node_position_mm[i];
            auto const& to = plant.node_position_mm[i + 1];
            segments.push_back({ from.x(), from.y(), from.z(), to.x(), to.y(), to.z(),
                                 2 * static_cast<double>(plant.node_radius_mm[i]) });
        }
    return in_some_order(std::move(segments));
}

// The turtle draws common symbols in a fast path and branches in other threads. If it can count
// segments, it writes them directly to their positions.
RC_GTEST_PROP(Reference, SegmentsAgree, ())
{
    static Texts const symbols { "F",  "F",      "F(0.5)", "F(0)",  "f",     "G(2)",    "g",
                                 "+",  "-(40)",  "&",      "^(7)",  "\\(5)", "/(137)",  "|",
                                 "@v", "!(0.1)", "#(0.3)", "[",     "]",     "[",       "]",
                                 "H",  "H",      "I(2)",   "[+F]F", "A",     "[&(80)H]" };
    auto const text = "Axiom: !(0.2)F" + all_of(some(any_of(symbols), 60))
        + "\nhomomorphism\nmaximum depth: 3\nH --> F(0.3)[-I(1)]@vF\nI(x) : x > 0 --> "
          "F(x)+(10)I(x-1)\n";
    RC_LOG(text);
    auto const model = compiled(with_header(text, 0), "angle increment: 25\n");
    ReferenceRewriter rewriter(model, 1);
    std::vector<Numbers> expected;
    for (auto const& [from, to, diameter] :
         draw_reference(model, rewriter.drawn(rewriter.derive(0, 1000).value()), 25, 0.2))
        expected.push_back({ from.x(), from.y(), from.z(), to.x(), to.y(), to.z(), diameter });
    expected = in_some_order(std::move(expected));
    auto const string = derive(model).value();
    for (std::size_t const branch :
         { std::size_t { 8192 }, *rc::gen::inRange<std::size_t>(1, 9) }) {
        auto const segments = segments_of(
            interpret(model, string, { .unit_mm = 1, .long_branch = branch }).value());
        RC_ASSERT(segments.size() == expected.size());
        for (std::size_t i = 0; i < segments.size(); ++i)
            for (std::size_t k = 0; k < segments[i].size(); ++k)
                RC_ASSERT(std::abs(segments[i][k] - expected[i][k]) < 1e-6);
    }
}

} // namespace
} // namespace tractus::lsystem
