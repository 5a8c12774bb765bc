#include "engine/methods/self_organising/grown_tree.h"

#include "engine/base/random.h"
#include "engine/methods/self_organising/brush.h"
#include "engine/methods/self_organising/life.h"
#include "engine/methods/self_organising/tree_plant.h"
#include "engine/scene/edit_words.h"
#include "engine/scene/make_edit_kind.h"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>
#include <memory>
#include <utility>

namespace tractus::self_organising {

namespace {

constexpr double kUsualScale = 0.1; // Of strokes in a document that has no scale.

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
    return one.habit == other.habit && one.seed == other.seed
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

// The sweep of a stroke in the tree's frame.
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

void list_habit(scene::Fields& fields, Habit& habit)
{
    fields.field("habit", &habit.name);
    fields.sparse_field("latin", &habit.latin);
    fields.sparse_field("leaves", &habit.leaves);
    for (auto const& number : habit_numbers())
        fields.field(number.key, &(habit.*number.value));
}

void list_part(scene::Fields& fields, LifePart& part)
{
    fields.field("years", &part.years);
    fields.field("least_radius", &part.least_radius_mm);
    fields.field("most_radius", &part.most_radius_mm);
    fields.field("waits_outside", &part.waits_outside);
    fields.sparse_field("seconds_per_year", &part.seconds_per_year);
    fields.numbers(part.stroke);
}

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

std::string describe_part(LifePart const& part)
{
    auto const years = scene::counted(static_cast<std::size_t>(std::max(part.years, 0)), "year");
    return part.stroke.tips.empty()
        ? fmt::format("{} by itself", years)
        : fmt::format("{} along a brush: {}", years, scene::describe_stroke(part.stroke));
}

void list(scene::Fields& fields, PlantTree& edit)
{
    fields.field("seed", &edit.seed);
    fields.field("scale", &edit.scale);
    fields.id(edit.id);
    list_habit(fields, edit.habit);
    list_part(fields, edit.first);
}

Result<scene::DocumentState> applied(scene::DocumentState state, PlantTree const& edit,
                                     scene::SceneBuilder&)
{
    TRY(check_habit(edit.habit));
    TRY(check_life(edit.first));
    if (!(edit.scale >= 0 && std::isfinite(edit.scale)))
        return fail(Fault::User,
                    fmt::format("a tree cannot be shown {} times as large as it is", edit.scale));
    auto const tips = TRY(edit.first.stroke.tips.in_memory());
    if (!state.scale && edit.scale > 0)
        state.scale = edit.scale;
    else if (!state.scale && !tips.empty())
        state.scale = kUsualScale;
    auto part = edit.first;
    part.scale = state.scale.value_or(kUsualScale);
    if (!tips.empty())
        part.stands_at_mm = tips.front().position_mm;
    auto const stands_at_mm = part.stands_at_mm;
    GrownTree tree { .habit = edit.habit, .seed = edit.seed, .life = { std::move(part) } };
    return scene::with_source(std::move(state),
                              { .name = edit.habit.name,
                                .source = source_of(std::move(tree)),
                                .drawn = scene::Drawn::Beside,
                                .stands_at_mm = stands_at_mm,
                                .id = edit.id });
}

std::string described(PlantTree const& edit)
{
    return fmt::format("plants a tree of the habit {}, {}", edit.habit.name,
                       describe_part(edit.first));
}

// The document with what `change` makes of a tree in its place.
template<typename Change>
Result<scene::DocumentState> changed(scene::DocumentState state, scene::ItemId plant,
                                     Change const& change)
{
    auto const number = TRY(scene::plant_number(state, plant));
    auto const* const before = grown_tree_of(state.plants[number]->source);
    if (!before)
        return fail(Fault::User,
                    fmt::format("plant {} is no self-organised tree: choose one that is",
                                scene::name_of(plant)));
    auto tree = *before;
    change(tree);
    TRY(check_age(tree));
    scene::change_plant(state, number, [&](scene::PlantState& changed_plant) {
        changed_plant.source = source_of(std::move(tree));
        changed_plant.source_edit = state.last_edit;
    });
    return state;
}

void list(scene::Fields& fields, GrowOn& edit)
{
    fields.field("plant", &edit.plant);
    list_part(fields, edit.next);
}

Result<scene::DocumentState> applied(scene::DocumentState state, GrowOn const& edit,
                                     scene::SceneBuilder&)
{
    TRY(check_life(edit.next));
    auto part = edit.next;
    if (!part.stroke.tips.empty()) {
        if (!state.scale)
            state.scale = kUsualScale;
        part.scale = *state.scale;
        part.stands_at_mm = state.plants[TRY(scene::plant_number(state, edit.plant))]->stands_at_mm;
    }
    return changed(std::move(state), edit.plant,
                   [&](GrownTree& tree) { tree.life.push_back(std::move(part)); });
}

std::string described(GrowOn const& edit)
{
    return fmt::format("lets {} grow on, {}", scene::name_of(edit.plant), describe_part(edit.next));
}

void list(scene::Fields& fields, ChangeHabit& edit)
{
    fields.field("plant", &edit.plant);
    fields.field("seed", &edit.seed);
    list_habit(fields, edit.habit);
}

Result<scene::DocumentState> applied(scene::DocumentState state, ChangeHabit const& edit,
                                     scene::SceneBuilder&)
{
    TRY(check_habit(edit.habit));
    return changed(std::move(state), edit.plant, [&](GrownTree& tree) {
        tree.habit = edit.habit;
        tree.seed = edit.seed;
    });
}

std::string described(ChangeHabit const& edit)
{
    return fmt::format("lets {} grow again by the habit {}, seed {}", scene::name_of(edit.plant),
                       edit.habit.name, edit.seed);
}

} // namespace

Result<GrowingTree> grow_tree(GrownTree const& tree)
{
    TRY(check_habit(tree.habit));
    TRY(check_age(tree));
    auto grown = plant_seed(Vec3::Zero());
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

Result<scene::BuiltSource> build_tree(GrownTree const& tree, scene::LoadOptions const&)
{
    auto made = plant_of(TRY(grow_tree(tree)), tree.habit, tree.seed);
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

constexpr scene::EditKind PlantTree::kKind
    = scene::make_edit_kind<PlantTree, list, applied, described>("plant_tree", true);
constexpr scene::EditKind GrowOn::kKind
    = scene::make_edit_kind<GrowOn, list, applied, described>("grow_on");
constexpr scene::EditKind ChangeHabit::kKind
    = scene::make_edit_kind<ChangeHabit, list, applied, described>("change_habit");

} // namespace tractus::self_organising
