#include "engine/lsystem/fast_drawing/segment_plan.h"
#include "tests/engine/lsystem/small_model.h"

#include <fmt/format.h>
#include <optional>
#include <rapidcheck/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#include <vector>

// Tests that a string is drawn as the same plant however it is split into pieces, and with any
// number of threads.

namespace tractus::lsystem {
namespace {

std::string text(Vec3 const& v)
{
    return fmt::format("{:a},{:a},{:a}", v.x(), v.y(), v.z());
}

// Returns the full contents of a plant as text, exact to the last bit.
std::string dump(TurtlePlant const& drawn)
{
    auto const& plant = drawn.plant;
    std::string result;
    auto const line = [&](auto const&... parts) {
        ((result += fmt::format("{} ", parts)), ...);
        result += '\n';
    };
    for (auto const& axis : plant.axes)
        line("axis", axis.first_node, axis.first_segment, axis.segment_count, axis.parent_segment,
             axis.parent_axis, axis.order);
    for (std::size_t i = 0; i < plant.node_position_mm.size(); ++i)
        line("node", text(plant.node_position_mm[i]), fmt::format("{:a}", plant.node_radius_mm[i]));
    for (auto const material : plant.segment_material)
        line("segment", material);
    for (auto const& organ : plant.organs)
        line("organ", organ.shape, organ.segment, text(organ.position_mm),
             fmt::format("{:a} {:a}", organ.orientation.w(), organ.orientation.x()),
             text(organ.scale.cast<double>()));
    for (auto const& polygon : plant.polygons)
        line("polygon", polygon.first_vertex, polygon.vertex_count, polygon.segment,
             polygon.material);
    for (auto const& vertex : plant.polygon_vertices_mm)
        line("vertex", text(vertex));
    for (auto const& material : plant.materials)
        line("material", material.name);
    for (auto const& shape : plant.organ_shapes)
        line("shape", shape.name, shape.material);
    for (auto const& warning : drawn.warnings)
        line("warning", warning);
    return result;
}

// Returns the plant that is drawn in pieces, as text, or the error. `long_branch` is the minimum
// number of modules of a branch that is drawn as a piece.
std::string drawn_in_pieces(Model const& model, ModuleString const& string, int threads,
                            std::size_t long_branch, std::size_t max_parts = 1'000'000)
{
    tbb::global_control const allow(tbb::global_control::max_allowed_parallelism, 4);
    tbb::task_arena arena(threads);
    return arena.execute([&] {
        TurtleOptions options;
        options.max_parts = max_parts;
        options.long_branch = long_branch;
        auto const plant = interpret_with_warnings(model, string, options);
        return plant ? dump(*plant) : plant.error().message;
    });
}

constexpr std::size_t kWhole = 1'000'000'000;

char const* const kPiecesView = R"(angle increment: 25
line width: 0.2 pixels
tropism: T: 1 0.3 0 A: 0 I: 1 E: 0.1 S: 0.02
material: 1 green kind=leaf color=0.2,0.6,0.1
material: 2 red kind=petal color=0.9,0.1,0.1
organ: l leaf kind=blade material=1 length=2 width=1
)";

// Returns the text of modules. Most of its brackets are closed, so that most strings can be split.
std::string closed(std::vector<std::string> const& parts)
{
    std::string text;
    int depth = 0;
    for (auto const& part : parts) {
        if (part == "]" && depth == 0)
            continue;
        depth += (part == "[") - (part == "]");
        text += part;
    }
    return text + std::string(static_cast<std::size_t>(depth), ']');
}

rc::Gen<std::string> any_bracket()
{
    return rc::gen::element<std::string>("[", "[", "[", "]", "]", "]");
}

// The strings have random modules of all kinds that pieces treat differently, and unbalanced
// brackets and braces.
RC_GTEST_PROP(Pieces, DrawTheSamePlant, ())
{
    auto const symbol = rc::gen::element<std::string>(
        "F", "F", "F(0.5)", "F(0)", "f", "G", "+", "-(40)", "&", "/(137.5)", "@v", "!(0.1)", "#",
        ";", ",(1)", ";(2)", "~l", "~x", "@o", "@c(0.3)", "H", "H", "I", "@D(0.7)", "_(0.2)",
        "@Ts(1,0.3)", "@Gs", "@Ge", "@Q");
    auto const rare = rc::gen::element<std::string>("{", ".", "}", "%", "[", "]", "J");
    auto const any = rc::gen::weightedOneOf<std::string>(
        { { 30, symbol }, { 10, any_bracket() }, { 1, rare } });
    auto const text = closed(*rc::gen::container<std::vector<std::string>>(any));
    auto const model = compiled(
        with_header(
            "Axiom: F" + text + "F\nhomomorphism\nH --> F(ran(1))[+F;~l]\nI --> [F\nJ --> ]F\n", 0),
        kPiecesView);
    auto const string = derive(model).value();
    auto const expected = drawn_in_pieces(model, string, 1, kWhole);
    auto const length = *rc::gen::inRange<std::size_t>(1, 12);
    RC_ASSERT(drawn_in_pieces(model, string, 1, length) == expected);
    RC_ASSERT(drawn_in_pieces(model, string, 4, length) == expected);
}

// Returns the planned pieces of a string; no value if it is too short or cannot be planned.
std::optional<std::vector<PlannedPiece>> plan(Model const& model, ModuleString const& string,
                                              std::size_t long_branch)
{
    BranchIndex const index(model, string, long_branch);
    return plan_segments(model, string, {}, index, parameter_range(string));
}

// The strings have random modules whose segments can be counted before drawing.
RC_GTEST_PROP(Pieces, DrawTheSamePlantWhereSegmentsAreCounted, ())
{
    auto const zeros = *rc::gen::element<std::string>("F(0)", "F(0.1)", "A(0)");
    auto const symbol = rc::gen::element<std::string>(
        "F", "F", "F(0.5)", zeros, "f", "G", "g(2)", "+", "-(40)", "/(137.5)", "@v", "!(0.1)", "#",
        ";", ",(1)", ";(2)", "~l", "~x(2)", "@o", "@c(0.3)", "H", "H(3)", "_(0.2)", "@Ts(1,0.3)",
        "@R(0,1,0)", "{F.[-f.]+F.G}", "?P", "?Q");
    auto const any = rc::gen::weightedOneOf<std::string>({ { 30, symbol }, { 10, any_bracket() } });
    auto const text = closed(*rc::gen::container<std::vector<std::string>>(any));
    auto const model = compiled(
        with_header("Axiom: F" + text + "F\nhomomorphism\nH --> +~l@o;\nH(x) --> !(x)H\n", 0),
        kPiecesView);
    auto const string = derive(model).value();
    auto const expected = drawn_in_pieces(model, string, 1, kWhole);
    auto const length = *rc::gen::inRange<std::size_t>(1, 12);
    RC_CLASSIFY(plan(model, string, length).has_value());
    RC_ASSERT(drawn_in_pieces(model, string, 1, length) == expected);
    RC_ASSERT(drawn_in_pieces(model, string, 4, length) == expected);
}

// Returns a model of a tree with leaves, whose pieces are drawn by several threads.
Model tree(int steps)
{
    return compiled(with_header("Axiom: A(1)\n"
                                "A(l) --> !(l*0.1)F(l)[&(40)B(l*0.8)]/(137.5)A(l*0.9)\n"
                                "B(l) --> !(l*0.1)F(l)[-(45)@v;C(l*0.8)]~lC(l*0.9)\n"
                                "C(l) --> F(l)[+(45)B(l*0.7)]{.[+F.][-F.]}B(l*0.9)\n"
                                "homomorphism\nA(l) --> ~l(l)",
                                steps),
                    kPiecesView);
}

// In the second plant, a module with an infinite parameter precedes the string. It disables the
// fast path for common symbols.
RC_GTEST_PROP(Turtle, DrawsCommonSymbolsAsItDrawsAll, ())
{
    auto const part = rc::gen::element<std::string>(
        "F", "F(2)", "F(0)", "F(-1)", "F(9e11)", "G(3)", "f", "f(0)", "g(2)", "+", "-(30)", "&(10)",
        "^", "/(50)", "\\", "|", "[", "[", "[", "]", "]", "]", "!", "!(0.3)", "#", "#(0)", "@v",
        "@v", "@v(1)", ";", ",(1)", "@D(2)", "@Di(0.5)", "{", "}", ".", "~l", "@o(1)", "A", "B(3)",
        "_(0.1)", "@", "v", "@R(1,2,3)", "@M(1,1,1)", "%", "?P(1,2,3)");
    std::string text;
    for (auto const& symbol : *rc::gen::container<std::vector<std::string>>(part))
        text += symbol;
    auto const plant_of = [&](std::string const& axiom) {
        auto const model = compiled(with_header("Axiom: " + axiom, 0), "angle increment: 25\n");
        auto const plant = interpret(model, derive(model).value());
        return plant ? dump({ *plant, {} }) : plant.error().message;
    };
    RC_ASSERT(plant_of(text) == plant_of("Z(exp(1000))" + text));
}

TEST(Pieces, OfALongStringDrawTheSamePlant)
{
    auto const model = tree(13);
    auto const string = derive(model).value();
    ASSERT_GT(string.size(), 100'000u);
    auto const whole = drawn_in_pieces(model, string, 1, kWhole);
    for (std::size_t const length : { 50u, 700u, 8192u })
        for (int const threads : { 1, 2, 4 })
            EXPECT_TRUE(drawn_in_pieces(model, string, threads, length) == whole)
                << length << " modules, " << threads << " threads";
}

TEST(Pieces, OfATreeMakeAValidPlant)
{
    auto const model = tree(9);
    auto const plant = interpret(model, derive(model).value(), { .long_branch = 20 }).value();
    check_plant(plant);
    EXPECT_GT(plant.segment_count(), 500u);
}

TEST(Pieces, ReachALimitTogether)
{
    auto const model = tree(10);
    auto const string = derive(model).value();
    auto const parts = interpret(model, string).value();
    auto const count = parts.segment_count() + parts.organs.size() + parts.polygons.size();
    auto const expected = drawn_in_pieces(model, string, 1, kWhole, count - 1);
    EXPECT_NE(expected.find("derive fewer steps"), std::string::npos) << expected;
    EXPECT_EQ(drawn_in_pieces(model, string, 4, 20, count - 1), expected);
    EXPECT_NE(drawn_in_pieces(model, string, 4, 20, count), expected);
}

TEST(Pieces, AreCountedBeforeTheyAreDrawn)
{
    auto const model = tree(10);
    auto const string = derive(model).value();
    auto const plant = interpret(model, string, { .long_branch = kWhole }).value();
    auto const pieces = plan(model, string, 100);
    ASSERT_TRUE(pieces);
    EXPECT_GT(pieces->size(), 10u);
    EXPECT_EQ(pieces->front().axis_count, plant.axes.size());
    EXPECT_EQ(pieces->front().segment_count, plant.segment_count());
}

// The segments that these symbols draw cannot be counted without drawing them.
TEST(Pieces, AreNotCountedWhereSymbolsDoMore)
{
    for (std::string const symbol : { "@Gs", "@D(2)", "@M(1,2,3)", "@bo", "{(1)", "%", "@", "H" }) {
        auto const model = compiled(
            with_header("Axiom: " + symbol + "[FFFF][FFFF]FFFF\nhomomorphism\nH --> F\n", 0),
            kPiecesView);
        EXPECT_FALSE(plan(model, derive(model).value(), 2)) << symbol;
    }
    auto const model = compiled(with_header("Axiom: [FFFF][FFFF]FFFF", 0), kPiecesView);
    EXPECT_TRUE(plan(model, derive(model).value(), 2));
}

// The homomorphism changes a global variable, so the modules must be drawn in their order.
TEST(Pieces, KeepTheOrderOfGlobalVariables)
{
    auto const model = compiled(with_header("Start: {n = 0;}\nAxiom: A\nA --> FB[+A]A\n"
                                            "homomorphism\nB : 1 {n = n + 1;} --> F(n/100)",
                                            12));
    auto const string = derive(model);
    if (!string)
        FAIL() << string.error().message;
    EXPECT_TRUE(drawn_in_pieces(model, *string, 4, 30)
                == drawn_in_pieces(model, *string, 1, kWhole));
}

} // namespace
} // namespace tractus::lsystem
