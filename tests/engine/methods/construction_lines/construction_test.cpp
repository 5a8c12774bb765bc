#include "engine/methods/construction_lines/construction.h"

#include "tests/engine/methods/construction_lines/sketches.h"

namespace tractus::lines {
namespace {

// The expected values were computed by hand. The rays make angles of 45 to 90 degrees with the
// stem, and the boundaries are at 0.25 and 0.15 of the stem's length.
TEST(Construction, MeasuresASketchAsComputedByHand)
{
    auto const result = measured(hand_sketch());
    EXPECT_DOUBLE_EQ(result.stem.length_mm(), 200);
    EXPECT_DOUBLE_EQ(result.below(), 0.2);
    EXPECT_DOUBLE_EQ(result.above(), 1 - 0.8);
    ASSERT_EQ(result.nodes.size(), 5U);
    for (std::size_t i = 0; i < 5; ++i) {
        auto const& node = result.nodes[i];
        double const angle_deg = 45 + 11.25 * static_cast<double>(i);
        EXPECT_NEAR(node.x, 0.2 + 0.15 * static_cast<double>(i), 1e-12);
        EXPECT_NEAR(node.left_deg, angle_deg, 1e-9);
        EXPECT_NEAR(node.right_deg, angle_deg, 1e-9);
        EXPECT_NEAR(node.left_size, 0.25 / std::sin(radians(angle_deg)), 1e-12);
        EXPECT_NEAR(node.right_size, 0.15 / std::sin(radians(angle_deg)), 1e-12);
    }
    EXPECT_TRUE(result.notes.empty());
}

TEST(Construction, FunctionsAreLinearBetweenNodesAndConstantBeyond)
{
    auto const result = measured(hand_sketch());
    EXPECT_DOUBLE_EQ(values_at(result, 0).left_deg, 45);
    EXPECT_DOUBLE_EQ(values_at(result, 1).left_deg, 90);
    EXPECT_NEAR(values_at(result, 0.275).left_deg, 50.625, 1e-9);
    EXPECT_NEAR(values_at(result, 0.275).right_size, (0.212132034 + 0.180403) / 2, 1e-6);
    EXPECT_DOUBLE_EQ(values_at(result, 0.5).heading_deg, 0);
}

// The stem and the boundaries are arcs with the same centre. So every reach is the distance between
// two circles.
TEST(Construction, ReachesFromABentStemAreTheGaps)
{
    auto const ring = [](double radius_mm) {
        std::vector<Vec2> points;
        for (int i = -200; i <= 1100; ++i)
            points.emplace_back(100 - radius_mm * std::cos(radians(i / 10.0)),
                                radius_mm * std::sin(radians(i / 10.0)));
        return points;
    };
    auto const ray = [](double angle_deg) {
        std::vector<Vec2> points;
        for (double const radius_mm : { 140, 60 })
            points.emplace_back(100 - radius_mm * std::cos(radians(angle_deg)),
                                radius_mm * std::sin(radians(angle_deg)));
        return points;
    };
    auto const result = measured({ .stem = arc(100, 90, 400),
                                   .left = ring(125),
                                   .right = ring(85),
                                   .inclinations = { ray(20), ray(70) },
                                   .nodes_per_layer = { 5 } });
    for (auto const& node : result.nodes) {
        EXPECT_NEAR(node.left_deg, 90, 1e-3);
        EXPECT_NEAR(node.left_size * result.stem.length_mm(), 25, 1e-3);
        EXPECT_NEAR(node.right_size * result.stem.length_mm(), 15, 1e-3);
    }
}

TEST(Construction, ALayerWithoutNodesStaysBare)
{
    auto sketch = hand_sketch();
    sketch.inclinations.push_back({ Vec2(-60, 100), Vec2(40, 100) });
    sketch.nodes_per_layer = { 0, 2 };
    auto const result = measured(sketch);
    ASSERT_EQ(result.nodes.size(), 3U);
    EXPECT_NEAR(result.nodes[0].x, 0.5, 1e-12);
    EXPECT_NEAR(result.nodes[2].x, 0.8, 1e-12);
}

TEST(Construction, AMissingBoundaryIsTheOtherOneMirrored)
{
    auto sketch = hand_sketch();
    sketch.right.clear();
    auto const result = measured(sketch);
    ASSERT_EQ(result.notes.size(), 1U);
    EXPECT_EQ(result.notes[0], "the right boundary is missing: it is the other one, mirrored");
    for (auto const& node : result.nodes)
        EXPECT_NEAR(node.right_size, node.left_size, 1e-12);
}

TEST(Construction, WithoutInclinationLinesOrgansStandAtHalfARightAngle)
{
    auto sketch = hand_sketch();
    sketch.inclinations.clear();
    auto const result = measured(sketch);
    EXPECT_EQ(result.notes.size(), 1U);
    EXPECT_DOUBLE_EQ(result.below(), 0.1);
    EXPECT_DOUBLE_EQ(result.nodes.back().x, 0.95);
    EXPECT_DOUBLE_EQ(result.nodes[2].left_deg, 45);
}

TEST(Construction, HalfAnInclinationLineCountsOnBothSides)
{
    auto sketch = hand_sketch();
    sketch.inclinations[0] = { Vec2(-60, 100), Vec2(0, 40) };
    auto const result = measured(sketch);
    EXPECT_NEAR(result.inclinations[0].right_deg, 45, 1e-9);
    ASSERT_EQ(result.notes.size(), 1U);
    EXPECT_EQ(result.notes[0],
              "inclination line 1 has no half on the right: the other half counts on both sides");
}

TEST(Construction, OrgansThatMissTheBoundaryAreAsLongAsTheirNeighbours)
{
    auto sketch = hand_sketch();
    sketch.left = { Vec2(-50, 60), Vec2(-50, 140) };
    sketch.nodes_per_layer = { 8 };
    auto const result = measured(sketch);
    EXPECT_EQ(result.nodes[0].left_size, result.nodes[0].left_size);
    EXPECT_DOUBLE_EQ(result.nodes[8].left_size, result.nodes[6].left_size);
    ASSERT_EQ(result.notes.size(), 1U);
    EXPECT_EQ(result.notes[0],
              "2 of 9 organs on the left miss the boundary: they are as long as "
              "their neighbours");
}

TEST(Construction, SaysWhatIsMissing)
{
    LineSketch sketch;
    EXPECT_EQ(refusal(sketch),
              "the stem is missing or only a dot: draw it from the plant's foot "
              "to its top, as the first line");
    sketch.stem = hand_sketch().stem;
    EXPECT_EQ(refusal(sketch),
              "there is no boundary: draw the line that the organs' tips reach, "
              "on the left and on the right of the stem");
    sketch = hand_sketch();
    sketch.left = { Vec2(3, 3), Vec2(3, 3) };
    EXPECT_EQ(refusal(sketch),
              "the left boundary is missing or only a dot: draw the line that the "
              "organs' tips reach on this side");
    sketch = hand_sketch();
    sketch.inclinations.pop_back();
    EXPECT_EQ(refusal(sketch),
              "there is only one inclination line: draw a second one across the "
              "stem, below or above it");
}

TEST(Construction, SaysWhichInclinationLineIsWrong)
{
    auto sketch = hand_sketch();
    sketch.inclinations[1] = { Vec2(-60, 260), Vec2(40, 260) };
    EXPECT_EQ(refusal(sketch),
              "inclination line 2 does not cross the stem: draw it across the stem");
    sketch.inclinations[1] = { Vec2(-60, 160), Vec2(9, 160), Vec2(-9, 170), Vec2(40, 180) };
    EXPECT_EQ(refusal(sketch),
              "inclination line 2 crosses the stem 3 times: draw it so that it crosses once");
    sketch.inclinations[1] = sketch.inclinations[0];
    EXPECT_EQ(refusal(sketch),
              "inclination lines 1 and 2 from below cross the stem at the same "
              "place: draw them apart");
}

TEST(Construction, SaysThatBoundariesAreExchanged)
{
    auto sketch = hand_sketch();
    std::swap(sketch.left, sketch.right);
    EXPECT_EQ(refusal(sketch),
              "inclination line 1 meets the left boundary on the right of the "
              "stem: exchange the boundaries, or draw the stem from its foot to "
              "its top");
    sketch = hand_sketch();
    std::swap(sketch.stem[0], sketch.stem[1]);
    EXPECT_NE(refusal(sketch).find("draw the stem from its foot"), std::string::npos);
}

TEST(Construction, SaysThatABoundaryIsOutOfReach)
{
    auto sketch = hand_sketch();
    sketch.left = { Vec2(-50, -300), Vec2(-50, -200) };
    EXPECT_EQ(refusal(sketch),
              "no organ on the left meets the left boundary: draw the boundary "
              "where the inclination lines point");
}

TEST(Construction, ChecksNumbersOfNodes)
{
    auto sketch = hand_sketch();
    sketch.nodes_per_layer = { 4, 2 };
    EXPECT_EQ(refusal(sketch),
              "the inclination lines have 1 layer between them, but there are "
              "numbers of nodes for 2: give one number for each layer");
    sketch.nodes_per_layer = { 501 };
    EXPECT_EQ(refusal(sketch), "layer 1 is to have 501 nodes: give 0 to 500");
    sketch.nodes_per_layer = { -1 };
    EXPECT_EQ(refusal(sketch), "layer 1 is to have -1 nodes: give 0 to 500");
    sketch.inclinations.clear();
    for (int i = 0; i < 30; ++i)
        sketch.inclinations.push_back({ Vec2(-60, 5 + 6 * i), Vec2(60, 5 + 6 * i) });
    sketch.nodes_per_layer.assign(29, 500);
    EXPECT_EQ(refusal(sketch), "the layers have 14501 nodes together: give at most 10000");
}

TEST(Construction, RefusesWhatIsNoSketchAtAll)
{
    auto sketch = hand_sketch();
    sketch.stem[1].y() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(refusal(sketch),
              "the stem has a point that is farther than 100000 mm away: give its "
              "points in millimetres");
    sketch = hand_sketch();
    sketch.left.assign(kMaxPoints + 1, Vec2(-50, 0));
    EXPECT_EQ(refusal(sketch).substr(0, 60),
              "the sketch's lines have 20011 points together, more than 200");
}

// The stem crosses itself. An inclination line there must belong to the part of the stem near the
// line's own middle.
TEST(Construction, AStemMayCrossItself)
{
    LineSketch const sketch { .stem = { Vec3(0, 0, 0), Vec3(0, 100, 0), Vec3(30, 100, 0),
                                        Vec3(30, 50, 0), Vec3(-10, 50, 0), Vec3(-10, 200, 0) },
                              .left = { Vec2(-90, -10), Vec2(-90, 300) },
                              .right = { Vec2(90, -10), Vec2(90, 300) },
                              .inclinations = { { Vec2(-80, 20), Vec2(80, 20) },
                                                { Vec2(-82, 80), Vec2(80, 80) } },
                              .nodes_per_layer = { 3 } };
    auto const result = measured(sketch);
    EXPECT_NEAR(result.inclinations[1].x * result.stem.length_mm(), 80, 1e-9);
}

} // namespace
} // namespace tractus::lines
