#include "engine/methods/sketch_lsystem/drawn_axis.h"

#include "engine/lsystem/derivation/derive.h"
#include "engine/lsystem/fast_drawing/interpret.h"
#include "engine/lsystem/language/print.h"
#include "engine/methods/sketch_lsystem/stroke_resampler.h"
#include "tests/engine/methods/sketch_lsystem/strokes.h"

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>

namespace tractus::sketch {
namespace {

DrawnAxis axis_of(Rule const& rule, std::vector<Vec3> const& tips)
{
    return draw_axis(rule, resample_stroke(rule, tips));
}

std::string string_of(Rule const& rule, DrawnAxis const& axis)
{
    auto const model = lsystem::compile_model(write_model(rule, axis, Leaves::Leafy, "sketch"));
    EXPECT_TRUE(model) << model.error().message;
    EXPECT_TRUE(model->warnings.empty());
    return lsystem::to_string(*model, *lsystem::derive(*model));
}

// Returns the string that another program has derived for the stroke `name`.
std::string expected_string(std::string const& name)
{
    std::ifstream file(std::string(TRACTUS_EXPECTED_STRINGS) + "/" + name + ".txt");
    std::string line;
    EXPECT_TRUE(std::getline(file, line)) << name;
    return line;
}

// A string without its numbers, and its numbers in order.
struct Parsed {
    std::string modules;
    std::vector<double> numbers;
};

Parsed parse(std::string const& string)
{
    Parsed parsed;
    for (auto const* at = string.c_str(); *at != '\0';) {
        char* end = nullptr;
        bool const is_number
            = (*at >= '0' && *at <= '9') || (*at == '-' && at[1] >= '0' && at[1] <= '9');
        if (is_number) {
            parsed.numbers.push_back(std::strtod(at, &end));
            at = end;
        } else {
            parsed.modules += *at++;
        }
    }
    return parsed;
}

// Expects a string with the same modules as the other program's, and with parameters that are equal
// in single precision.
void expect_derives_to(std::string const& name, Rule const& rule, std::vector<Vec3> const& tips)
{
    auto const ours = parse(string_of(rule, axis_of(rule, tips)));
    auto const theirs = parse(expected_string(name));
    EXPECT_EQ(ours.modules, theirs.modules);
    ASSERT_EQ(ours.numbers.size(), theirs.numbers.size());
    for (std::size_t i = 0; i < ours.numbers.size(); ++i)
        EXPECT_NEAR(ours.numbers[i], theirs.numbers[i], 1.1e-5 * (1 + std::abs(theirs.numbers[i])))
            << name << ", number " << i;
}

Rule const kBowRule { .first_length_mm = 40,
                      .first_width_mm = 7,
                      .angle_deg = 52,
                      .lateral_twist_deg = 70,
                      .shortest_mm = 4 };

TEST(DrawnAxis, DerivesToTheStringsOfAnotherProgram)
{
    Rule const hand { .first_length_mm = 40,
                      .length_ratio = 0.8,
                      .width_ratio = 0.5,
                      .first_width_mm = 4,
                      .lateral_length = 0.5,
                      .lateral_width = 0.5 };
    expect_derives_to("hand", hand, straight_stroke(120, 120));
    Rule const corner { .length_ratio = 1,
                        .first_width_mm = 4,
                        .laterals = 1,
                        .lateral_length = 0.5,
                        .lateral_width = 0.6,
                        .axis_twist_deg = 0 };
    expect_derives_to("corner", corner, corner_in_space());
    expect_derives_to("bow", kBowRule, bow());
    expect_derives_to("short", kBowRule, bow(75));
}

TEST(DrawnAxis, TurnsByTheLeastRotation)
{
    auto const axis = axis_of({ .length_ratio = 1 }, corner_in_space());
    ASSERT_EQ(axis.segments(), 3);
    EXPECT_EQ(axis.turns[0], (Turn { 0, 0 }));
    EXPECT_NEAR(axis.turns[1].plane_deg, 180, 1e-4);
    EXPECT_NEAR(axis.turns[1].bend_deg, 90, 1e-4);
    EXPECT_NEAR(axis.turns[2].plane_deg, -90, 1e-4);
    EXPECT_NEAR(axis.turns[2].bend_deg, 90, 1e-4);
}

// On a half circle, the first bend is expected to be asin(l / 2R), and all others twice that.
TEST(DrawnAxis, BendsEvenlyOnACircle)
{
    auto const axis = axis_of({ .length_ratio = 1 }, half_circle(50));
    ASSERT_EQ(axis.segments(), 5);
    EXPECT_NEAR(axis.turns[0].bend_deg, 17.4576, 2e-4);
    for (std::size_t i = 1; i < 5; ++i)
        EXPECT_NEAR(axis.turns[i].bend_deg, 34.9152, 2e-4);
}

TEST(DrawnAxis, ComesBackToTheStroke)
{
    Rule const rule { .first_length_mm = 25, .length_ratio = 0.95 };
    auto const nodes_mm = resample_stroke(rule, bow());
    auto const back_mm = nodes_of(draw_axis(rule, nodes_mm), rule);
    ASSERT_EQ(back_mm.size(), nodes_mm.size());
    for (std::size_t i = 0; i < nodes_mm.size(); ++i)
        EXPECT_LT((back_mm[i] - nodes_mm[i]).norm(), 1e-3);
}

// The turtle must draw the axis of the model where the pen was; 1 mm on the desk is 1 cm of the
// plant.
TEST(DrawnAxis, IsDrawnByTheModelWhereThePenWas)
{
    auto const nodes_mm = resample_stroke(kBowRule, bow());
    auto const axis = draw_axis(kBowRule, nodes_mm);
    auto const model = lsystem::compile_model(write_model(kBowRule, axis, Leaves::Bare, "sketch"));
    ASSERT_TRUE(model) << model.error().message;
    auto const plant = lsystem::interpret(*model, *lsystem::derive(*model));
    ASSERT_TRUE(plant) << plant.error().message;
    for (std::size_t i = 1; i < nodes_mm.size(); ++i) {
        double nearest_mm = 1e9;
        for (auto const& node : plant->node_position_mm)
            nearest_mm = std::min(nearest_mm, (node / 10 - nodes_mm[i]).norm());
        EXPECT_LT(nearest_mm, 1e-3) << "node " << i;
    }
}

TEST(DrawnAxis, HasTheSameStringWithAndWithoutLeaves)
{
    auto const axis = axis_of(kBowRule, bow());
    auto const bare = lsystem::compile_model(write_model(kBowRule, axis, Leaves::Bare, "sketch"));
    ASSERT_TRUE(bare) << bare.error().message;
    EXPECT_EQ(lsystem::to_string(*bare, *lsystem::derive(*bare)), string_of(kBowRule, axis));
}

TEST(DrawnAxis, GrowsWithoutLaterals)
{
    Rule const rule { .laterals = 0 };
    auto const axis = axis_of(rule, straight_stroke(60));
    EXPECT_EQ(string_of(rule, axis),
              "/(0)+(0)\\(0)!(4.5)F(30)/(0)+(0)\\(0)!(3.825)F(27)T(2,24.3,3.25125)");
}

} // namespace
} // namespace tractus::sketch
