#include "engine/methods/self_organising/grown_tree.h"

#include "engine/base/random.h"
#include "engine/methods/self_organising/brush.h"
#include "engine/methods/self_organising/life.h"
#include "engine/methods/self_organising/tree_plant.h"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>
#include <memory>
#include <utility>

namespace tractus::self_organising {

namespace {

bool same_part(LifePart const& one, LifePart const& other)
{
    return one.years == other.years && one.stroke.tips.id() == other.stroke.tips.id()
        && one.least_radius_mm == other.least_radius_mm
        && one.most_radius_mm == other.most_radius_mm && one.waits_outside == other.waits_outside
        && one.seconds_per_year == other.seconds_per_year && one.stands_at_mm == other.stands_at_mm
        && one.scale == other.scale;
}

bool same(GrownTree const& one, GrownTree const& other)
{
    return one.habit == other.habit && one.seed == other.seed && one.start == other.start
        && std::equal(one.life.begin(), one.life.end(), other.life.begin(), other.life.end(),
                      same_part);
}

constexpr scene::SourceKind kTree {
    .word = "self_organising",
    .build =
        [](void const* drawn, scene::LoadOptions const& options) {
            return build_tree(*static_cast<GrownTree const*>(drawn), options);
        },
    .same =
        [](void const* one, void const* other) {
            return same(*static_cast<GrownTree const*>(one), *static_cast<GrownTree const*>(other));
        },
    .vary = [](void const* drawn,
               scene::SourceVariation const& variation) -> std::shared_ptr<void const> {
        constexpr std::uint32_t kStream = 0x7265;
        auto tree = *static_cast<GrownTree const*>(drawn);
        tree.seed
            = Random({ variation.seed, kStream + variation.stream, variation.plant }).next_u64();
        return std::make_shared<GrownTree const>(std::move(tree));
    },
};

// Converts a brush stroke to a sweep in the tree's frame.
Result<BrushSweep> sweep_of(GrownTree const& tree, LifePart const& part, std::size_t number)
{
    auto const tips = TRY(part.stroke.tips.in_memory());
    BrushSweep sweep {
        .years = part.years,
        .seconds_per_year = part.seconds_per_year,
        .waits_outside = part.waits_outside,
        .seed = Random({ tree.seed, 0x5157, static_cast<std::uint32_t>(number) }).next_u64()
    };
    for (auto const& tip : tips) {
        double const pressure = std::clamp(tip.pressure, 0.0, 1.0);
        double const radius_mm
            = part.least_radius_mm + pressure * (part.most_radius_mm - part.least_radius_mm);
        auto const since = tip.time - tips.front().time;
        sweep.balls.push_back({ .seconds = to_seconds(since),
                                .centre = (tip.position_mm - part.stands_at_mm) / part.scale,
                                .radius = radius_mm / part.scale });
    }
    return sweep;
}

} // namespace

Result<void> check_life(LifePart const& part)
{
    if (part.years < 1 || part.years > kMostYears)
        return fail(Fault::User,
                    fmt::format("a tree grows for 1 to {} years, and {} are asked for", kMostYears,
                                part.years));
    if (!(part.seconds_per_year >= 0 && std::isfinite(part.seconds_per_year)))
        return fail(Fault::User,
                    fmt::format("a year cannot take {} seconds of the pen", part.seconds_per_year));
    bool const has_radius = part.least_radius_mm > 0 && part.most_radius_mm > 0
        && std::isfinite(part.least_radius_mm) && std::isfinite(part.most_radius_mm);
    if (!part.stroke.tips.empty() && !has_radius)
        return fail(Fault::User, "the brush has no radius: give one above 0 mm");
    return {};
}

Result<void> check_age(GrownTree const& tree)
{
    int years = 0;
    for (auto const& part : tree.life)
        years = std::min(years, kMostYears) + std::min(part.years, kMostYears);
    if (years > kMostYears)
        return fail(Fault::User, fmt::format("the tree would be older than {} years", kMostYears));
    return {};
}

Result<GrowingTree> grow_tree(GrownTree const& tree, scene::LoadOptions const& options)
{
    TRY(check_habit(tree.habit));
    TRY(check_age(tree));
    auto grown = tree.start ? TRY(wood_of(*tree.start, tree.habit, tree.seed, options))
                            : plant_seed(Vec3::Zero());
    for (std::size_t i = 0; i < tree.life.size(); ++i) {
        auto const& part = tree.life[i];
        TRY(check_life(part));
        if (!part.stroke.tips.empty()) {
            auto const sweep = TRY(sweep_of(tree, part, i));
            TRY(grow_along(grown, sweep, tree.habit, tree.seed));
            continue;
        }
        Surroundings surroundings { .seed = tree.seed };
        for (int year = 0; year < part.years; ++year)
            TRY(grow_year(grown, surroundings, tree.habit));
    }
    return grown;
}

Result<scene::BuiltSource> build_tree(GrownTree const& tree, scene::LoadOptions const& options)
{
    auto made = plant_of(TRY(grow_tree(tree, options)), tree.habit, tree.seed);
    return scene::BuiltSource { .plant = std::move(made.plant), .axis_keys = std::move(made.keys) };
}

scene::PlantSource source_of(GrownTree tree)
{
    return { kTree, std::move(tree) };
}

GrownTree const* grown_tree_of(scene::PlantSource const& source)
{
    return source.get<GrownTree>(kTree);
}

} // namespace tractus::self_organising
