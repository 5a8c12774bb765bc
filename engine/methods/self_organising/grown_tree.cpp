#include "engine/methods/self_organising/grown_tree.h"

#include "engine/base/random.h"
#include "engine/methods/self_organising/life.h"
#include "engine/methods/self_organising/prune.h"
#include "engine/methods/self_organising/stand.h"
#include "engine/methods/self_organising/tree_plant.h"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>
#include <memory>
#include <utility>

namespace tractus::self_organising {

namespace {

bool same_part(LifePeriod const& one, LifePeriod const& other)
{
    return one.kind == other.kind && one.years == other.years && one.is_volume == other.is_volume
        && one.stroke.tips.id() == other.stroke.tips.id()
        && one.min_radius_mm == other.min_radius_mm && one.most_radius_mm == other.most_radius_mm
        && one.waits_outside == other.waits_outside
        && one.is_drawn_reversed == other.is_drawn_reversed
        && one.seconds_per_year == other.seconds_per_year && one.stands_at_mm == other.stands_at_mm
        && one.scale == other.scale && one.stand == other.stand
        && one.place_in_stand == other.place_in_stand;
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

// The brush sweep of the life period with index `number`.
Result<BrushSweep> sweep_of(GrownTree const& tree, std::size_t number)
{
    auto const& part = tree.life[number];
    BrushSweep sweep { .balls = TRY(brush_balls(part)),
                       .years = part.years,
                       .seconds_per_year = part.seconds_per_year,
                       .waits_outside = part.waits_outside,
                       .is_volume = part.is_volume };
    sweep.seed = Random({ tree.seed, 0x5157, static_cast<std::uint32_t>(number) }).next_u64();
    for (auto i = number + 1; i < tree.life.size(); ++i)
        if (tree.life[i].kind == LifePeriod::Kind::Clear)
            sweep.cleared.push_back(TRY(brush_balls(tree.life[i])));
    return sweep;
}

// Grows the tree through the life period with index `number`, outside of any stand.
Result<void> live(GrowingTree& grown, GrownTree const& tree, std::size_t number,
                  YearCallback const& on_year)
{
    auto const& part = tree.life[number];
    TRY(check_life(part));
    if (part.kind == LifePeriod::Kind::Clear)
        // A period that clears space has already affected the sweeps of the periods before it.
        return {};
    if (part.kind == LifePeriod::Kind::Prune) {
        auto const balls = TRY(brush_balls(part));
        TRY(prune(grown, balls, tree.habit, tree.seed));
        return {};
    }
    if (!part.stroke.tips.empty())
        return grow_along(grown, TRY(sweep_of(tree, number)), tree.habit, tree.seed, on_year);
    Surroundings surroundings { .seed = tree.seed };
    for (int year = 0; year < part.years; ++year) {
        TRY(grow_year(grown, surroundings, tree.habit));
        if (on_year)
            on_year(grown);
    }
    return {};
}

} // namespace

Result<std::vector<BrushBall>> brush_balls(LifePeriod const& part)
{
    auto const tips = TRY(part.stroke.tips.in_memory());
    std::vector<BrushBall> balls;
    for (auto const& tip : tips) {
        double const pressure = std::clamp(tip.pressure, 0.0, 1.0);
        double const radius_mm
            = part.min_radius_mm + pressure * (part.most_radius_mm - part.min_radius_mm);
        auto const since = tip.time - tips.front().time;
        balls.push_back({ .seconds = to_seconds(since),
                          .centre = (tip.position_mm - part.stands_at_mm) / part.scale,
                          .radius = radius_mm / part.scale });
    }
    return balls;
}

int years_of(LifePeriod const& part)
{
    return part.kind == LifePeriod::Kind::Grow ? part.years : 0;
}

Result<void> check_life(LifePeriod const& part)
{
    bool const is_growing = part.kind == LifePeriod::Kind::Grow;
    if (!is_growing && part.stroke.tips.empty())
        return fail(Fault::User, "the stroke is empty: draw over what shall be cut or cleared");
    if (!is_growing && part.is_volume)
        return fail(Fault::User, "only growth can fill a volume: prune or clear along a stroke");
    if (is_growing && (part.years < 1 || part.years > kMaxYears))
        return fail(Fault::User,
                    fmt::format("a tree grows for 1 to {} years, and {} are asked for", kMaxYears,
                                part.years));
    if (!(part.seconds_per_year >= 0 && std::isfinite(part.seconds_per_year)))
        return fail(Fault::User,
                    fmt::format("a year cannot take {} seconds of the pen", part.seconds_per_year));
    bool const has_radius = part.min_radius_mm > 0 && part.most_radius_mm > 0
        && std::isfinite(part.min_radius_mm) && std::isfinite(part.most_radius_mm);
    if (!part.stroke.tips.empty() && !has_radius)
        return fail(Fault::User, "the brush has no radius: give one above 0 mm");
    return {};
}

Result<void> check_age(GrownTree const& tree)
{
    int years = 0;
    for (auto const& part : tree.life)
        years = std::min(years, kMaxYears) + std::min(years_of(part), kMaxYears);
    if (years > kMaxYears)
        return fail(Fault::User, fmt::format("the tree would be older than {} years", kMaxYears));
    return {};
}

// The tree after the life period with index `number`, during which it grows in a stand.
static Result<GrowingTree> grow_in_stand(GrownTree const& tree, std::size_t number,
                                         scene::LoadOptions const& options,
                                         YearCallback const& on_year)
{
    auto const& part = tree.life[number];
    auto before = tree;
    before.life.resize(number);
    if (same(part.stand->place().members[part.place_in_stand].tree, before))
        return part.stand->grow_member(part.place_in_stand, options, on_year);
    // The tree has changed since the stand was made, for example its habit or seed. The stand
    // therefore grows again with the changed tree.
    auto place = part.stand->place();
    place.members[part.place_in_stand].tree = std::move(before);
    return Stand(std::move(place)).grow_member(part.place_in_stand, options, on_year);
}

Result<GrowingTree> grow_tree(GrownTree const& tree, scene::LoadOptions const& options,
                              YearCallback const& on_year)
{
    TRY(check_habit(tree.habit));
    TRY(check_age(tree));
    // Index of the period that follows the tree's last period in a stand; 0 if it never grew in
    // one.
    std::size_t first = tree.life.size();
    while (first > 0 && !tree.life[first - 1].stand)
        --first;
    GrowingTree grown;
    if (first > 0) {
        grown = TRY(grow_in_stand(tree, first - 1, options, on_year));
    } else {
        grown = tree.start ? TRY(tree_from_beginning(*tree.start, tree.habit, tree.seed, options))
                           : plant_seed(Vec3::Zero());
        if (on_year)
            on_year(grown);
    }
    for (auto i = first; i < tree.life.size(); ++i)
        TRY(live(grown, tree, i, on_year));
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
