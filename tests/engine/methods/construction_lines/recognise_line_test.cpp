#include "engine/methods/construction_lines/recognise_line.h"

#include "engine/methods/construction_lines/capture_line.h"
#include "tests/engine/methods/construction_lines/illustrator.h"
#include "tests/engine/methods/construction_lines/sketches.h"

namespace tractus::lines {
namespace {

LineRecogniser with_stem()
{
    LineRecogniser recogniser;
    EXPECT_EQ(recogniser.add(line({ Vec2(0, 0), Vec2(0, 200) })).role, Role::Stem);
    return recogniser;
}

TEST(LineRecogniser, TellsLinesByHowTheyLieToTheStem)
{
    auto recogniser = with_stem();
    EXPECT_EQ(recogniser.add(line({ Vec2(40, 80), Vec2(0, 40), Vec2(-60, 100) })).role,
              Role::Inclination);
    EXPECT_EQ(recogniser.add(line({ Vec2(-50, 220), Vec2(-50, -10) })).role, Role::Left);
    EXPECT_EQ(recogniser.add(line({ Vec2(30, 0), Vec2(30, 210) })).role, Role::Right);
    EXPECT_EQ(recogniser.add(line({ Vec2(2, 150), Vec2(60, 190) })).role, Role::HalfInclination);
    auto const sketch = recogniser.sketch();
    EXPECT_EQ(sketch.stem.size(), 2U);
    EXPECT_EQ(sketch.left[0], Vec2(-50, 220));
    EXPECT_EQ(sketch.right[0], Vec2(30, 0));
    EXPECT_EQ(sketch.inclinations.size(), 2U);
}

TEST(LineRecogniser, ALineDrawnAgainTakesTheEarlierOnesPlace)
{
    auto recogniser = with_stem();
    recogniser.add(line({ Vec2(-50, 0), Vec2(-50, 200) }));
    recogniser.add(line({ Vec2(-60, 100), Vec2(0, 40), Vec2(40, 80) }));
    auto const& again = recogniser.add(line({ Vec2(42, 83), Vec2(2, 42), Vec2(-58, 104) }));
    EXPECT_EQ(again.role, Role::Inclination);
    EXPECT_EQ(again.replaces, std::optional<std::size_t>(2));
    EXPECT_EQ(recogniser.add(line({ Vec2(-90, 0), Vec2(-70, 200) })).replaces,
              std::optional<std::size_t>(1));
    EXPECT_EQ(recogniser.add(line({ Vec2(3, 2), Vec2(-2, 198) })).replaces,
              std::optional<std::size_t>(0));
    auto const sketch = recogniser.sketch();
    EXPECT_EQ(sketch.inclinations.size(), 1U);
    EXPECT_EQ(sketch.left[0], Vec2(-90, 0));
    EXPECT_EQ(sketch.stem[0], Vec3(3, 2, 0));
}

TEST(LineRecogniser, TwoHalvesAtOnePlaceAreOneLine)
{
    auto recogniser = with_stem();
    recogniser.add(line({ Vec2(-1, 50), Vec2(-60, 80) }));
    recogniser.add(line({ Vec2(60, 90), Vec2(-2, 54) }));
    recogniser.add(line({ Vec2(3, 150), Vec2(60, 190) }));
    auto sketch = recogniser.sketch();
    ASSERT_EQ(sketch.inclinations.size(), 2U);
    sketch.left = hand_sketch().left;
    sketch.right = hand_sketch().right;
    sketch.nodes_per_layer = { 3 };
    auto const result = measured(sketch);
    EXPECT_NEAR(result.inclinations[0].x, 0.255, 0.005);
    ASSERT_EQ(result.notes.size(), 1U);
    EXPECT_EQ(result.notes[0].substr(0, 39), "inclination line 2 has no half on the l");
}

TEST(LineRecogniser, CutsABoundarysEndThatReachesOverTheStem)
{
    auto recogniser = with_stem();
    EXPECT_EQ(
        recogniser.add(line({ Vec2(-40, 0), Vec2(-45, 100), Vec2(-2, 190), Vec2(4, 197) })).role,
        Role::Left);
    EXPECT_EQ(recogniser.sketch().left.back(), Vec2(-2, 190));
}

TEST(LineRecogniser, AsksWhatItDoesNotKnow)
{
    auto recogniser = with_stem();
    auto const dot = recogniser.add(line({ Vec2(80, 100), Vec2(90, 110) }));
    EXPECT_EQ(dot.role, Role::Unsure);
    EXPECT_EQ(dot.reason,
              "this line neither crosses the stem nor goes along it: draw an inclination "
              "line across it, or a boundary along at least half of it");
    auto const snake
        = recogniser.add(line({ Vec2(-30, 40), Vec2(30, 60), Vec2(-30, 80), Vec2(30, 99) }));
    EXPECT_EQ(snake.role, Role::Unsure);
    EXPECT_EQ(snake.reason.substr(0, 33), "this line crosses the stem 3 time");
    EXPECT_TRUE(recogniser.sketch().inclinations.empty());
}

TEST(LineRecogniser, KnowsTheStrokesOfSimulatedSketches)
{
    int strokes = 0;
    int right_strokes = 0;
    int right_sketches = 0;
    for (unsigned seed = 0; seed < 500; ++seed) {
        LineRecogniser recogniser;
        bool right = true;
        auto const drawn = Illustrator(seed).draw();
        for (auto const& [role, stroke] : drawn) {
            auto const& found = recogniser.add(capture_line(stroke));
            ++strokes;
            right_strokes += found.role == role ? 1 : 0;
            right = right && found.role == role;
        }
        right_sketches += right ? 1 : 0;
    }
    RecordProperty("strokes", strokes);
    RecordProperty("right_strokes", right_strokes);
    RecordProperty("right_sketches", right_sketches);
    EXPECT_GE(right_strokes, 0.99 * strokes) << "of " << strokes;
    EXPECT_GE(right_sketches, 0.97 * 500);
}

} // namespace
} // namespace tractus::lines
