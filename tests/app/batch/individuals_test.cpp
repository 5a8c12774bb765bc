#include "app/batch/collection_grower.h"

#include "engine/plant/join_axes.h"
#include "engine/scene/derive_anew.h"
#include "engine/scene/edit.h"
#include "engine/scene/varied_scene.h"
#include "engine/variation/diversity.h"
#include "engine/variation/growth_preset.h"
#include "tests/app/our_plant.h"
#include "tests/engine/stroke/strokes.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <numeric>

// Tests of a dozen variations of each model whose trunk and one limb are drawn. The variations must
// differ, but keep the drawn shape.

namespace tractus::batch {
namespace {

constexpr std::uint32_t kDozen = 12;

// Returns the longest branch of order 1.
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

// Returns a plant whose trunk and longest limb are drawn. If `hanging` is true, a stroke for a
// hanging twig is also drawn over the trunk, for all branches on the trunk.
scene::Scene drawn_plant(char const* name, bool hanging = false)
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
    if (hanging) {
        variation::Selection const trunk { segments_of(scene.base->axes[0]) };
        scene = scene::apply_edit(scene, scene::select_paths(scene, trunk)).value();
        scene::Associate const twig {
            .stroke = stroke_of({ { 0, 0, 0 }, { 40, 0, 5 }, { 80, 0, -15 }, { 110, 0, -60 } }),
            .propagation = variation::Propagation::Descendants,
            .laying = variation::StrokeLaying::HeadingAndPitch
        };
        scene = scene::apply_edit(scene, twig).value();
    }
    scene::SetGrowth growth { variation::growth_preset("usual").value(), 5 };
    return scene::apply_edit(scene, growth).value();
}

// Returns the correlation of the deviations of two paths from their mean points, over all
// coordinates: 1 for equal shapes.
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

// Turns points about the vertical and then pitches them so that their chord lies along +x. Paths
// are compared like this because strokes are laid by the heading and the pitch of each branch.
std::vector<Vec3> laid_level(std::vector<Vec3> points)
{
    Vec3 const chord = points.back() - points.front();
    Quat const heading(Eigen::AngleAxisd(-std::atan2(chord.y(), chord.x()), Vec3::UnitZ()));
    Quat const pitch(
        Eigen::AngleAxisd(std::atan2(chord.z(), chord.head<2>().norm()), Vec3::UnitY()));
    for (auto& point : points)
        point = pitch * heading * point;
    return points;
}

// Returns points at equal distances along a polyline. For a young branch, these are on the part
// that has grown.
std::vector<Vec3> evenly(std::span<Vec3 const> points)
{
    constexpr std::size_t kPoints = 40;
    std::vector<double> length_mm { 0 };
    for (std::size_t i = 1; i < points.size(); ++i)
        length_mm.push_back(length_mm.back() + (points[i] - points[i - 1]).norm());
    std::vector<Vec3> even;
    std::size_t i = 1;
    for (std::size_t n = 0; n < kPoints; ++n) {
        double const at_mm = length_mm.back() * static_cast<double>(n) / (kPoints - 1);
        while (i + 1 < points.size() && length_mm[i] < at_mm)
            ++i;
        double const step_mm = length_mm[i] - length_mm[i - 1];
        double const share = step_mm > 0 ? (at_mm - length_mm[i - 1]) / step_mm : 0;
        even.push_back(points[i - 1] + share * (points[i] - points[i - 1]));
    }
    return even;
}

class Individuals : public ::testing::TestWithParam<char const*> { };

double mean_distance(scene::Scene const& scene, variation::Individuality const& how,
                     std::uint64_t seed = 5)
{
    auto grower = CollectionGrower::create(scene, 0).value();
    grower.reseed(how.seeds);
    grower.make_individuals(how);
    auto const drawn = grower.drawn().value();
    auto const box = bounds(drawn);
    variation::Diversity diversity(drawn);
    for (std::uint32_t i = 0; i < kDozen; ++i) {
        variation::PlantKey const key { seed, i };
        diversity.add(grower.comparable(key, variation::individual_age(key, how)));
    }
    return diversity.between_plants().mean_mm / (box.max_mm.z() - box.min_mm.z());
}

TEST_P(Individuals, DifferByAFifthOfTheirHeight)
{
    EXPECT_GE(mean_distance(drawn_plant(GetParam()), variation::kPlantsOfOneBed), 0.2);
    EXPECT_GE(mean_distance(drawn_plant(GetParam(), true), variation::kPlantsOfOneBed), 0.2)
        << "with a hanging twig for all that the trunk bears";
}

TEST_P(Individuals, BecomeThePlantWithTheirBranches)
{
    auto const scene = drawn_plant(GetParam());
    EXPECT_FALSE(scene::derive_anew(scene, { 5, 3 }, 0)) << "no plant has a seed of its own";
    EXPECT_FALSE(scene::derive_anew({}, { 5, 3 }, 1));
    auto edit = scene::derive_anew(scene, { 5, 3 }, 1);
    ASSERT_TRUE(edit);
    auto const own = scene::with_own_seed(scene, 5, 3);
    auto const after = scene::apply_edit(scene, *edit).value();
    EXPECT_EQ(after.base->node_position_mm, own.base->node_position_mm);
    EXPECT_NE(after.base->node_position_mm, scene.base->node_position_mm);
    EXPECT_EQ(scene::shaping_numbers(after).size(), scene::shaping_numbers(scene).size())
        << "every stroke has a branch";
    for (std::size_t i = 0; i < after.associations.size(); ++i)
        EXPECT_EQ(after.associations[i].what.path, own.associations[i].what.path);
    edit->seeds.push_back(1);
    EXPECT_FALSE(scene::apply_edit(scene, *edit)) << "there is no graft";
    edit->seeds.pop_back();
    edit->strokes.push_back(1);
    EXPECT_FALSE(scene::apply_edit(scene, *edit)) << "a stroke without a place";
}

TEST_P(Individuals, DifferByNothingButGrowthWhereAllIsOff)
{
    auto const scene = drawn_plant(GetParam());
    auto grower = CollectionGrower::create(scene, 0).value();
    auto const grown = grower.grow({ 5, 3 });
    auto again = CollectionGrower::create(scene, 0).value();
    again.reseed(0);
    again.make_individuals({});
    EXPECT_EQ(again.grow({ 5, 3 }, variation::individual_age({ 5, 3 }, {})).node_position_mm,
              grown.node_position_mm);
}

TEST_P(Individuals, KeepWhatWasDrawn)
{
    auto const scene = drawn_plant(GetParam());
    auto grower = CollectionGrower::create(scene, 0).value();
    grower.reseed(1);
    auto const drawn = grower.drawn().value();
    for (std::uint32_t i = 0; i < kDozen; ++i) {
        variation::PlantKey const key { 5, i };
        auto const grown
            = grower.grow(key, variation::individual_age(key, variation::kPlantsOfOneBed));
        auto const own = scene::with_own_seed(scene, key.seed, key.plant_index);
        ASSERT_EQ(own.associations.size(), scene.associations.size());
        for (std::size_t n = 0; n < scene.associations.size(); ++n) {
            auto const& was = drawn.axes[axis_of(drawn, scene.associations[n].what.path.back())];
            auto const& is = grown.axes[axis_of(grown, own.associations[n].what.path.back())];
            EXPECT_GE(correlation(laid_level(evenly(grown.positions(is))),
                                  laid_level(evenly(drawn.positions(was)))),
                      0.9)
                << i << " stroke " << n;
        }
    }
}

TEST_P(Individuals, OfAStochasticModelHaveSeedsOfTheirOwn)
{
    auto const scene = drawn_plant(GetParam());
    auto grower = CollectionGrower::create(scene, 0).value();
    grower.reseed(1);
    std::vector<std::size_t> counts;
    for (std::uint32_t i = 0; i < kDozen; ++i)
        counts.push_back(grower.grow({ 5, i }).segment_count());
    std::sort(counts.begin(), counts.end());
    counts.erase(std::unique(counts.begin(), counts.end()), counts.end());
    EXPECT_GE(counts.size(), 5u);
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

// Models without a drawing, including narrow plants.
class UndrawnIndividuals : public ::testing::TestWithParam<char const*> { };

TEST_P(UndrawnIndividuals, DifferByAFifthOfTheirHeight)
{
    auto const scene = our_plant(GetParam());
    for (std::uint64_t const seed : { 1u, 2u, 3u })
        EXPECT_GE(mean_distance(scene, variation::kPlantsOfOneBed, seed), 0.2) << "seed " << seed;
}

INSTANTIATE_TEST_SUITE_P(Models, UndrawnIndividuals,
                         ::testing::Values("poplar", "vine", "conifer", "sunflower"),
                         [](auto const& model) { return std::string(model.param); });

} // namespace
} // namespace tractus::batch
