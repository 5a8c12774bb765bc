#include "engine/methods/leaves/leaf_sketch.h"

#include "engine/methods/leaves/leaf_sketch_edits.h"
#include "engine/methods/leaves/print_grammar.h"
#include "engine/scene/edit.h"
#include "engine/scene/scene.h"
#include "tests/engine/methods/leaves/drawing_hand.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <numbers>

namespace tractus::leaf {
namespace {

constexpr double kSize_mm = 100;

Stroke stroke_of(std::vector<Vec3> const& places_mm, Vec3 const& moved_mm = Vec3::Zero())
{
    std::vector<TipSample> tips;
    for (auto const& place_mm : places_mm) {
        auto& tip = tips.emplace_back();
        tip.time = timestamp_ns(static_cast<std::int64_t>(tips.size()) * 5'000'000);
        tip.position_mm = place_mm + moved_mm;
        tip.pressure = 0.5f;
    }
    return { .tips = SharedVector<TipSample>(std::move(tips)) };
}

struct Hand {
    BotanicalLeaf truth {};
    HandDrawing drawn {};
};

Hand hand(std::string const& species, std::uint32_t number, Manner manner = {})
{
    Random random({ 51, number, 3 });
    Hand hand { .truth = botanical_leaf(species, random) };
    manner.size_mm = kSize_mm;
    hand.drawn = draw_by_hand(hand.truth, manner, random);
    return hand;
}

LeafSketch sketch_of(LeafDrawing const& drawing, Vec3 const& moved_mm = Vec3::Zero())
{
    LeafSketch sketch { .scale = 1 };
    for (auto const& line : drawing.strokes) {
        auto next = with_line(
            sketch, { .id = sketch.lines.size() + 1, .stroke = stroke_of(line, moved_mm) });
        EXPECT_TRUE(next) << next.error().message;
        if (next)
            sketch = *std::move(next);
    }
    return sketch;
}

std::vector<Vec3> circle_of(double radius_mm, Vec2 const& middle_mm = { 0, 0 })
{
    std::vector<Vec3> places;
    for (int i = 0; i <= 72; ++i) {
        double const angle = i * std::numbers::pi / 36 - std::numbers::pi / 2;
        places.emplace_back(middle_mm.x() + 0.5 * radius_mm * std::cos(angle),
                            middle_mm.y() + radius_mm * std::sin(angle), 100);
    }
    return places;
}

// The lines come from a simulated hand that shares no code with the recognition. They are added one
// after the other.
TEST(LeafSketch, IsTheLeafOfItsLinesAtTheLastAndAPlantAtEveryStage)
{
    for (auto const& species : botanical_species()) {
        auto const [truth, drawn] = hand(species, 7);
        LeafSketch sketch { .scale = 1 };
        for (auto const& line : drawn.drawing.strokes) {
            auto next
                = with_line(sketch, { .id = sketch.lines.size() + 1, .stroke = stroke_of(line) });
            ASSERT_TRUE(next) << species << ": " << next.error().message;
            sketch = *std::move(next);
            auto const built = build_leaf(sketch);
            ASSERT_TRUE(built) << species << ": " << built.error().message;
            check_plant(built->plant);
            EXPECT_EQ(built->axis_keys.size(), built->plant.axes.size());
        }
        ASSERT_TRUE(sketch.seen) << species;
        EXPECT_EQ(sketch.seen->left_out, "");
        EXPECT_FALSE(sketch.seen->is_midrib_guessed);
        auto const at_once = fit_leaf(recognise_leaf(drawn.drawing).value()).value();
        EXPECT_EQ(*adjusted_leaf(sketch), at_once.leaf) << species;
        EXPECT_EQ(sketch.seen->fit.veins.size(), 1 + truth.mains.size() + truth.sides.size())
            << species;
    }
}

// Converts a position from the plant's frame to the sheet, on which the plant stands at `foot`.
Vec2 on_paper(Vec3 const& at, Vec2 const& foot)
{
    return Vec2(at.x(), at.z()) + foot;
}

TEST(LeafSketch, LiesInItsDrawing)
{
    for (auto const& species : { "beech", "maple", "magnolia", "birch" })
        for (double const turned_deg : { 0.0, 35.0, -140.0 }) {
            SCOPED_TRACE(species);
            auto const drawn
                = hand(species, 3, { .tremor_mm = 0.1, .turned_deg = turned_deg }).drawn;
            auto const sketch = sketch_of(drawn.drawing, { 40, -30, 200 });
            auto const plant = build_leaf(sketch).value().plant;
            Vec2 const foot = foot_of(sketch).value();
            auto const lines = drawing_of(sketch).value();
            FlatLine outline;
            for (std::size_t i = 0; i < lines.strokes.size(); ++i)
                if (sketch.seen->lines.roles[i] == StrokeRole::Outline)
                    for (std::size_t at = 0; at < lines.strokes[i].size(); at += 6)
                        outline.push_back(lines.strokes[i][at].head<2>());
            std::size_t on_limb = 0;
            for (auto const& polygon : plant.polygons)
                for (std::uint32_t i = 0; i < polygon.vertex_count; ++i) {
                    if (plant.materials[polygon.material].name != "limb")
                        continue;
                    auto const at
                        = on_paper(plant.polygon_vertices_mm[polygon.first_vertex + i], foot);
                    ++on_limb;
                    EXPECT_TRUE(is_inside(outline, at)
                                || nearest_on(outline, at).distance < 0.03 * kSize_mm)
                        << at.transpose();
                }
            EXPECT_GT(on_limb, 100u);
            for (auto const& at : outline) {
                double nearest = 1e9;
                for (auto const& vertex : plant.polygon_vertices_mm)
                    nearest = std::min(nearest, (on_paper(vertex, foot) - at).norm());
                EXPECT_LT(nearest, 0.06 * kSize_mm) << at.transpose();
            }
        }
}

TEST(LeafSketch, HasItsOutlineAloneFirst)
{
    auto sketch = with_line({ .scale = 1 }, { .id = 1, .stroke = stroke_of(circle_of(40)) });
    ASSERT_TRUE(sketch) << sketch.error().message;
    ASSERT_TRUE(sketch->seen);
    EXPECT_TRUE(sketch->seen->is_midrib_guessed);
    EXPECT_NEAR(sketch->seen->fit.leaf.size_mm, 80, 1);
    EXPECT_NE(describe_result(*sketch).find("draw its midrib"), std::string::npos);
    sketch = with_line(
        *sketch,
        { .id = 2, .stroke = stroke_of({ { 0, -60, 100 }, { 0, 0, 100 }, { 0, 39, 100 } }) });
    ASSERT_TRUE(sketch) << sketch.error().message;
    EXPECT_FALSE(sketch->seen->is_midrib_guessed);
    EXPECT_NEAR(sketch->seen->fit.leaf.stalk, 0.25, 0.02);
}

TEST(LeafSketch, TakesALineThatIsDrawnAgainInThePlaceOfTheFirst)
{
    auto const drawn = hand("beech", 5).drawn;
    auto const before = sketch_of(drawn.drawing);
    for (std::size_t i = 0; i < drawn.drawing.strokes.size(); ++i) {
        auto again = drawn.drawing.strokes[i];
        std::ranges::reverse(again);
        auto const after
            = with_line(before, { .id = 99, .stroke = stroke_of(again, { 0.4, 0.3, 20 }) });
        ASSERT_TRUE(after) << after.error().message;
        EXPECT_EQ(after->lines.size(), before.lines.size());
        EXPECT_EQ(after->lines[i].id, 99u);
    }
    auto const larger
        = with_line(before, { .id = 99, .stroke = stroke_of(circle_of(300)) }).value();
    EXPECT_EQ(larger.lines.size(), before.lines.size());
}

TEST(LeafSketch, LeavesOutWhatMakesItNone)
{
    auto const sketch = sketch_of(hand("beech", 5).drawn.drawing);
    auto const dot = with_line(sketch, { .id = 99, .stroke = stroke_of({ { 1, 2, 3 } }) });
    ASSERT_FALSE(dot);
    EXPECT_EQ(dot.error().message,
              "a dot is no line of a leaf: draw its outline, its midrib or a vein");
    auto const beside
        = with_line(sketch, { .id = 99, .stroke = stroke_of(circle_of(10, { 500, 500 })) });
    ASSERT_TRUE(beside) << beside.error().message;
    EXPECT_EQ(beside->lines.size(), sketch.lines.size() + 1);
    ASSERT_TRUE(beside->seen);
    EXPECT_FALSE(beside->seen->left_out.empty());
    EXPECT_EQ(beside->seen->lines.roles.size(), beside->lines.size());
    EXPECT_EQ(adjusted_leaf(*beside), adjusted_leaf(sketch));
    EXPECT_FALSE(without_line(sketch, 1234));
    auto left = sketch;
    while (left.lines.size() > 1)
        left = without_line(left, left.lines.back().id).value();
    EXPECT_FALSE(without_line(left, left.lines.back().id));
}

TEST(LeafSketch, IsChangedByNumbers)
{
    auto sketch = sketch_of(hand("beech", 5, { .tremor_mm = 0 }).drawn.drawing);
    auto const depth_of = [](LeafSketch const& of) {
        auto const plant = build_leaf(of).value().plant;
        double least = 0;
        double most = 0;
        for (auto const& at : plant.polygon_vertices_mm) {
            least = std::min(least, at.y());
            most = std::max(most, at.y());
        }
        return most - least;
    };
    double const flat = depth_of(sketch);
    EXPECT_LT(flat, 0.06 * kSize_mm);
    sketch.form.bend_deg = 90;
    EXPECT_GT(depth_of(sketch), 0.15 * kSize_mm);
    sketch.form = { .rise_deg = 40 };
    EXPECT_GT(depth_of(sketch), flat + 0.1 * kSize_mm);
    sketch.form = { .teeth = 12, .tooth_depth = 0.03 };
    auto const text = grammar_text(sketch, "toothed").value();
    EXPECT_NE(text.find("teeth(12, 0.03"), std::string::npos);
    EXPECT_EQ(read_drawn_leaf(parse_grammar(text, "toothed").value()), adjusted_leaf(sketch));
    sketch.form.teeth = 61;
    auto const refused = build_leaf(sketch);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().message, "a leaf's number of teeth cannot be 61: give 0 to 60");
}

// Another individual must have other veins and an outline of the same size. The leaf that was drawn
// must be exact.
TEST(LeafSketch, VariesAsLeavesOfATreeDo)
{
    auto const sketch = sketch_of(hand("beech", 5).drawn.drawing);
    scene::PlantSource const source(LeafSketch::kKind, sketch);
    auto const build = [](scene::PlantSource const& of) { return of.build({}).value().plant; };
    auto const drawn = build(source);
    auto const same = build(source.varied({ .seed = 4, .plant = 2, .spread = 0 }));
    EXPECT_EQ(same.polygon_vertices_mm, drawn.polygon_vertices_mm);
    auto const other = build(source.varied({ .seed = 4, .plant = 2 }));
    EXPECT_NE(other.polygon_vertices_mm, drawn.polygon_vertices_mm);
    EXPECT_EQ(build(source.varied({ .seed = 4, .plant = 2 })).polygon_vertices_mm,
              other.polygon_vertices_mm);
    check_plant(other);
}

TEST(LeafSketchEdits, StandUnderTheirInk)
{
    AddLeafLine const outline { .stroke = stroke_of(circle_of(40)), .stands_at_mm = { 5, 7, 0 } };
    auto scene = scene::apply_edit({}, outline);
    ASSERT_TRUE(scene) << scene.error().message;
    auto const plant = scene->state.active;
    auto const& state = *scene->state.plants.at(0);
    EXPECT_NEAR(state.paper_mm.value().y(), -40, 0.1);
    scene = scene::apply_edit(
        *scene,
        AddLeafLine { .plant = plant, .stroke = stroke_of({ { 3, -60, 100 }, { 0, 39, 100 } }) });
    ASSERT_TRUE(scene) << scene.error().message;
    auto const& moved = *scene->state.plants.at(0);
    EXPECT_NEAR(moved.paper_mm.value().y(), -60, 0.1);
    EXPECT_NEAR(moved.stands_at_mm.x(), 8, 0.1);
    auto const erased
        = scene::apply_edit(*scene, EraseLeafLine { plant, leaf_sketch(moved)->lines.back().id });
    ASSERT_TRUE(erased) << erased.error().message;
    EXPECT_EQ(active_leaf_sketch(erased->state)->lines.size(), 1u);
    EXPECT_FALSE(scene::apply_edit(*erased, FormLeaf { plant, { .bend_deg = 1e9 } }));
    EXPECT_FALSE(scene::apply_edit(*erased, FormLeaf { 4711, {} }));
}

} // namespace
} // namespace tractus::leaf
