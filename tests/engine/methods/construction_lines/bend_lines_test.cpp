#include "engine/methods/construction_lines/bend_lines.h"

#include "tests/engine/methods/construction_lines/drawn_sketch.h"

#include <rapidcheck/gtest.h>

namespace tractus::lines {
namespace {

PenSketch after(Drawing const& drawing, BentLine const& bent)
{
    auto changed = drawing;
    changed.apply(RedrawLine { drawing.plant(), bent.line, bent.stroke });
    return changed.sketch();
}

double angle(Construction const& of, std::size_t line, StemSide side)
{
    auto const& inclination = of.inclinations[line];
    return side == StemSide::Left ? inclination.left_deg : inclination.right_deg;
}

double size(Construction const& of, double x, StemSide side)
{
    auto const values = values_at(of, x);
    return side == StemSide::Left ? values.left_size : values.right_size;
}

StemSide other(StemSide side)
{
    return side == StemSide::Left ? StemSide::Right : StemSide::Left;
}

// Only one half of the inclination line may be rotated. Its other half, the other line and the
// boundaries must stay.
RC_GTEST_PROP(WithAngle, TurnsOneHalfOfOneLine, ())
{
    static auto const drawing = whole_sketch();
    auto const before = construction_of(drawing.sketch()).value();
    auto const line = *rc::gen::inRange<std::size_t>(0, 2);
    auto const side = *rc::gen::element(StemSide::Left, StemSide::Right);
    double const wanted_deg = *rc::gen::inRange(30, 110);
    auto const bent = with_angle(drawing.sketch(), line, side, wanted_deg);
    RC_ASSERT(bent.has_value());
    auto const sketch = after(drawing, *bent);
    auto const now = construction_of(sketch).value();
    RC_ASSERT(std::fabs(angle(now, line, side) - wanted_deg) < 0.05);
    RC_ASSERT(std::fabs(angle(now, line, other(side)) - angle(before, line, other(side))) < 1);
    for (auto const each : { StemSide::Left, StemSide::Right })
        RC_ASSERT(angle(now, 1 - line, each) == angle(before, 1 - line, each));
    RC_ASSERT(std::fabs(now.inclinations[line].x - before.inclinations[line].x) < 0.005);
    RC_ASSERT(sketch.lines.size() == drawing.sketch().lines.size());
}

// At the given position, the boundary must reach the requested size along the ray. Beyond the
// neighbouring positions it must not change.
RC_GTEST_PROP(WithSize, MovesTheBoundaryThereAlone, ())
{
    static auto const drawing = whole_sketch();
    auto const before = construction_of(drawing.sketch()).value();
    auto const places = size_places(before);
    RC_ASSERT(places.size() == 3u);
    auto const place = *rc::gen::inRange<std::size_t>(0, 3);
    auto const side = *rc::gen::element(StemSide::Left, StemSide::Right);
    double const wanted = size(before, places[place], side) * *rc::gen::inRange(80, 125) / 100.0;
    auto const bent = with_size(drawing.sketch(), place, side, wanted);
    RC_ASSERT(bent.has_value());
    auto const now = construction_of(after(drawing, *bent)).value();
    RC_ASSERT(std::fabs(size(now, places[place], side) - wanted) < 0.002);
    for (std::size_t i = 0; i < places.size(); ++i) {
        RC_ASSERT(size(now, places[i], other(side)) == size(before, places[i], other(side)));
        if (i != place) {
            RC_ASSERT(std::fabs(size(now, places[i], side) - size(before, places[i], side)) < 0.02);
        }
    }
}

TEST(BendLines, KeepWhatIsAsWanted)
{
    auto const drawing = whole_sketch();
    auto const of = construction_of(drawing.sketch()).value();
    auto const bent
        = with_angle(drawing.sketch(), 0, StemSide::Left, of.inclinations[0].left_deg).value();
    EXPECT_EQ(bent.stroke.tips.vector().size(), low_line().tips.size());
    EXPECT_EQ(bent.stroke.tips[3].position_mm, low_line().tips[3].position_mm);
}

TEST(BendLines, MoveTheOnlyBoundaryForBothSides)
{
    Drawing drawing;
    for (auto const& stroke : { stem(), left_boundary(), low_line(), high_line() })
        drawing.draw(stroke);
    auto const before = construction_of(drawing.sketch()).value();
    double const x = size_places(before)[0];
    double const wanted = 1.1 * size(before, x, StemSide::Left);
    auto const bent = with_size(drawing.sketch(), 0, StemSide::Right, wanted).value();
    auto const now = construction_of(after(drawing, bent)).value();
    EXPECT_NEAR(size(now, x, StemSide::Left), wanted, 0.002);
}

TEST(BendLines, RefuseWhatIsNotThere)
{
    Drawing drawing;
    for (auto const& stroke : { stem(), left_boundary(), low_line() })
        drawing.draw(stroke);
    auto const& sketch = drawing.sketch();
    EXPECT_FALSE(with_angle(sketch, 0, StemSide::Left, 60)) << "one line holds all along the stem";
    EXPECT_FALSE(with_angle(sketch, 7, StemSide::Left, 60));
    EXPECT_FALSE(with_size(sketch, 99, StemSide::Left, 0.5));
    for (double const size : { 0.0, -1.0, 3.0, std::nan("") })
        EXPECT_FALSE(with_size(sketch, 0, StemSide::Left, size));
    for (double const angle_deg : { 0.0, 180.0, std::nan("") })
        EXPECT_FALSE(with_angle(whole_sketch().sketch(), 0, StemSide::Left, angle_deg));
    EXPECT_NE(drawing.refusal(RedrawLine { drawing.plant(), 12345, low_line() }), "it is done");
    EXPECT_NE(drawing.refusal(RedrawLine { drawing.plant(), sketch.lines[0].id, {} }),
              "it is done");
}

} // namespace
} // namespace tractus::lines
