#include "engine/methods/construction_lines/composed_model.h"

#include "tests/engine/methods/construction_lines/sketches.h"

namespace tractus::lines {
namespace {

using Kind = Pattern::Kind;

LineModel composed(ComposedSketch const& sketch)
{
    auto const model = write_composed_model(sketch, "plant");
    EXPECT_TRUE(model) << model.error().message;
    return model.value();
}

std::string refusal_of(ComposedSketch const& sketch)
{
    auto const model = write_composed_model(sketch, "plant");
    return model ? "it is written" : model.error().message;
}

// Converts a position in a plant to the sheet, relative to the base of the first stem. One
// millimetre on the sheet is ten in the plant.
Vec3 on_sheet(Vec3 const& place_mm)
{
    return Vec3(place_mm.x(), place_mm.z(), -place_mm.y()) / 10;
}

std::vector<Vec3> tops_of(Plant const& plant)
{
    std::vector<Vec3> tops;
    for (auto const& axis : plant.axes)
        tops.push_back(on_sheet(plant.positions(axis).back()));
    return tops;
}

// Returns a sketch whose organs are other sketches. `of_layers` has the organ of each layer: the
// number of a sketch, from 1, or 0 for leaves.
ComposedSketch composition(LineSketch lines, Pattern const& pattern = {},
                           std::vector<ComposedSketch> const& organs = {},
                           std::vector<std::size_t> const& of_layers = {})
{
    for (auto const organ : of_layers)
        lines.organs_per_layer.push_back({ .organ = organ });
    ComposedSketch sketch { .stems = { { .construction = measured(lines) } }, .pattern = pattern };
    for (auto const& organ : organs)
        sketch.organs.push_back({ .sketch = std::make_shared<ComposedSketch const>(organ) });
    return sketch;
}

ComposedSketch leaf()
{
    return composition(bent_sketch());
}

// The sketch is the double-compound leaf of the paper. It must have as many compound leaves as its
// first sketch has leaves, and their tops must lie on the boundaries of that sketch.
TEST(ComposedModel, OrgansReachTheBoundariesOfWhatBearsThem)
{
    for (auto const& sketch : { hand_sketch(), bent_sketch() }) {
        auto const plant = grown(composed(composition(sketch, {}, { leaf() }, { 1 })));
        auto const count = 2 * measured(sketch).nodes.size();
        ASSERT_EQ(plant.axes.size(), 1 + count);
        EXPECT_EQ(plant.organs.size(), count * 14);
        auto const tops = tops_of(plant);
        auto const length_mm = measured(sketch).stem.length_mm();
        for (std::size_t i = 1; i < tops.size(); ++i) {
            // The stem of the organ bends. So the distance from its base to its top is compared,
            // not its length.
            auto const foot = on_sheet(plant.positions(plant.axes[i]).front());
            EXPECT_LT(std::fabs(foot.z()), 1e-3) << "in the plane of a frond";
            EXPECT_GT((tops[i] - foot).norm(), 0.1 * length_mm);
        }
    }
}

// An organ with a straight stem must end where the tip of a leaf in its place would be.
TEST(ComposedModel, AnOrgansTopIsWhereTheLeafsTipWouldBe)
{
    for (auto const kind : { Kind::Distichous, Kind::Decussate, Kind::Spiral, Kind::Whorled })
        for (auto const& sketch : { hand_sketch(), bent_sketch() }) {
            Pattern const pattern { .kind = kind, .whorl = 3 };
            auto const tips = tips_of(sketch, pattern);
            auto const plant = grown(
                composed(composition(sketch, pattern, { composition(hand_sketch()) }, { 1 })));
            auto const tops = tops_of(plant);
            ASSERT_EQ(tops.size(), 1 + tips.size());
            for (auto const& tip : tips) {
                double min_mm = 1e9;
                for (auto const& top : tops)
                    min_mm = std::min(min_mm, (top - tip).norm());
                EXPECT_LT(min_mm, 0.05) << name_of(kind);
            }
        }
}

// An organ must be the plant of its own sketch, scaled and rotated.
TEST(ComposedModel, AnOrganIsThePlantOfItsSketch)
{
    Pattern const spiral { .kind = Kind::Spiral };
    auto const own = measured(hand_sketch());
    auto const alone = tips_of(hand_sketch(), spiral);
    auto const plant = grown(
        composed(composition(hand_sketch(), {}, { composition(hand_sketch(), spiral) }, { 1 })));
    ASSERT_EQ(plant.organs.size(), 10U * alone.size());
    auto const tips = organ_tips(own, plant);
    auto const leaves = alone.size();
    for (std::size_t organ = 0; organ < 10; ++organ) {
        double const scale = (tips[organ * leaves + 1] - tips[organ * leaves]).norm()
            / (alone[1] - alone[0]).norm();
        for (std::size_t i = 1; i < leaves; ++i)
            for (std::size_t k = 0; k < i; ++k)
                EXPECT_NEAR((tips[organ * leaves + i] - tips[organ * leaves + k]).norm(),
                            scale * (alone[i] - alone[k]).norm(), 0.02);
    }
}

// The sketch has leaves in its lower layer and flowers above.
TEST(ComposedModel, LayersMayBearDifferentOrgans)
{
    auto sketch = hand_sketch();
    sketch.inclinations.push_back({ Vec2(-60, 100), Vec2(40, 100) });
    sketch.nodes_per_layer = { 3, 2 };
    std::vector const organs { leaf(), composition(hand_sketch()) };
    auto const with = [&](std::vector<std::size_t> const& of_layers) {
        return grown(composed(composition(sketch, {}, organs, of_layers)));
    };
    auto const above = with({ 0, 2 });
    EXPECT_EQ(above.axes.size(), 1 + 2U * 3) << "two nodes, and one on the topmost line";
    EXPECT_EQ(above.organs.size(), 2U * 3 + 2 * 3 * 10);
    EXPECT_EQ(with({ 1, 0 }).organs.size(), 2U * 3 * 14 + 2 * 3);
    EXPECT_EQ(with({ 2 }).axes.size(), 1 + 2U * 6) << "what is said last counts above, too";
    EXPECT_EQ(with({}).organs.size(), 2U * 6) << "leaves everywhere";
}

TEST(ComposedModel, OrgansMayHaveOrgansOfTheirOwn)
{
    auto const middle = composition(hand_sketch(), { .kind = Kind::Decussate },
                                    { composition(hand_sketch()) }, { 1 });
    auto const plant = grown(composed(
        composition(hand_sketch(), { .kind = Kind::Spiral, .sizes = Pattern::Sizes::HalfEllipses },
                    { middle }, { 1 })));
    EXPECT_EQ(plant.axes.size(), 1U + 5 + 5 * 10);
    EXPECT_EQ(plant.organs.size(), 5U * 10 * 10);
}

// The derivation must end with the step that adds the last leaf.
TEST(ComposedModel, GrowsUntilAllIsThere)
{
    auto const text = compiled(composed(composition(hand_sketch(), {}, { leaf() }, { 1 })));
    auto const after = [&](int steps) {
        lsystem::DeriveOptions options;
        options.steps = steps;
        return *lsystem::interpret(text, *lsystem::derive(text, options));
    };
    auto const whole = after(text.steps);
    EXPECT_EQ(after(text.steps + 3).organs.size(), whole.organs.size());
    EXPECT_LT(after(text.steps / 2).organs.size(), whole.organs.size());
}

TEST(ComposedModel, RefusesWhatIsTooMuch)
{
    auto large = hand_sketch();
    large.nodes_per_layer = { 400 };
    EXPECT_EQ(refusal_of(composition(large, {}, { composition(large) }, { 1 })),
              "the plant would have 643204 leaves, more than 100000: give its layers fewer nodes");
    EXPECT_EQ(refusal_of(composition(hand_sketch(), {}, { leaf() }, { 2 })),
              "layer 1 is to bear organ 2, but there are 1");
    EXPECT_EQ(
        refusal_of(composition(hand_sketch(), {}, std::vector<ComposedSketch>(12, leaf()), { 1 })),
        "the plant is composed of more than 12 sketches: leave some out");
}

} // namespace
} // namespace tractus::lines
