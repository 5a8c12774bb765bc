#include "app/methods/all_habits.h"
#include "app/methods/all_leaves.h"
#include "engine/scene/foliated_plant.h"
#include "tests/app/methods/pairs/plant_of_each_method.h"
#include "tests/app/our_plant.h"

#include <algorithm>
#include <string>
#include <vector>

namespace tractus::methods {
namespace {

// A leaf of a plant, whether it is an organ or part of a spray.
struct LeafPlace {
    Vec3 base_mm;
    double length_mm;
    SegmentId segment;
};

std::vector<LeafPlace> leaf_places(Plant const& plant)
{
    std::vector<LeafPlace> places;
    for (auto const& organ : plant.organs) {
        auto const& shape = plant.organ_shapes[organ.shape];
        if (!scene::is_leaf(plant, shape))
            continue;
        double const scale = organ.scale.y();
        if (shape.spray.empty())
            places.push_back(
                { organ.position_mm, scale * (shape.length_mm - shape.petiole_mm), organ.segment });
        for (auto const& leaf : shape.spray)
            places.push_back({ organ.position_mm + organ.orientation * (scale * leaf.base_mm),
                               scale * leaf.length_mm, organ.segment });
    }
    return places;
}

// A plant that bears leaves, and what made it.
struct LeafySource {
    std::string name;
    scene::Scene scene;
};

std::vector<LeafySource> leafy_sources()
{
    std::vector<LeafySource> sources;
    for (auto const& method : kMethods)
        // A leaf cannot wear leaves, and the small model has none.
        if (method.make != draw_leaf && method.make != load_model) {
            Steps steps(scene::apply_edit({}, scene::SetScale { 0.1 }).value());
            method.make(steps, 0);
            sources.push_back({ method.name, steps.scene() });
        }
    for (auto const* const model : { "broadleaf", "birch", "shrub" })
        sources.push_back({ model, our_plant(model) });
    for (auto const* const habit : { "oak", "lime" })
        sources.push_back(
            { habit, scene::apply_edit({}, tree_of_habit(habit, 5, 1).value()).value() });
    return sources;
}

// Putting on the leaves of any species must keep the number of leaves, their places and twigs, and
// their lengths, apart from the differences between the leaves of a species.
TEST(EveryLeaf, TakesThePlacesOfThePlantsOwn)
{
    auto const kinds = leaf_kinds();
    EXPECT_EQ(kinds.size(), 15u);
    for (auto const& source : leafy_sources()) {
        auto const before = leaf_places(*source.scene.base);
        ASSERT_GT(before.size(), 3u) << source.name;
        for (auto const& kind : kinds) {
            auto const edits
                = foliage_edits(source.scene, source.scene.state.active, { .leaves = kind.name });
            ASSERT_TRUE(edits) << edits.error().message;
            auto const scene = scene::apply_edits(source.scene, *edits).value();
            auto const after = leaf_places(*scene.in_season);
            ASSERT_EQ(after.size(), before.size()) << source.name << ' ' << kind.name;
            double moved_mm = 0;
            double shortest = 1e9;
            double longest = 0;
            bool is_on_its_twig = true;
            for (std::size_t i = 0; i < before.size(); ++i) {
                moved_mm = std::max(moved_mm, (after[i].base_mm - before[i].base_mm).norm());
                double const share = after[i].length_mm / before[i].length_mm;
                shortest = std::min(shortest, share);
                longest = std::max(longest, share);
                is_on_its_twig &= after[i].segment == before[i].segment;
            }
            EXPECT_LT(moved_mm, 1e-6) << source.name << ' ' << kind.name;
            EXPECT_GT(shortest, 0.6) << source.name << ' ' << kind.name;
            EXPECT_LT(longest, 1.6) << source.name << ' ' << kind.name;
            EXPECT_TRUE(is_on_its_twig) << source.name << ' ' << kind.name;
        }
    }
}

} // namespace
} // namespace tractus::methods
