#include "app/batch/collection_grower.h"

#include "engine/plant/join_axes.h"
#include "engine/scene/edit.h"
#include "engine/variation/diversity.h"
#include "engine/variation/growth_preset.h"
#include "tests/app/our_plant.h"
#include "tests/engine/stroke/strokes.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <numeric>
#include <string_view>

// A dozen variations of each model with a drawn trunk and limb: individuals that keep the drawn
// shape.

namespace tractus::batch {
namespace {

constexpr std::uint32_t kDozen = 12;

// Returns the longest branch on the trunk.
AxisId longest_limb(Plant const& plant)
{
    AxisId longest = 0;
    double length_mm = 0;
    for (AxisId id = 1; id < plant.axes.size(); ++id)
        if (plant.axes[id].order == 1 && axis_length_mm(plant, plant.axes[id]) > length_mm) {
            longest = id;
            length_mm = axis_length_mm(plant, plant.axes[id]);
        }
    return longest;
}

scene::Scene drawn_plant(char const* name)
{
    auto scene = our_plant(name);
    auto const draw = [&](AxisId id, std::vector<Vec3> const& points) {
        variation::Selection const paths { segments_of(scene.base->axes[id]) };
        scene = scene::apply_edit(scene, scene::select_paths(scene, paths)).value();
        scene = scene::apply_edit(
                    scene,
                    scene::Associate { .stroke = stroke_of(points),
                                       .laying = variation::StrokeLaying::HeadingAndPitch })
                    .value();
    };
    auto const limb = longest_limb(*scene.base);
    draw(0, { { 0, 0, 0 }, { 5, 0, 60 }, { 25, 0, 120 }, { 25, 0, 180 }, { 10, 0, 240 } });
    draw(limb, { { 0, 0, 0 }, { 40, 0, 10 }, { 80, 0, 0 }, { 110, 0, -30 }, { 120, 0, -70 } });
    scene::SetGrowth growth { variation::growth_preset("usual").value(), 5 };
    return scene::apply_edit(scene, growth).value();
}

// Returns the correlation of two paths' deviations from their means, over all coordinates: 1 for
// equal shapes.
double correlation(std::span<Vec3 const> one, std::span<Vec3 const> other)
{
    auto const mean = [](std::span<Vec3 const> points) {
        return Vec3(std::accumulate(points.begin(), points.end(), Vec3(Vec3::Zero()))
                    / static_cast<double>(points.size()));
    };
    Vec3 const mean_one = mean(one);
    Vec3 const mean_other = mean(other);
    double both = 0;
    double first = 0;
    double second = 0;
    for (std::size_t i = 0; i < one.size(); ++i) {
        Vec3 const a = one[i] - mean_one;
        Vec3 const b = other[i] - mean_other;
        both += a.dot(b);
        first += a.squaredNorm();
        second += b.squaredNorm();
    }
    return both / std::sqrt(first * second);
}

class Individuals : public ::testing::TestWithParam<char const*> { };

TEST_P(Individuals, DifferByAFifthOfTheirHeightAndKeepWhatWasDrawn)
{
    auto const scene = drawn_plant(GetParam());
    auto const limb = longest_limb(*scene.base);
    auto grower = CollectionGrower::create(scene, 0).value();
    auto const drawn = grower.drawn().value();
    auto const box = bounds(drawn);
    double const height_mm = box.max_mm.z() - box.min_mm.z();
    variation::Individuality const how { .branches = 0.08, .size = 0.12, .turn = 1 };
    variation::Diversity diversity(drawn);
    for (std::uint32_t i = 0; i < kDozen; ++i) {
        variation::PlantKey const key { 5, i };
        auto const& grown = grower.grow(key);
        diversity.add(variation::sized_and_turned(grown, key, how));
        for (AxisId const id : { AxisId { 0 }, limb })
            EXPECT_GE(correlation(grown.positions(grown.axes[id]), drawn.positions(drawn.axes[id])),
                      0.9)
                << i << " axis " << id;
    }
    // A poplar is a column, a fifth as wide as it is high, so rotations move little of it.
    bool const is_column = std::string_view(GetParam()) == "poplar";
    EXPECT_GE(diversity.between_plants().mean_mm, (is_column ? 0.15 : 0.2) * height_mm);
}

TEST_P(Individuals, HaveBranchesOfTheirOwnButThoseThatWereDrawn)
{
    auto const scene = drawn_plant(GetParam());
    auto const limb = longest_limb(*scene.base);
    auto grower = CollectionGrower::create(scene, 0).value();
    std::vector<std::size_t> counts;
    for (std::uint32_t i = 0; i < kDozen; ++i) {
        grower.make_individuals({});
        auto const whole = grower.grow({ 5, i });
        grower.make_individuals({ .branches = 0.08 });
        auto const& own = grower.grow({ 5, i });
        check_plant(own);
        counts.push_back(own.axes.size());
        for (AxisId const id : { AxisId { 0 }, limb }) {
            Vec3 const tip = whole.positions(whole.axes[id]).back();
            EXPECT_NE(std::find(own.node_position_mm.begin(), own.node_position_mm.end(), tip),
                      own.node_position_mm.end())
                << i << " axis " << id;
        }
    }
    std::sort(counts.begin(), counts.end());
    counts.erase(std::unique(counts.begin(), counts.end()), counts.end());
    EXPECT_GE(counts.size(), 8u);
}

INSTANTIATE_TEST_SUITE_P(Models, Individuals,
                         ::testing::Values("broadleaf", "conifer", "birch", "poplar", "shrub"),
                         [](auto const& model) { return std::string(model.param); });

} // namespace
} // namespace tractus::batch
