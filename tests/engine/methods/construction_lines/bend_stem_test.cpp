#include "engine/methods/construction_lines/bend_lines.h"
#include "tests/engine/methods/construction_lines/drawn_sketch.h"

namespace tractus::lines {
namespace {

double heading_at(PenSketch const& sketch, double x)
{
    auto const of = construction_of(sketch);
    EXPECT_TRUE(of) << of.error().message;
    return of ? values_at(*of, x).heading_deg : 0;
}

TEST(WithHeading, BendsTheStemThereAndNotAtTheNextPlaces)
{
    auto const sketch = whole_sketch().sketch();
    auto const stem = first_stem(sketch).id;
    for (std::size_t place = 0; place < kHeadingPlaces.size(); ++place)
        for (double const wanted_deg : { -50.0, 20.0 }) {
            auto const bent = with_heading(sketch, stem, place, wanted_deg);
            ASSERT_TRUE(bent) << bent.error().message;
            for (std::size_t at = 0; at < kHeadingPlaces.size(); ++at)
                EXPECT_NEAR(heading_at(*bent, kHeadingPlaces[at]), at == place ? wanted_deg : 0,
                            0.5)
                    << place << " " << at;
            EXPECT_NEAR(construction_of(*bent)->stem.length_mm(), 120, 0.1);
            auto const stem_line = line_sketch(*bent)->stem;
            EXPECT_NEAR((stem_line.front() - Vec3(0, -60, 0)).norm(), 0, 0.05) << "its foot stays";
        }
}

// When the stem is bent, its inclination lines must keep their positions and angles on the stem.
TEST(WithHeading, TakesTheStemsLinesAlong)
{
    auto const sketch = whole_sketch().sketch();
    auto const before = construction_of(sketch).value();
    auto const bent = with_heading(sketch, first_stem(sketch).id, 1, 25).value();
    auto const after = construction_of(bent).value();
    ASSERT_EQ(after.inclinations.size(), before.inclinations.size());
    for (std::size_t i = 0; i < before.inclinations.size(); ++i) {
        EXPECT_NEAR(after.inclinations[i].x, before.inclinations[i].x, 0.01) << i;
        EXPECT_NEAR(after.inclinations[i].left_deg, before.inclinations[i].left_deg, 3) << i;
        EXPECT_NEAR(after.inclinations[i].right_deg, before.inclinations[i].right_deg, 3) << i;
    }
    ASSERT_EQ(after.nodes.size(), before.nodes.size());
    for (std::size_t i = 0; i < before.nodes.size(); ++i)
        EXPECT_NEAR(after.nodes[i].left_size, before.nodes[i].left_size, 0.03) << i;
}

TEST(WithHeading, TakesStemsAlongThatStandOnIt)
{
    auto drawing = whole_sketch();
    auto const add_stem = [&](std::vector<Vec3> const& corners) {
        drawing.apply(AddLine {
            .plant = drawing.plant(), .stroke = pen_stroke(corners), .another_stem = true });
    };
    add_stem({ { 0, 0, 0 }, { 60, 40, 0 } });
    add_stem({ { 90, -60, 0 }, { 90, 20, 0 } });
    auto const stems_of = [](PenSketch const& sketch) {
        return measure_stems(stem_sketches(sketch).value(), Missing::Guessed).value();
    };
    auto const before = stems_of(drawing.sketch());
    drawing.apply(BendStem { drawing.plant(), first_stem(drawing.sketch()).id, 1, 30 });
    auto const after = stems_of(drawing.sketch());
    EXPECT_NEAR(after[1].foot_x, before[1].foot_x, 0.003);
    auto const leans_deg = [](std::vector<MeasuredStem> const& stems) {
        return stems[1].construction.stem.heading_deg(0.5)
            - stems[0].construction.stem.heading_deg(stems[1].foot_x);
    };
    EXPECT_NEAR(leans_deg(after), leans_deg(before), 1) << "to the stem that bears it";
    EXPECT_NEAR(after[1].construction.stem.length_mm(), before[1].construction.stem.length_mm(),
                0.1);
    EXPECT_EQ(after[2].construction.stem.point(1), before[2].construction.stem.point(1));
}

TEST(WithHeading, RefusesWhatIsNoStem)
{
    auto const sketch = whole_sketch().sketch();
    EXPECT_FALSE(with_heading(sketch, sketch.lines.back().id, 0, 10));
    EXPECT_FALSE(with_heading(sketch, 999, 0, 10));
    EXPECT_FALSE(with_heading(sketch, first_stem(sketch).id, kHeadingPlaces.size(), 10));
    auto const far = with_heading(sketch, first_stem(sketch).id, 0, 91);
    ASSERT_FALSE(far);
    EXPECT_EQ(far.error().message, "a direction of 91 is out of range: -90 to 90 are possible");
}

} // namespace
} // namespace tractus::lines
