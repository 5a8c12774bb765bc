#include "engine/methods/silhouettes/leaf_fill.h"

#include "engine/methods/silhouettes/leaf_raster.h"
#include "engine/methods/silhouettes/tree_preset.h"
#include "tests/engine/methods/silhouettes/outlines.h"

#include <cstring>
#include <set>
#include <string_view>

namespace tractus::silhouette {
namespace {

// A crown by its half width at seven heights from its foot to its top, evenly spaced.
struct SpeciesCrown {
    std::string_view name;
    std::string_view form;
    double height_mm;
    std::array<double, 7> half_width_mm;
    int bumps; // Number of bumps on each side.
};

constexpr std::array<SpeciesCrown, 10> kCrowns { {
    { "oak", "oak", 100, { 14, 42, 51, 52, 46, 34, 5 }, 5 },
    { "pine", "pine", 110, { 10, 24, 26, 27, 32, 30, 4 }, 5 },
    { "willow", "willow", 90, { 38, 48, 50, 50, 43, 33, 4 }, 5 },
    { "birch", "oak", 120, { 9, 24, 29, 28, 23, 14, 2 }, 6 },
    { "spruce", "fir", 130, { 27, 28, 23, 18, 12, 7, 1 }, 9 },
    { "Lombardy poplar", "poplar", 140, { 6, 13, 16, 17, 15, 11, 2 }, 7 },
    { "apple", "oak", 70, { 14, 38, 43, 44, 38, 28, 5 }, 4 },
    { "beech", "poplar", 110, { 18, 42, 45, 45, 39, 27, 3 }, 5 },
    { "umbrella pine", "pine", 60, { 12, 38, 55, 60, 52, 36, 8 }, 3 },
    { "eucalyptus", "eucalyptus", 110, { 14, 32, 25, 30, 40, 30, 4 }, 4 },
} };

// The crown's outline and trunk as a trembling hand draws them.
Drawing drawn_by_hand(SpeciesCrown const& crown, std::uint32_t number)
{
    constexpr int kPoints = 150; // On each side.
    constexpr double kFoot_mm = 30;
    Random random({ 7, 2, number });
    Drawing drawing { { {} }, upright(0, kFoot_mm + 0.72 * crown.height_mm) };
    for (double const side : { 1.0, -1.0 }) {
        double const phase = random.uniform();
        for (int i = 0; i <= kPoints; ++i) {
            double const t = (side > 0 ? i : kPoints - i) / static_cast<double>(kPoints);
            auto const piece = std::min<std::size_t>(static_cast<std::size_t>(6 * t), 5);
            double const share = 6 * t - static_cast<double>(piece);
            double const bump = 0.9 + 0.2 * std::abs(std::sin(kPi * (crown.bumps * t + phase)));
            double const half
                = (1 - share) * crown.half_width_mm[piece] + share * crown.half_width_mm[piece + 1];
            double const beat = (side > 0 ? i : 2 * kPoints - i) / 40.0;
            drawing.outline[0].emplace_back(
                side * half * bump + 0.9 * std::sin(6.1 * beat) + random.uniform(-0.3, 0.3),
                kFoot_mm + crown.height_mm * t + 0.9 * std::sin(5.3 * beat + 1)
                    + random.uniform(-0.3, 0.3));
        }
    }
    drawing.outline[0].push_back(drawing.outline[0].front());
    return drawing;
}

TreeForm preset_of(std::string_view name, bool reaches)
{
    for (auto const& preset : tree_presets())
        if (preset.name == name) {
            auto form = preset.form;
            form.has_whole_nodes = true;
            form.leaves_reach_outline = reaches;
            return form;
        }
    ADD_FAILURE() << name;
    return {};
}

Tree leafy_tree_of(Drawing const& drawing, TreeForm const& form, double height_mm = 8000)
{
    auto const skeleton = infer_skeleton(drawing, skeleton_options(form));
    EXPECT_TRUE(skeleton) << skeleton.error().message;
    return skeleton ? make_tree(*skeleton, tree_options(form, height_mm)) : Tree {};
}

// Digest of everything that a plant's leaves and axes are made of.
std::uint64_t digest_of(Plant const& plant)
{
    std::uint64_t digest = 14695981039346656037u;
    auto const add = [&](auto const& value) {
        std::array<unsigned char, sizeof(value)> bytes {};
        std::memcpy(bytes.data(), &value, sizeof(value));
        for (auto const byte : bytes)
            digest = (digest ^ byte) * 1099511628211u;
    };
    for (auto const& node : plant.node_position_mm)
        for (double const coordinate : { node.x(), node.y(), node.z() })
            add(coordinate);
    for (auto const& organ : plant.organs) {
        add(organ.segment);
        add(organ.scale.x());
        add(organ.position_mm.z());
        add(organ.orientation.w());
    }
    return digest;
}

TEST(LeafFill, FillsTheOutlinesOfTenSpeciesAsSeen)
{
    for (std::uint32_t number = 0; number < kCrowns.size(); ++number) {
        auto const& crown = kCrowns[number];
        auto const drawing = drawn_by_hand(crown, number);
        auto const tree = leafy_tree_of(drawing, preset_of(crown.form, true));
        check_plant(tree.plant);
        auto const coverage = leaf_coverage(tree.plant, tree.outline_mm);
        EXPECT_GE(coverage.inside, 0.92) << crown.name;
        EXPECT_LE(coverage.outside, 0.08) << crown.name;
        EXPECT_EQ(tree.plant.organs.size(), 2 * tree.sprays) << crown.name;
        std::set<std::string> const names(tree.axis_names.begin(), tree.axis_names.end());
        EXPECT_EQ(names.size(), tree.plant.axes.size()) << crown.name;
    }
}

// Under the old law the same oak is less full; otherwise the test above would say nothing.
TEST(LeafFill, LeavesTreesFromBeforeThisLawAsTheyWere)
{
    auto const drawing = drawn_by_hand(kCrowns[0], 0);
    auto const before = leafy_tree_of(drawing, preset_of("oak", false));
    auto const coverage = leaf_coverage(before.plant, before.outline_mm);
    EXPECT_LT(coverage.inside, 0.9);
    EXPECT_FALSE(TreeForm().leaves_reach_outline);
    auto const after = leafy_tree_of(drawing, preset_of("oak", true));
    ASSERT_GE(after.plant.axes.size(), before.plant.axes.size());
    auto const orders = [](Plant const& plant) {
        std::uint32_t most = 0;
        for (auto const& axis : plant.axes)
            most = std::max(most, axis.order);
        return most;
    };
    EXPECT_EQ(orders(after.plant), orders(before.plant));
    for (std::size_t i = 0; i < before.plant.node_position_mm.size(); ++i)
        ASSERT_EQ(after.plant.node_position_mm[i], before.plant.node_position_mm[i]) << i;
    EXPECT_LE(after.sprays, static_cast<std::size_t>(kMostAdded * double(before.sprays)) + 400);
}

TEST(LeafFill, TheSameSeedGivesTheSameLeavesAndAnotherSeedOthers)
{
    auto const drawing = drawn_by_hand(kCrowns[6], 6);
    auto form = preset_of("oak", true);
    auto const digest = digest_of(leafy_tree_of(drawing, form).plant);
    EXPECT_EQ(digest_of(leafy_tree_of(drawing, form).plant), digest);
    form.seed = 2;
    EXPECT_NE(digest_of(leafy_tree_of(drawing, form).plant), digest);
}

// Neither the unit of the drawing nor the height of the tree matters to what leaves cover.
TEST(LeafFill, CoversAsMuchAtAnySize)
{
    auto const drawing = drawn_by_hand(kCrowns[6], 6);
    auto const form = preset_of("oak", true);
    for (double const height_mm : { 50.0, 30'000.0 }) {
        auto const tree = leafy_tree_of(drawing, form, height_mm);
        auto const coverage = leaf_coverage(tree.plant, tree.outline_mm);
        EXPECT_GE(coverage.inside, 0.92) << height_mm;
        EXPECT_LE(coverage.outside, 0.08) << height_mm;
    }
}

// Sizes of twigs must stay in the range of those under the old law, so that none is seen to fill.
TEST(LeafFill, AddsTwigsOfTheUsualSizes)
{
    auto const tree = leafy_tree_of(drawn_by_hand(kCrowns[0], 0), preset_of("oak", true));
    for (auto const& organ : tree.plant.organs) {
        double const length_mm = kSprayLength_mm * static_cast<double>(organ.scale.x());
        EXPECT_LT(length_mm, 0.0611 * 8000);
        EXPECT_GT(length_mm, 0.3 * 0.016 * 8000);
    }
}

// A square leaf in front of a square outline covers the share that areas say.
TEST(LeafRaster, MeasuresSharesOfAreas)
{
    std::array const square { Vec2(0, 0), Vec2(100, 0), Vec2(100, 100), Vec2(0, 100) };
    Plant plant;
    plant.materials.push_back({ .kind = Material::Kind::Leaf });
    OrganShape shape { .kind = OrganShape::Kind::Surface };
    BezierPatch patch;
    for (std::size_t i = 0; i < 16; ++i)
        patch.control[i]
            = Vec3(static_cast<double>(i % 4) * 20, 0, static_cast<double>(i / 4) * 20);
    shape.patches.push_back(patch);
    plant.organ_shapes.push_back(shape);
    EXPECT_EQ(leaf_coverage(plant, square).inside, 0);
    // A leaf of 60 mm by 60 mm, of which a third is right of the outline.
    plant.organs.push_back({ .shape = 0, .position_mm = Vec3(60, 500, 20) });
    auto const coverage = leaf_coverage(plant, square);
    EXPECT_NEAR(coverage.inside, 0.24, 0.004);
    EXPECT_NEAR(coverage.outside, 1.0 / 3, 0.01);
    // A leaf that is drawn twice covers no more than once.
    plant.organs.push_back(plant.organs[0]);
    EXPECT_EQ(leaf_coverage(plant, square).inside, coverage.inside);
    EXPECT_EQ(leaf_coverage(plant, {}).inside, 0);
}

} // namespace
} // namespace tractus::silhouette
