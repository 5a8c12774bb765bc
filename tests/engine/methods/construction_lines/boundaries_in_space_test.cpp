#include "engine/methods/construction_lines/around_stem.h"
#include "engine/methods/construction_lines/recognise_line.h"
#include "tests/engine/methods/construction_lines/drawn_sketch.h"

// Tests of boundaries drawn while the surface moves, given in sketches and drawn by pen.

namespace tractus::lines {
namespace {

using Kind = Pattern::Kind;

// Returns a curved boundary in front of the stem of hand_sketch(), or behind it.
std::vector<Vec3> bow_in_depth(double far_mm)
{
    std::vector<Vec3> points;
    for (int i = 0; i <= 40; ++i) {
        double const v = 5.0 * i;
        points.emplace_back(0, v + 4, far_mm * (0.3 + 0.7 * std::sin(radians(0.9 * v))));
    }
    return points;
}

LineSketch with_depth()
{
    auto sketch = hand_sketch();
    sketch.around = { bow_in_depth(60), bow_in_depth(-35) };
    return sketch;
}

std::vector<std::string> texts_of(LineSketch const& sketch, Pattern const& pattern = {})
{
    auto const model = write_model(measured(sketch), pattern, "plant");
    std::vector<std::string> texts { model.source.text, model.source.view_text };
    for (auto const& [name, text] : model.functions) {
        texts.push_back(name);
        texts.push_back(text);
    }
    return texts;
}

// A stem that comes towards the viewer, with a boundary on each side that follows it, is the case
// of the paper.
TEST(BoundariesInSpace, OnTheLeftAndTheRightAreThePapersCase)
{
    auto const deep
        = [](double u, double v) { return Vec3(u, v, 40 * std::sin(radians(0.8 * v))); };
    LineSketch flat = hand_sketch();
    flat.stem.clear();
    flat.left.clear();
    flat.right.clear();
    LineSketch in_space = flat;
    in_space.around.resize(2);
    for (int v = 0; v <= 250; v += 2) {
        if (v <= 200)
            flat.stem.push_back(deep(0, v));
        flat.left.emplace_back(-50, v);
        flat.right.emplace_back(30, v);
        in_space.around[0].push_back(deep(30, v));
        in_space.around[1].push_back(deep(-50, v));
    }
    in_space.stem = flat.stem;
    for (auto const kind : { Kind::Distichous, Kind::Decussate, Kind::Spiral })
        EXPECT_EQ(texts_of(in_space, { .kind = kind }), texts_of(flat, { .kind = kind }));
}

TEST(BoundariesInSpace, KeepTheSidesOfTheSheet)
{
    auto const flat = measured(hand_sketch());
    auto const deep = measured(with_depth());
    ASSERT_EQ(deep.around.size(), 4U);
    EXPECT_EQ(deep.around[0].azimuth_deg, 0);
    EXPECT_NEAR(deep.around[1].azimuth_deg, 90, 1e-9);
    EXPECT_EQ(deep.around[2].azimuth_deg, 180);
    EXPECT_NEAR(deep.around[3].azimuth_deg, 270, 1e-9);
    for (std::size_t i = 0; i < flat.nodes.size(); ++i) {
        EXPECT_NEAR(deep.nodes[i].left_size, flat.nodes[i].left_size, 1e-12);
        EXPECT_NEAR(deep.nodes[i].right_size, flat.nodes[i].right_size, 1e-12);
        EXPECT_EQ(deep.nodes[i].left_deg, flat.nodes[i].left_deg);
    }
    // Boundaries in front and behind must not change the organs on the left and right, nor the text
    // of their functions.
    EXPECT_EQ(texts_of(with_depth()), texts_of(hand_sketch()));
    EXPECT_EQ(write_model(deep, { .kind = Kind::Spiral }, "plant").functions.size(), 11U);
}

// The tip of each organ in front of the stem or behind it must lie on the boundary drawn there.
TEST(BoundariesInSpace, OrganTipsLieOnThem)
{
    auto const sketch = with_depth();
    auto const tips = tips_of(sketch, { .kind = Kind::Decussate });
    ASSERT_EQ(tips.size(), 10U);
    for (std::size_t i : { 2U, 3U, 6U, 7U }) {
        auto const& line = sketch.around[tips[i].z() > 0 ? 0 : 1];
        std::vector<Vec2> from_the_side;
        for (auto const& point : line)
            from_the_side.emplace_back(point.z(), point.y());
        EXPECT_LT(distance_mm(Vec3(tips[i].z(), tips[i].y(), 0), from_the_side), 0.002 * 200) << i;
    }
}

TEST(BoundariesInSpace, AMirroredSketchGivesTheMirroredPlant)
{
    auto sketch = bent_sketch();
    sketch.around = { bow_in_depth(50) };
    for (auto& point : sketch.around[0])
        point.x() += 20 - 0.15 * point.y();
    auto const tips = tips_of(sketch, { .kind = Kind::Whorled, .whorl = 4 });
    auto const others = tips_of(mirrored(sketch), { .kind = Kind::Whorled, .whorl = 4 });
    ASSERT_EQ(tips.size(), others.size());
    for (auto const& tip : tips) {
        double min_mm = 1e9;
        for (auto const& other : others)
            min_mm = std::min(min_mm, (tip - Vec3(-other.x(), other.y(), other.z())).norm());
        EXPECT_LT(min_mm, 2e-2);
    }
}

TEST(BoundariesInSpace, MayBeTheOnlyOnes)
{
    auto sketch = hand_sketch();
    sketch.left.clear();
    sketch.right.clear();
    sketch.around = { { Vec3(0, 0, 30), Vec3(0, 300, 30) } };
    auto const construction = measured(sketch);
    for (int t = 0; t < 360; t += 20)
        EXPECT_NEAR(size_at(construction, 4, t), 0.15, 1e-9) << "as far all around";
    EXPECT_TRUE(construction.notes.empty());
}

TEST(BoundariesInSpace, AStemIsSaidToHaveAMissingSideOnlyWhereNoneIsNear)
{
    auto sketch = with_depth();
    sketch.right.clear();
    auto const mirrored = measured(sketch);
    EXPECT_EQ(mirrored.notes,
              std::vector<std::string> {
                  "the right boundary is missing: it is the other one, mirrored" });
    sketch.around.push_back({ Vec3(30, 0, 20), Vec3(30, 300, 20) });
    EXPECT_TRUE(measured(sketch).notes.empty());
}

TEST(BoundariesInSpace, SaysWhatIsWrongWithThem)
{
    auto sketch = with_depth();
    sketch.around.push_back({ Vec3(0, 0, 40), Vec3(1, 200, 44) });
    EXPECT_EQ(refusal(sketch),
              "two boundaries are on the same side of the stem, 270 degrees around it from its "
              "left: leave one of them out");
    sketch = with_depth();
    sketch.around = { { Vec3(0, 0, 0), Vec3(0, 200, 0) } };
    EXPECT_EQ(refusal(sketch),
              "boundary 1 in space goes along the stem or around it: draw it on one side of the "
              "stem");
    sketch.around = { { Vec3(0, 195, -60), Vec3(0, 199, -60) } };
    EXPECT_EQ(refusal(sketch),
              "no organ 90 degrees around the stem from its left meets the boundary there: draw "
              "the boundary where the inclination lines point");
}

// The plant has two stems, one of which has boundaries in space.
TEST(BoundariesInSpace, StandAroundTheStemThatTheyBelongTo)
{
    auto second = with_depth();
    for (auto& point : second.stem)
        point.x() += 150;
    for (auto* const boundary : { &second.left, &second.right })
        for (auto& point : *boundary)
            point.x() += 150;
    for (auto& line : second.inclinations)
        for (auto& point : line)
            point.x() += 150;
    for (auto& line : second.around)
        for (auto& point : line)
            point.x() += 150;
    Pattern const pattern { .kind = Kind::Spiral };
    auto const stems = measure_stems({ { .sketch = hand_sketch() }, { .sketch = second } }).value();
    auto const tips
        = organ_tips(stems[0].construction, grown(write_model(stems, pattern, "plant")));
    auto const alone = tips_of(with_depth(), pattern);
    ASSERT_EQ(tips.size(), 10U);
    for (std::size_t i = 0; i < 5; ++i)
        EXPECT_NEAR((tips[5 + i] - alone[i] - Vec3(150, 0, 0)).norm(), 0, 0.01) << i;
    auto const flat
        = tips_of(hand_sketch(), { .kind = Kind::Spiral, .sizes = Pattern::Sizes::HalfEllipses });
    for (std::size_t i = 0; i < 5; ++i)
        EXPECT_NEAR((tips[i] - flat[i]).norm(), 0, 0.01) << i;
}

// With only two boundaries, in the sheet, the pattern decides how sizes change between them.
TEST(BoundariesInSpace, SizesMayFollowHalfEllipsesWithoutThem)
{
    Pattern const linear { .kind = Kind::Decussate };
    Pattern const round { .kind = Kind::Decussate, .sizes = Pattern::Sizes::HalfEllipses };
    auto const tips = tips_of(hand_sketch(), linear);
    auto const others = tips_of(hand_sketch(), round);
    for (std::size_t i = 0; i < tips.size(); ++i)
        EXPECT_NEAR((tips[i] - others[i]).norm(), 0, 1e-2) << "the mean in front and behind";
    auto const spiral = tips_of(
        hand_sketch(),
        { .kind = Kind::Spiral, .divergence_deg = 45, .sizes = Pattern::Sizes::HalfEllipses });
    // Node 1 is at an eighth of a full turn, between the sizes 0.300672 and 0.180403.
    double const size = size_between({ 0.300672, 0.180403, 180 }, 0.25);
    EXPECT_NEAR((spiral[1] - Vec3(0, 70, 0)).norm() / 200, size, 1e-4);
}

TEST(BoundariesInSpace, AreTakenForWhatTheyAreWhereTheirDepthCounts)
{
    using enum LineRecogniser::Lies;
    LineRecogniser recogniser;
    recogniser.add(line({ Vec2(0, 0), Vec2(0, 200) }));
    auto const front = bow_in_depth(60);
    EXPECT_EQ(recogniser.recognised(front).role, Role::Stem) << "as it is seen, drawn again";
    EXPECT_EQ(recogniser.add(front, InSpace).role, Role::Around);
    EXPECT_EQ(recogniser.lines().back().replaces, std::nullopt);
    EXPECT_EQ(recogniser.add(bow_in_depth(-40), InSpace).replaces, std::nullopt);
    EXPECT_EQ(recogniser.add(bow_in_depth(45), InSpace).replaces, 1U);
    EXPECT_EQ(recogniser.sketch().around.size(), 2U);
    // On the left, a boundary in space replaces one in the sheet, and the other way round.
    EXPECT_EQ(recogniser.add(line({ Vec2(-50, 0), Vec2(-50, 200) })).role, Role::Left);
    std::vector<Vec3> const left { Vec3(-40, 0, 0), Vec3(-45, 200, 25) };
    EXPECT_EQ(recogniser.add(left, InSpace).replaces, 4U);
    EXPECT_EQ(recogniser.add(line({ Vec2(-55, 0), Vec2(-60, 200) })).replaces, 5U);
    // A line that crosses the stem is an inclination line, whatever its depth is.
    EXPECT_EQ(
        recogniser.add({ Vec3(-60, 100, 0), Vec3(0, 80, 40), Vec3(60, 100, 0) }, InSpace).role,
        Role::Inclination);
    // The stem is redrawn in its place.
    EXPECT_EQ(recogniser.add({ Vec3(1, 0, 0), Vec3(0, 200, 11) }, InSpace).role, Role::Stem);
}

// Returns a stroke drawn by pen in front of a stem of 120 mm. The middle of the tablet is (0, 0).
Stroke in_front(double far_mm)
{
    return pen_stroke(
        { { 1, -58, 0 }, { -1, -30, 0.7 * far_mm }, { 1, 20, far_mm }, { 0, 62, 0.2 * far_mm } });
}

AddLine drawn_in_space(Drawing const& drawing, Stroke const& stroke,
                       DepthBy depth_by = DepthBy::Height)
{
    return { .plant = drawing.plant(), .stroke = stroke, .depth_by = depth_by, .nodes = 5 };
}

TEST(BoundariesInSpace, AreDrawnWhileTheSurfaceMoves)
{
    auto drawing = whole_sketch();
    drawing.apply(drawn_in_space(drawing, in_front(40)));
    EXPECT_EQ(drawing.newest_role(), Role::Around);
    EXPECT_EQ(describe_result(drawing.sketch()),
              "This is a boundary in space, in front, 270 degrees around the stem");
    drawing.apply(drawn_in_space(drawing, in_front(-30)));
    auto const construction = measured(line_sketch(drawing.sketch()).value());
    ASSERT_EQ(construction.around.size(), 4U);
    EXPECT_NEAR(construction.around[1].azimuth_deg, 90, 3);
    EXPECT_NEAR(construction.around[3].azimuth_deg, 270, 3);
    EXPECT_NEAR(construction.around[3].sizes[2] / construction.around[1].sizes[2], 4.0 / 3, 0.05);
    EXPECT_EQ(drawing.organs(), 6U);
    // The role of the line can be changed and changed back, as for any line.
    auto const back = drawing.sketch().lines.back().id;
    drawing.apply(SetLineRole { drawing.plant(), back, Role::Unsure });
    EXPECT_EQ(line_sketch(drawing.sketch())->around.size(), 1U);
    drawing.apply(SetLineRole { drawing.plant(), back, Role::Around });
    EXPECT_EQ(line_sketch(drawing.sketch())->around.size(), 2U);
}

// Older sessions ignore depth: their lines lie on the sheet.
TEST(BoundariesInSpace, LieOnTheSheetWhereTheirDepthDoesNotCount)
{
    auto flat = whole_sketch();
    auto deep = whole_sketch();
    flat.draw(pen_stroke({ { -45, -60, 0 }, { -32, 70, 0 } }));
    deep.draw(pen_stroke({ { -45, -60, 0 }, { -32, 70, 40 } }));
    EXPECT_EQ(deep.newest_role(), Role::Left);
    EXPECT_EQ(model_of(deep.sketch())->functions, model_of(flat.sketch())->functions);
    auto still = whole_sketch();
    still.apply(drawn_in_space(still, pen_stroke({ { -45, -60, 2 }, { -32, 70, 6 } })));
    EXPECT_EQ(still.newest_role(), Role::Left) << "the surface has hardly moved";
    EXPECT_EQ(model_of(still.sketch())->functions, model_of(flat.sketch())->functions);
}

TEST(BoundariesInSpace, GoAlongWithAStemThatIsDrawnAgainAtAnotherHeight)
{
    auto drawing = whole_sketch();
    drawing.apply(drawn_in_space(drawing, in_front(40)));
    auto const before = line_sketch(drawing.sketch())->around.at(0);
    drawing.draw(pen_stroke({ { 0, -60, 25 }, { 0, 60, 25 } }));
    EXPECT_EQ(drawing.newest_role(), Role::Stem);
    auto const after = line_sketch(drawing.sketch())->around.at(0);
    EXPECT_NEAR(after[20].z(), before[20].z() - 25, 0.01) << "the stem is nearer to it now";
}

// Along the stem of 120 mm, the pen's pressure rises from a quarter to three quarters of its range.
TEST(DepthByPressure, BringsTheStemTowardsTheViewer)
{
    auto stroke = stem();
    auto tips = stroke.tips.vector();
    for (std::size_t i = 0; i < tips.size(); ++i)
        tips[i].pressure = 0.25 + 0.5 * (tips[i].position_mm.y() + 60) / 120;
    tips.front().pressure = 0; // The first sample, in which the pen touches.
    tips.back().pressure = 0;  // The last sample, in which the pen is lifted.
    stroke.tips = SharedVector<TipSample>(std::move(tips));
    Drawing drawing;
    drawing.apply(AddLine { .stroke = stroke, .depth_by = DepthBy::Pressure });
    auto const points = line_sketch(drawing.sketch())->stem;
    EXPECT_NEAR(points.front().z(), 0, 1);
    EXPECT_NEAR(points.back().z(), 0.5 * 0.5 * 120 * 0.9, 2);
    for (auto const& point : points)
        if (std::fabs(point.y()) < 50)
            EXPECT_NEAR(point.z(), 0.5 * 0.5 * (point.y() + 60 - 0.05 * 120), 1) << point.y();
    Drawing by_height;
    by_height.apply(AddLine { .stroke = stroke, .depth_by = DepthBy::Height });
    EXPECT_EQ(line_sketch(by_height.sketch())->stem.back().z(), 0);
}

} // namespace
} // namespace tractus::lines
