#include "engine/methods/construction_lines/line_edits.h"

#include "engine/methods/construction_lines/varied_sketch.h"
#include "tests/engine/methods/construction_lines/drawn_sketch.h"

namespace tractus::lines {
namespace {

TEST(AddLine, GivesAPlantAtEveryStage)
{
    Drawing drawing;
    drawing.draw(stem());
    ASSERT_EQ(drawing.scene().plants.size(), 1U);
    EXPECT_EQ(drawing.organs(), 0U) << "nothing says yet how far leaves reach";
    auto const& axis = drawing.scene().base->axes.at(0);
    Vec3 const top_mm
        = drawing.scene().placement.world_of_plant(drawing.scene().base->positions(axis).back());
    EXPECT_NEAR((top_mm - Vec3(0, 0, 120)).norm(), 0, 0.01) << "upright, as long as drawn";

    drawing.draw(left_boundary());
    EXPECT_EQ(drawing.organs(), 6U) << "the only layer's five, and the topmost";
    drawing.draw(low_line(), 9);
    EXPECT_EQ(drawing.organs(), 6U) << "one inclination line bounds no layer";
    auto const one_line = model_of(drawing.sketch()).value();
    EXPECT_NE(one_line.source.text.find("at[2] = {0.1, 0.95}"), std::string::npos);
    drawing.draw(high_line(), 2);
    EXPECT_EQ(drawing.organs(), 10U) << "the lower line's nine";
    drawing.draw(pen_stroke({ { -50, 10, 0 }, { 0, -5, 0 }, { 60, 20, 0 } }), 3);
    EXPECT_EQ(drawing.organs(), 13U) << "nine below the new one, three above it";
    EXPECT_EQ(drawing.scene().plants.size(), 1U);
}

TEST(AddLine, TheOnlyInclinationLineHoldsAllAlong)
{
    Drawing drawing;
    drawing.draw(stem());
    drawing.draw(left_boundary());
    drawing.draw(low_line());
    auto const lines = line_sketch(drawing.sketch()).value();
    auto const construction = measure_sketch(lines, Missing::Guessed).value();
    ASSERT_EQ(construction.inclinations.size(), 2U);
    EXPECT_EQ(construction.inclinations[0].left_deg, construction.inclinations[1].left_deg);
    // The ray of the line from (0, -40) meets the boundary at (-50, -20).
    EXPECT_NEAR(construction.inclinations[0].left_deg, 90 - degrees(std::atan2(20, 50)), 1.5);
    EXPECT_EQ(measure_sketch(lines).error().message.substr(0, 35),
              "there is only one inclination line:");
}

// The stem must come first, but the order of the other lines must not matter.
TEST(AddLine, TakesTheOtherLinesInAnyOrder)
{
    auto const whole = whole_sketch();
    Drawing drawing;
    for (auto const& stroke :
         { stem(), high_line(), right_boundary(), left_boundary(), low_line() })
        drawing.draw(stroke);
    EXPECT_EQ(model_of(drawing.sketch())->source.text, model_of(whole.sketch())->source.text);
    EXPECT_EQ(model_of(drawing.sketch())->functions, model_of(whole.sketch())->functions);
}

TEST(AddLine, KeepsWhatItDoesNotKnowWithoutEffect)
{
    auto drawing = whole_sketch();
    auto const before = model_of(drawing.sketch())->functions;
    drawing.draw(odd_stroke());
    EXPECT_EQ(drawing.newest_role(), Role::Unsure);
    EXPECT_EQ(drawing.sketch().lines.size(), 6U);
    EXPECT_EQ(model_of(drawing.sketch())->functions, before);
    EXPECT_EQ(describe_result(drawing.sketch()),
              "It has no effect: this line neither crosses the stem nor goes along it: draw an "
              "inclination line across it, or a boundary along at least half of it");
}

TEST(AddLine, ALineDrawnAgainTakesTheEarlierOnesPlaceAndNodes)
{
    auto drawing = whole_sketch();
    drawing.draw(pen_stroke({ { -48, -18, 0 }, { 1, -38, 0 }, { 58, -12, 0 } }), 77);
    EXPECT_EQ(drawing.newest_role(), Role::Inclination);
    EXPECT_EQ(drawing.sketch().lines.size(), 5U);
    EXPECT_EQ(drawing.organs(), 6U);
}

// If the stem is redrawn, the plant must stand at its new beginning. The other lines must stay
// where they are.
TEST(AddLine, ThePlantStandsWhereItsStemIsDrawnAgain)
{
    auto drawing = whole_sketch();
    EXPECT_EQ(drawing.scene().placement.origin_mm, Vec3(0, 0, 0));
    drawing.draw(pen_stroke({ { 3, -58, 0 }, { 1, 60, 0 } }));
    EXPECT_EQ(drawing.newest_role(), Role::Stem);
    EXPECT_EQ(drawing.scene().placement.origin_mm, Vec3(3, 0, 0));
    auto const lines = line_sketch(drawing.sketch()).value();
    EXPECT_NEAR((lines.right.front() - Vec2(40, -60)).norm(), 0, 0.1);
}

// While the stem is drawn, the surface is raised by 60 mm. Raising it means towards the viewer.
TEST(AddLine, TheSurfacesHeightIsTheStemsDepth)
{
    Drawing drawing;
    drawing.draw(pen_stroke({ { 10, -60, 0 }, { 10, 60, 60 } }));
    auto const lines = line_sketch(drawing.sketch()).value();
    EXPECT_NEAR((lines.stem.back() - Vec3(10, 60, 60)).norm(), 0, 0.01);
    auto const& base = *drawing.scene().base;
    Vec3 const top_mm
        = drawing.scene().placement.world_of_plant(base.positions(base.axes.at(0)).back());
    EXPECT_NEAR((top_mm - Vec3(10, -60, 120)).norm(), 0, 0.2);
    Drawing resting;
    resting.draw(pen_stroke({ { 10, -60, 0 }, { 10, 60, 3 } }));
    EXPECT_EQ(line_sketch(resting.sketch())->stem.back().z(), 0) << "a sensor's noise";
}

// If the plant is moved, its sheet must move with it on the tablet. If plants are shown at another
// size, the plant's base must stay.
TEST(AddLine, GoesOnWhereThePlantIsShownNow)
{
    auto drawing = whole_sketch();
    auto moved = whole_sketch();
    auto const to_tablet = [](Vec3 const& place_mm) {
        return Vec3(0.5 * place_mm.x(), -60 + 0.5 * (place_mm.y() + 60), 0);
    };
    std::vector<Vec3> const corners { { -50, 10, 0 }, { 0, -5, 0 }, { 60, 20, 0 } };
    std::vector<Vec3> seen;
    for (auto const& corner : corners)
        seen.push_back(to_tablet(corner));
    drawing.draw(pen_stroke(corners));
    moved.apply(scene::MovePlant { moved.plant(), { 70, 20, 0 } });
    moved.apply(scene::SetScale { 0.05 });
    moved.draw(pen_stroke(seen));
    auto const expected = measured(line_sketch(drawing.sketch()).value());
    auto const found = measured(line_sketch(moved.sketch()).value());
    ASSERT_EQ(found.inclinations.size(), 3U);
    EXPECT_NEAR(found.inclinations[1].x, expected.inclinations[1].x, 0.002);
    EXPECT_NEAR(found.inclinations[1].left_deg, expected.inclinations[1].left_deg, 1);
    EXPECT_EQ(moved.scene().placement.origin_mm, Vec3(70, 20, 0));
    EXPECT_EQ(moved.scene().placement.scale, 0.05);
}

// A new line must not remove strokes on branches, and must not rebuild other plants.
TEST(AddLine, ChangesThePlantsSourceAlone)
{
    Drawing drawing;
    drawing.draw(stem());
    drawing.apply(AddLine { .stroke = pen_stroke({ { 80, -60, 0 }, { 80, 60, 0 } }) });
    ASSERT_EQ(drawing.scene().plants.size(), 2U);
    auto const first = drawing.scene().plants[0];
    drawing.apply(scene::select_paths(drawing.scene(), { { 0, 1 } }));
    drawing.apply(scene::Associate { .stroke = stem() });
    ASSERT_EQ(drawing.scene().associations.size(), 1U);
    drawing.draw(pen_stroke({ { 50, -60, 0 }, { 50, 60, 0 } }));
    EXPECT_EQ(drawing.newest_role(), Role::Left);
    EXPECT_EQ(drawing.scene().associations.size(), 1U);
    EXPECT_EQ(drawing.scene().plants[0], first);
    drawing.apply(AddLine { .plant = first->drawn->id, .stroke = left_boundary() });
    EXPECT_NE(drawing.scene().plants[0], first) << "also one that is not the active plant";
}

TEST(AddLine, RefusesWhatGivesNoPlant)
{
    auto const drawing = whole_sketch();
    EXPECT_EQ(drawing.refusal(AddLine { .stroke = pen_stroke({ { 0, 0, 0 }, { 0, 6, 0 } }) }),
              "the stem is only 6 mm long: draw at least 10 mm, from the plant's foot to its top");
    EXPECT_EQ(drawing.refusal(AddLine { .stroke = pen_stroke({ { 0, 0, 0 } }) }),
              "this is only a dot: draw a line of the sketch");
    EXPECT_EQ(drawing.refusal(AddLine { .plant = 999 * 8, .stroke = stem() }).substr(0, 14),
              "there is no pl");
    EXPECT_EQ(drawing.refusal(AddLine { .stroke = stem(), .nodes = 501 }),
              "a layer cannot have 501 nodes: give 0 to 500");
    EXPECT_EQ(drawing.refusal(AddLine { .stroke = stem(), .pattern = { .whorl = 1 } }),
              "1 organs cannot stand around a node: give 2 to 24");
    EXPECT_EQ(drawing.refusal(AddLine { .stroke = stem(), .scale = 0 }).substr(0, 26),
              "a plant cannot be shown 0 ");
    auto const model
        = scene::LoadModel { .source = { .name = "other.l",
                                         .text = "Lsystem: 1\nderivation length: 1\n"
                                                 "Axiom: F(10)\nA --> A\nendlsystem\n" } };
    auto const other = scene::apply_edit({}, model).value();
    auto const on_other = scene::apply_edit(
        other, AddLine { .plant = other.state.active, .stroke = left_boundary() });
    EXPECT_NE(on_other.error().message.find("is not drawn with construction lines"),
              std::string::npos);
}

TEST(SetLayerNodes, ChangesOneLayer)
{
    auto drawing = whole_sketch();
    auto const layer = layers_of(drawing.sketch())->at(0);
    EXPECT_EQ(layer.nodes, 5);
    EXPECT_NEAR(layer.from_x, 20.0 / 120, 0.02);
    drawing.apply(SetLayerNodes { drawing.plant(), layer.line, 11 });
    EXPECT_EQ(drawing.organs(), 12U);
    EXPECT_EQ(drawing.refusal(SetLayerNodes { drawing.plant(), 1, 3 }).substr(0, 22),
              "the sketch has no line");
    EXPECT_EQ(drawing.refusal(SetLayerNodes { drawing.plant(), layer.line, -1 }),
              "a layer cannot have -1 nodes: give 0 to 500");
    Drawing alone;
    alone.draw(stem(), 4);
    alone.apply(SetLayerNodes { alone.plant(), layers_of(alone.sketch())->at(0).line, 7 });
    alone.draw(left_boundary());
    EXPECT_EQ(alone.organs(), 8U);
}

TEST(SetLayerNodes, LayersAreFoundByPlace)
{
    auto drawing = whole_sketch();
    drawing.draw(pen_stroke({ { -50, 10, 0 }, { 0, -5, 0 }, { 60, 20, 0 } }));
    auto const layers = layers_of(drawing.sketch()).value();
    ASSERT_EQ(layers.size(), 2U);
    auto const at = [&](double v) { return layer_at(drawing.sketch(), { 20, v })->line; };
    EXPECT_EQ(at(-55), layers[0].line) << "below all: the lowest";
    EXPECT_EQ(at(-20), layers[0].line);
    EXPECT_EQ(at(10), layers[1].line);
    EXPECT_EQ(at(58), layers[1].line);
}

TEST(SetLinePattern, ChangesHowOrgansStand)
{
    auto drawing = whole_sketch();
    EXPECT_EQ(drawing.organs(), 6U);
    drawing.apply(
        SetLinePattern { drawing.plant(), { .kind = Pattern::Kind::Whorled, .whorl = 4 } });
    EXPECT_EQ(drawing.organs(), 24U);
    EXPECT_NE(drawing.refusal(SetLinePattern { drawing.plant(), { .divergence_deg = 400 } })
                  .find("from -360 to 360"),
              std::string::npos);
}

TEST(SetLineRole, SaysWhatALineIs)
{
    auto drawing = whole_sketch();
    auto const lines = drawing.sketch().lines;
    auto const left = lines[1].id;
    auto const low = lines[3].id;
    EXPECT_EQ(line_at(drawing.sketch(), { -28, 0 }), std::optional<scene::ItemId>(left));
    EXPECT_EQ(line_at(drawing.sketch(), { 120, 0 }), std::nullopt);
    drawing.apply(SetLineRole { drawing.plant(), low, Role::Unsure });
    EXPECT_EQ(line_sketch(drawing.sketch())->inclinations.size(), 1U);
    drawing.apply(SetLineRole { drawing.plant(), low, Role::Inclination });
    EXPECT_EQ(drawing.organs(), 6U);
    EXPECT_EQ(drawing.refusal(SetLineRole { drawing.plant(), lines[0].id, Role::Left }),
              "the sketch would have no stem: say first which of its lines is the stem");
    EXPECT_EQ(drawing.refusal(SetLineRole { drawing.plant(), left, Role::Inclination }),
              "inclination line 1 does not cross the stem: draw it across the stem");
    EXPECT_EQ(drawing.refusal(SetLineRole { drawing.plant(), 1, Role::Left }).substr(0, 22),
              "the sketch has no line");
}

// A new boundary replaces the previous one, which is kept and can be restored.
TEST(SetLineRole, AnotherBoundaryTakesItsPlace)
{
    Drawing drawing;
    drawing.draw(stem());
    drawing.draw(left_boundary());
    drawing.draw(pen_stroke({ { -70, -20, 0 }, { -60, 24, 0 } }));
    auto const first = drawing.sketch().lines[1].id;
    auto const second = drawing.sketch().lines[2].id;
    ASSERT_EQ(drawing.newest_role(), Role::Unsure);
    drawing.apply(SetLineRole { drawing.plant(), second, Role::Left });
    EXPECT_EQ(find_line(drawing.sketch(), first)->role, Role::Unsure);
    EXPECT_EQ(find_line(drawing.sketch(), second)->role, Role::Left);
}

TEST(SaidOf, NamesTheLineAndWhatIsMissing)
{
    Drawing drawing;
    std::vector<std::string> said;
    for (auto const& stroke :
         { stem(), left_boundary(), low_line(), high_line(), right_boundary() }) {
        drawing.draw(stroke);
        said.push_back(describe_result(drawing.sketch()));
    }
    EXPECT_EQ(said,
              (std::vector<std::string> {
                  "This is the stem: draw a boundary on its left or right, the line that the "
                  "leaves' tips reach, such as the dotted ones",
                  "This is the left boundary: draw inclination lines across the stem; until then "
                  "leaves lean by 45 degrees",
                  "This is an inclination line: draw a second inclination line; until then the "
                  "first one holds all along the stem",
                  "This is an inclination line: the right boundary is the other one, mirrored, "
                  "until you draw it",
                  "This is the right boundary" }));
}

// Returns values of the sketch's functions at several positions.
std::vector<double> functions_of(PenSketch const& sketch)
{
    auto const construction = measure_sketch(line_sketch(sketch).value(), Missing::Guessed).value();
    std::vector<double> values { construction.stem.length_mm() };
    for (double const x : { 0.3, 0.5, 0.7 }) {
        auto const at = values_at(construction, x);
        values.insert(values.end(), { at.left_deg, at.right_deg, at.left_size, at.right_size });
    }
    return values;
}

TEST(VariedSketch, IsTheSketchInTheMean)
{
    constexpr int kPlants = 600;
    Drawing drawing;
    for (auto const& stroke :
         { stem(), left_boundary(), right_boundary(), low_line(), high_line() })
        drawing.draw(stroke, 20);
    auto const& sketch = *active_pen_sketch(drawing.scene().state);
    auto const drawn = functions_of(sketch);
    std::vector<double> sums(drawn.size(), 0);
    std::vector<double> squares(drawn.size(), 0);
    double nodes = 0;
    for (std::uint32_t i = 0; i < kPlants; ++i) {
        auto const varied = varied_sketch(sketch, { .seed = 3, .plant = i });
        ASSERT_TRUE(build_pen_sketch(varied, {})) << i;
        EXPECT_LT((points_on_sheet(varied.lines[0]).value().front()
                   - points_on_sheet(sketch.lines[0]).value().front())
                      .norm(),
                  1e-9)
            << "it stands where it stood";
        auto const values = functions_of(varied);
        for (std::size_t k = 0; k < drawn.size(); ++k) {
            sums[k] += values[k] / kPlants;
            squares[k] += values[k] * values[k] / kPlants;
        }
        nodes += static_cast<double>(varied.lines[3].nodes) / kPlants;
    }
    for (std::size_t k = 0; k < drawn.size(); ++k) {
        double const deviation = std::sqrt(std::max(0.0, squares[k] - sums[k] * sums[k]));
        EXPECT_NEAR(sums[k], drawn[k], 0.01 * drawn[k] + 3 * deviation / std::sqrt(kPlants)) << k;
        EXPECT_GT(deviation, 0.005 * drawn[k]) << k << ": it differs";
        EXPECT_LT(deviation, 0.2 * drawn[k]) << k;
    }
    EXPECT_NEAR(nodes, 20, 0.5);
}

TEST(VariedSketch, DependsOnTheVariationAlone)
{
    Drawing drawing;
    for (auto const& stroke : { stem(), left_boundary(), low_line(), high_line() })
        drawing.draw(stroke);
    auto const& sketch = *active_pen_sketch(drawing.scene().state);
    scene::SourceVariation const one { .seed = 3, .plant = 1 };
    EXPECT_EQ(functions_of(varied_sketch(sketch, one)), functions_of(varied_sketch(sketch, one)));
    EXPECT_NE(functions_of(varied_sketch(sketch, one)),
              functions_of(varied_sketch(sketch, { .seed = 3, .plant = 2 })));
    EXPECT_EQ(functions_of(varied_sketch(sketch, { .spread = 0 })), functions_of(sketch));
}

} // namespace
} // namespace tractus::lines
