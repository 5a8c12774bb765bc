#include "engine/methods/construction_lines/lines_to_draw.h"

#include "tests/engine/methods/construction_lines/sketches.h"

#include <gtest/gtest.h>
#include <limits>

namespace tractus::lines {
namespace {

// A proposed line already stands for the missing one. So drawing the line as proposed must not
// change any organ.
void expect_same_organs(LineSketch const& lacking, LineSketch const& whole)
{
    auto const guessed = measure_sketch(lacking, Missing::Guessed);
    auto const drawn = measure_sketch(whole, Missing::Refused);
    ASSERT_TRUE(guessed) << guessed.error().message;
    ASSERT_TRUE(drawn) << drawn.error().message;
    ASSERT_EQ(guessed->nodes.size(), drawn->nodes.size());
    for (std::size_t i = 0; i < guessed->nodes.size(); ++i) {
        auto const& one = guessed->nodes[i];
        auto const& other = drawn->nodes[i];
        EXPECT_NEAR(one.x, other.x, 1e-9) << i;
        EXPECT_NEAR(one.left_deg, other.left_deg, 1e-6) << i;
        EXPECT_NEAR(one.right_deg, other.right_deg, 1e-6) << i;
        EXPECT_NEAR(one.left_size, other.left_size, 1e-9) << i;
        EXPECT_NEAR(one.right_size, other.right_size, 1e-9) << i;
    }
}

TEST(LinesToDraw, ABoundaryIsTheOtherOneMirrored)
{
    auto sketch = hand_sketch();
    sketch.right.clear();
    auto const lines = lines_to_draw(sketch);
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_EQ(lines[0], (std::vector<Vec2> { { 50, 0 }, { 50, 300 } }));
    auto whole = sketch;
    whole.right = lines[0];
    expect_same_organs(sketch, whole);
}

TEST(LinesToDraw, InclinationLinesReachBothBoundaries)
{
    auto sketch = hand_sketch();
    sketch.inclinations.clear();
    auto const lines = lines_to_draw(sketch);
    ASSERT_EQ(lines.size(), 2U);
    for (auto const& line : lines) {
        EXPECT_NEAR(line.front().x(), -50, 1e-9);
        EXPECT_NEAR(line.back().x(), 30, 1e-9);
    }
    auto whole = sketch;
    whole.inclinations = lines;
    expect_same_organs(sketch, whole);
}

TEST(LinesToDraw, TheSecondInclinationLineLeansAsTheOnlyOne)
{
    for (auto const sketch_of : { hand_sketch, bent_sketch })
        for (std::size_t kept : { 0U, 1U }) {
            auto sketch = sketch_of();
            sketch.inclinations = { sketch.inclinations[kept] };
            sketch.nodes_per_layer = { 4 };
            auto const lines = lines_to_draw(sketch);
            ASSERT_EQ(lines.size(), 1U);
            auto const guessed = measure_sketch(sketch, Missing::Guessed).value();
            auto whole = sketch;
            whole.inclinations.push_back(lines[0]);
            auto const drawn = measure_sketch(whole).value();
            // The proposal is at the end of the stem where the inclination line is missing.
            auto const& proposed
                = kept == 0 ? drawn.inclinations.back() : drawn.inclinations.front();
            auto const& there
                = kept == 0 ? guessed.inclinations.back() : guessed.inclinations.front();
            EXPECT_NEAR(proposed.x, there.x, 1e-9);
            EXPECT_NEAR(proposed.left_deg, there.left_deg, 1e-6);
            EXPECT_NEAR(proposed.right_deg, there.right_deg, 1e-6);
        }
}

TEST(LinesToDraw, AStemAloneGetsABowOnEachSide)
{
    LineSketch sketch;
    sketch.stem = bent_sketch().stem;
    auto const lines = lines_to_draw(sketch);
    ASSERT_EQ(lines.size(), 2U);
    auto whole = sketch;
    whole.left = lines[0];
    whole.right = lines[1];
    whole.nodes_per_layer = { 5 };
    auto const drawn = measure_sketch(whole, Missing::Guessed);
    ASSERT_TRUE(drawn) << drawn.error().message;
    for (auto const& node : drawn->nodes) {
        EXPECT_GT(node.left_size, 0);
        EXPECT_GT(node.right_size, 0);
    }
}

TEST(LinesToDraw, NothingIsProposedWhereNothingIsMissingOrNothingCanBeMeasured)
{
    EXPECT_TRUE(lines_to_draw(hand_sketch()).empty());
    EXPECT_TRUE(lines_to_draw(coarse_sketch()).empty());
    EXPECT_TRUE(lines_to_draw({}).empty());
    auto broken = hand_sketch();
    broken.left = { Vec2(std::numeric_limits<double>::quiet_NaN(), 0), Vec2(0, 1) };
    broken.right.clear();
    EXPECT_TRUE(lines_to_draw(broken).empty());
}

} // namespace
} // namespace tractus::lines
