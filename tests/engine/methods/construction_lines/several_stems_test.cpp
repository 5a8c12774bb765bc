#include "engine/methods/construction_lines/several_stems.h"

#include "engine/lsystem/language/print.h"
#include "tests/engine/methods/construction_lines/sketches.h"

#include <Eigen/Geometry>

namespace tractus::lines {
namespace {

// Returns a line on the sheet with the given beginning, initial heading and length, and with
// constant curvature.
std::vector<Vec3> bow(Vec2 from_mm, double heading_deg, double turn_deg, double length_mm)
{
    constexpr int kPieces = 100;
    std::vector<Vec3> points { Vec3(from_mm.x(), from_mm.y(), 0) };
    for (int i = 0; i < kPieces; ++i) {
        from_mm += length_mm / kPieces * direction(heading_deg + turn_deg * (i + 0.5) / kPieces);
        points.emplace_back(from_mm.x(), from_mm.y(), 0);
    }
    return points;
}

StemLines alone(std::vector<Vec3> stem, std::optional<std::size_t> parent = std::nullopt)
{
    return { .sketch = { .stem = std::move(stem),
                         .left = {},
                         .right = {},
                         .inclinations = {},
                         .nodes_per_layer = {} },
             .parent = parent };
}

std::vector<MeasuredStem> measured_stems(std::vector<StemLines> const& stems)
{
    auto result = measure_stems(stems);
    EXPECT_TRUE(result) << result.error().message;
    return result ? *result : std::vector<MeasuredStem>();
}

LineModel model_of(std::vector<StemLines> const& stems, Pattern const& pattern = {})
{
    return write_model(measured_stems(stems), pattern, "plant");
}

// Base and top of an axis on the sheet, relative to the base of the sketch's first stem.
struct Ends {
    Vec3 foot_mm;
    Vec3 top_mm;
};
Ends ends_of(Plant const& plant, std::size_t axis)
{
    auto const on_sheet = [](Vec3 const& place_mm) -> Vec3 {
        return Vec3(place_mm.x(), place_mm.z(), -place_mm.y()) / 10;
    };
    auto const nodes_mm = plant.positions(plant.axes[axis]);
    return { on_sheet(nodes_mm.front()), on_sheet(nodes_mm.back()) };
}

TEST(SeveralStems, ASingleOneIsThePlantThatItWas)
{
    for (auto const& sketch : { hand_sketch(), bent_sketch(), coarse_sketch() }) {
        auto const single = write_model(measured(sketch), {}, "plant");
        auto const model = model_of({ { .sketch = sketch } });
        EXPECT_EQ(model.source.text, single.source.text);
        EXPECT_EQ(model.source.view_text, single.source.view_text);
        EXPECT_EQ(model.functions, single.functions);
    }
}

// In a clump, each stem must be a single axis where it was drawn.
TEST(SeveralStems, StandBesideEachOtherWhereTheyAreDrawn)
{
    auto const left = bow({ -60, -5 }, 20, 40, 120);
    auto const right = bow({ 70, 10 }, -10, -30, 90);
    auto const plant = grown(model_of({ { .sketch = hand_sketch() }, alone(left), alone(right) }));
    ASSERT_EQ(plant.axes.size(), 3U);
    auto const near = [](Ends const& found, std::vector<Vec3> const& drawn) {
        EXPECT_NEAR((found.foot_mm - drawn.front()).norm(), 0, 1e-3);
        EXPECT_NEAR((found.top_mm - drawn.back()).norm(), 0, 0.2);
    };
    near(ends_of(plant, 0), hand_sketch().stem);
    near(ends_of(plant, 1), left);
    near(ends_of(plant, 2), right);
    EXPECT_EQ(plant.organs.size(), 3U * 10) << "five nodes on each";
}

// A stem without lines of its own must have the organs of the stem with lines, rotated and scaled
// to its own length.
TEST(SeveralStems, WithoutLinesOfTheirOwnAreLikeTheOneThatHasThem)
{
    auto const sketch = hand_sketch();
    Vec2 const foot_mm(90, 30);
    auto const own = tips_of(sketch, {});
    for (auto const kind : { Pattern::Kind::Distichous, Pattern::Kind::Spiral }) {
        std::vector<StemLines> const stems { { .sketch = sketch },
                                             alone(bow(foot_mm, -60, 0, 100)) };
        auto const measured = measured_stems(stems);
        auto const tips = organ_tips(measured[0].construction,
                                     grown(write_model(measured, { .kind = kind }, "plant")));
        auto const half = tips.size() / 2;
        Eigen::AngleAxisd const turn(radians(-60), Vec3::UnitZ());
        for (std::size_t i = 0; i < half; ++i) {
            Vec3 const like_mm = Vec3(foot_mm.x(), foot_mm.y(), 0) + turn * (0.5 * tips[i]);
            EXPECT_NEAR((tips[half + i] - like_mm).norm(), 0, 0.02) << i;
        }
    }
    EXPECT_EQ(own.size(), 10U);
}

TEST(SeveralStems, ALateralAxisBeginsOnTheStemAndEndsWhereItIsDrawn)
{
    auto const lateral = bow({ 3, 110 }, -60, 30, 80); // The lateral begins 3 mm beside the stem.
    auto const model = model_of({ { .sketch = hand_sketch() }, alone(lateral, 0) });
    auto const plant = grown(model);
    ASSERT_EQ(plant.axes.size(), 2U);
    auto const ends = ends_of(plant, 1);
    EXPECT_NEAR((ends.foot_mm - Vec3(0, 110, 0)).norm(), 0, 1e-2);
    EXPECT_NEAR((ends.top_mm - lateral.back()).norm(), 0, 0.3);
    EXPECT_EQ(plant.organs.size(), 20U);
    // Each of the two stems has functions for heading and depth. The other five functions are
    // shared.
    EXPECT_EQ(model.functions.size(), 2U * 2 + 5);
}

TEST(SeveralStems, TwoFromItsTopAreAForkOfIt)
{
    auto const stems = measured_stems({ { .sketch = hand_sketch() },
                                        alone(bow({ 2, 198 }, 40, -20, 90), 0),
                                        alone(bow({ -1, 203 }, -40, 20, 80), 0) });
    EXPECT_EQ(stems[1].foot_x, 1);
    EXPECT_EQ(stems[2].foot_x, 1);
    auto const plant = grown(write_model(stems, {}, "plant"));
    for (std::size_t axis = 1; axis < 3; ++axis)
        EXPECT_NEAR((ends_of(plant, axis).foot_mm - Vec3(0, 200, 0)).norm(), 0, 1e-2);
    // A lateral axis must not be thicker than its parent.
    auto const radius_mm = [&](std::size_t axis, bool last) {
        auto const& of = plant.axes[axis];
        return plant.node_radius_mm[of.first_node + (last ? of.segment_count : 0)];
    };
    EXPECT_LE(radius_mm(1, false), 1.05F * radius_mm(0, true));
}

TEST(SeveralStems, ALateralMayBearOthersAndHaveLinesOfItsOwn)
{
    auto const own = [] {
        auto lines = alone(bow({ 0, 60 }, -90, 0, 100), 0);
        lines.sketch.left = { Vec2(0, 80), Vec2(100, 80) };
        lines.sketch.right = { Vec2(0, 40), Vec2(100, 40) };
        lines.sketch.nodes_per_layer = { 2 };
        return lines;
    }();
    auto const stems
        = measured_stems({ { .sketch = hand_sketch() }, own, alone(bow({ 50, 60 }, 0, 0, 40), 1) });
    EXPECT_EQ(stems[1].functions, 1U);
    EXPECT_EQ(stems[2].functions, 1U) << "its parent's, not the first one's";
    EXPECT_NEAR(stems[1].construction.nodes[0].left_size, 0.2 * std::sqrt(2.0), 1e-6);
    EXPECT_NEAR(stems[2].foot_x, 0.5, 1e-9);
    auto const model = write_model(stems, {}, "plant");
    EXPECT_EQ(model.functions.size(), 3U * 2 + 2 * 5);
    auto const plant = grown(model);
    ASSERT_EQ(plant.axes.size(), 3U);
    EXPECT_EQ(plant.organs.size(), 10U + 2 * 6);
}

// The derivation must end with the step in which the last stem has grown.
TEST(SeveralStems, EachStepAddsToThePlant)
{
    auto const model = compiled(model_of({ { .sketch = coarse_sketch() },
                                           alone(bow({ 40, 90 }, -60, 0, 90), 0),
                                           alone(bow({ 50, 190 }, 40, 0, 90), 0),
                                           alone(bow({ -90, 0 }, 0, 0, 90)) }));
    auto const after = [&](int steps) {
        lsystem::DeriveOptions options;
        options.steps = steps;
        return lsystem::to_string(model, *lsystem::derive(model, options));
    };
    EXPECT_NE(after(model.steps), after(model.steps - 1));
    EXPECT_EQ(after(model.steps), after(model.steps + 1));
    EXPECT_EQ(after(model.steps).find('A'), std::string::npos) << "no apex is left";
}

TEST(SeveralStems, StandAtTheDepthOfWhatBearsThem)
{
    auto deep = hand_sketch();
    deep.stem = { Vec3(0, 0, 0), Vec3(0, 200, 100) };
    auto const plant
        = grown(model_of({ { .sketch = deep }, alone(bow({ 0, 100 }, -90, 0, 60), 0) }));
    auto const ends = ends_of(plant, 1);
    EXPECT_NEAR((ends.foot_mm - Vec3(0, 100, 50)).norm(), 0, 0.05);
    EXPECT_NEAR((ends.top_mm - Vec3(60, 100, 50)).norm(), 0, 0.1);
}

TEST(SeveralStems, SaysWhichStemIsWrong)
{
    auto other = hand_sketch();
    other.inclinations.pop_back();
    auto const refused = measure_stems({ { .sketch = hand_sketch() }, { .sketch = other } });
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().fault, Fault::User);
    EXPECT_EQ(refused.error().message.substr(0, 48),
              "stem 2: there is only one inclination line: draw");
    auto const early
        = measure_stems({ { .sketch = hand_sketch(), .parent = 1 }, { .sketch = hand_sketch() } });
    ASSERT_FALSE(early);
    EXPECT_EQ(early.error().message.substr(0, 57),
              "stem 1 cannot stand on stem 2, which comes after it: give");
}

} // namespace
} // namespace tractus::lines
