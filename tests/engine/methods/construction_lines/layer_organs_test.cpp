#include "engine/methods/construction_lines/composed_model.h"
#include "engine/methods/construction_lines/organ_surface.h"

#include "tests/engine/methods/construction_lines/sketches.h"

namespace tractus::lines {
namespace {

using Kind = Pattern::Kind;
using Face = Pattern::Face;

// Returns a sketch with three nodes between the first two inclination lines, two between the next
// lines, and one on the topmost line.
LineSketch two_layers(std::vector<LayerOrgans> layers)
{
    auto sketch = hand_sketch();
    sketch.inclinations.push_back({ Vec2(-60, 100), Vec2(40, 100) });
    sketch.nodes_per_layer = { 3, 2 };
    sketch.organs_per_layer = std::move(layers);
    return sketch;
}
constexpr std::size_t kBelow = 3;
constexpr std::size_t kAbove = 3;

Plant plant_of(LineSketch const& sketch, Pattern const& pattern, std::vector<LineOrgan> organs = {})
{
    auto const model = write_composed_model({ .stems = { { .construction = measured(sketch) } },
                                              .pattern = pattern,
                                              .organs = std::move(organs) },
                                            "plant");
    EXPECT_TRUE(model) << model.error().message;
    return grown(*model);
}

bool stands_among(Vec3 const& tip, std::vector<Vec3> const& tips)
{
    return std::any_of(tips.begin(), tips.end(),
                       [&](Vec3 const& other) { return (other - tip).norm() < 1e-3; });
}

LineOrgan square(Vec3 const& color)
{
    OrganViews const views { .left = { { -5, 0 }, { -5, 10 } }, .right = { { 5, 0 }, { 5, 10 } } };
    return { .surface = { .patches = organ_surface(views).value(), .color = color } };
}

// In each layer, the organs must be those that a whole plant with the pattern of the layer has
// there.
TEST(LayerOrgans, EachLayerHasAPatternOfItsOwn)
{
    auto const sizes = { Pattern::Sizes::Linear, Pattern::Sizes::HalfEllipses };
    std::vector<Pattern> const patterns { { .kind = Kind::Distichous },
                                          { .kind = Kind::Decussate },
                                          { .kind = Kind::Spiral, .divergence_deg = 99 },
                                          { .kind = Kind::Alternate, .divergence_deg = 180 },
                                          { .kind = Kind::Whorled, .whorl = 3 },
                                          { .kind = Kind::Whorled, .whorl = 5 },
                                          { .kind = Kind::Bare } };
    for (auto const size : sizes)
        for (auto below : patterns)
            for (auto const& above : patterns) {
                below.sizes = size;
                auto other = above;
                other.sizes = size;
                auto const tips
                    = organ_tips(measured(two_layers({})),
                                 plant_of(two_layers({ {}, { .pattern = above } }), below));
                auto const of_below = tips_of(two_layers({}), below);
                auto const of_above = tips_of(two_layers({}), other);
                auto const low = kBelow * static_cast<std::size_t>(organs_at_node(below));
                auto const high = kAbove * static_cast<std::size_t>(organs_at_node(above));
                ASSERT_EQ(tips.size(), low + high) << name_of(below.kind) << name_of(above.kind);
                for (std::size_t i = 0; i < tips.size(); ++i)
                    EXPECT_TRUE(stands_among(tips[i], i < low ? of_below : of_above))
                        << name_of(below.kind) << ' ' << name_of(above.kind) << ' ' << i;
            }
}

// Returns how far the upper side of an organ points upwards, to the top of a vertical stem: -1 to
// 1.
double upwards(Organ const& organ)
{
    return (organ.orientation * Vec3(0, 0, 1)).z();
}

TEST(LayerOrgans, EachLayerHasAFaceOfItsOwn)
{
    for (auto const kind : { Kind::Distichous, Kind::Decussate, Kind::Spiral, Kind::Whorled }) {
        auto const plant
            = plant_of(two_layers({ { .pattern = Pattern { .kind = kind, .face = Face::Flat } },
                                    { .pattern = Pattern { .kind = kind, .face = Face::Up } } }),
                       { .kind = kind, .face = Face::Down });
        auto const low = kBelow * static_cast<std::size_t>(organs_at_node({ .kind = kind }));
        ASSERT_GT(plant.organs.size(), low);
        for (std::size_t i = 0; i < plant.organs.size(); ++i)
            if (i < low)
                EXPECT_NEAR(upwards(plant.organs[i]), 0, 1e-6) << name_of(kind) << i;
            else
                EXPECT_GT(upwards(plant.organs[i]), 0.3) << name_of(kind) << i;
        auto const turned = plant_of(two_layers({}), { .kind = kind, .face = Face::Down });
        for (auto const& organ : turned.organs)
            EXPECT_LT(upwards(organ), -0.3) << name_of(kind);
    }
}

// The plant has leaves in its lower layer, and surfaces of two colours above.
TEST(LayerOrgans, EachLayerHasSurfacesOfItsOwn)
{
    auto sketch = two_layers({ {}, { .organ = 2 }, { .organ = 1 } });
    sketch.inclinations.push_back({ Vec2(-60, 190), Vec2(0, 180), Vec2(40, 190) });
    sketch.nodes_per_layer.push_back(4);
    auto const plant
        = plant_of(sketch, { .kind = Kind::Spiral }, { square({ 1, 0, 0 }), square({ 0, 0, 1 }) });
    ASSERT_EQ(plant.organs.size(), 3U + 2 + 5);
    std::vector<OrganShapeId> shapes;
    for (auto const& organ : plant.organs)
        shapes.push_back(organ.shape);
    EXPECT_EQ(std::count(shapes.begin(), shapes.begin() + 3, shapes[0]), 3);
    EXPECT_EQ(std::count(shapes.begin() + 3, shapes.begin() + 5, shapes[3]), 2);
    EXPECT_EQ(std::count(shapes.begin() + 5, shapes.end(), shapes[5]), 5);
    EXPECT_NE(shapes[3], shapes[5]);
    EXPECT_NE(shapes[0], shapes[3]);
    // The organs must be as long as leaves in their place would be.
    auto leaves = sketch;
    leaves.organs_per_layer.clear();
    auto const of_leaves = tips_of(leaves, { .kind = Kind::Spiral });
    auto const tips = organ_tips(measured(sketch), plant);
    for (std::size_t i = 0; i < tips.size(); ++i)
        EXPECT_LT((tips[i] - of_leaves[i]).norm(), 1e-3) << i;
}

// Two stems with the same lines, side by side, must have the same layers.
TEST(LayerOrgans, SeveralStemsHaveLayers)
{
    std::vector<Pattern> const patterns { { .kind = Kind::Distichous },
                                          { .kind = Kind::Decussate },
                                          { .kind = Kind::Spiral },
                                          { .kind = Kind::Whorled, .whorl = 4 } };
    for (auto const& below : patterns)
        for (auto const& above : patterns) {
            auto const sketch = two_layers({ {}, { .pattern = above, .organ = 1 } });
            std::vector<LineOrgan> const organs { square({ 1, 1, 1 }) };
            auto beside = sketch;
            beside.stem = { Vec3(300, 0, 0), Vec3(300, 200, 0) };
            beside.left.clear();
            beside.right.clear();
            beside.inclinations.clear();
            auto const stems = measure_stems({ { .sketch = sketch }, { .sketch = beside } });
            ASSERT_TRUE(stems) << stems.error().message;
            auto const model = write_composed_model(
                { .stems = *stems, .pattern = below, .organs = organs }, "two");
            ASSERT_TRUE(model) << model.error().message;
            auto const one = plant_of(sketch, below, organs);
            auto const two = grown(*model);
            ASSERT_EQ(two.organs.size(), 2 * one.organs.size());
            auto const tips = organ_tips(measured(sketch), two);
            for (auto const& tip : organ_tips(measured(sketch), one)) {
                EXPECT_TRUE(stands_among(tip, tips));
                EXPECT_TRUE(stands_among(tip + Vec3(300, 0, 0), tips));
            }
        }
}

TEST(LayerOrgans, RefusesTooManySurfaces)
{
    auto const model = write_composed_model(
        { .stems = { { .construction = measured(two_layers({ { .organ = 1 } })) } },
          .organs = std::vector<LineOrgan>(kMaxSurfaces + 1, square({ 1, 1, 1 })) },
        "plant");
    ASSERT_FALSE(model);
    EXPECT_EQ(model.error().message,
              "layers of the plant bear more than 11 drawn organs: leave some out");
}

} // namespace
} // namespace tractus::lines
