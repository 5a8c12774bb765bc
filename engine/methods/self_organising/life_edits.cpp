#include "engine/methods/self_organising/grown_tree.h"
#include "engine/scene/edit_words.h"
#include "engine/scene/make_edit_kind.h"
#include "engine/stroke/foot_first.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fmt/core.h>
#include <optional>
#include <string>
#include <utility>

namespace tractus::self_organising {

namespace {

// World millimetres per plant millimetre of a tree that is begun by a stroke in a document without
// a scale.
constexpr double kUsualScale = 0.1;

void list_habit(scene::Fields& fields, Habit& habit)
{
    fields.field("habit", &habit.name);
    fields.sparse_field("latin", &habit.latin);
    fields.sparse_field("leaves", &habit.leaves);
    fields.sparse_field("bark", &habit.bark);
    for (auto const& number : habit_numbers())
        if (number.is_sparse)
            fields.sparse_field(number.key, &(habit.*number.value));
        else
            fields.field(number.key, &(habit.*number.value));
}

void list_part(scene::Fields& fields, LifePeriod& part)
{
    bool prunes = part.kind == LifePeriod::Kind::Prune;
    bool clears = part.kind == LifePeriod::Kind::Clear;
    fields.sparse_field("prunes", &prunes);
    fields.sparse_field("clears", &clears);
    part.kind = prunes ? LifePeriod::Kind::Prune
        : clears       ? LifePeriod::Kind::Clear
                       : LifePeriod::Kind::Grow;
    fields.field("years", &part.years);
    fields.sparse_field("is_volume", &part.is_volume);
    fields.field("least_radius", &part.min_radius_mm);
    fields.field("most_radius", &part.most_radius_mm);
    fields.field("waits_outside", &part.waits_outside);
    fields.sparse_field("seconds_per_year", &part.seconds_per_year);
    fields.sparse_field("turned_round", &part.is_drawn_reversed);
    fields.numbers(part.stroke);
}

std::string describe_part(LifePeriod const& part)
{
    if (part.kind != LifePeriod::Kind::Grow)
        return fmt::format("{} along a brush: {}",
                           part.kind == LifePeriod::Kind::Prune ? "pruned" : "with space cleared",
                           scene::describe_stroke(part.stroke));
    auto const years = scene::counted(static_cast<std::size_t>(std::max(part.years, 0)), "year");
    if (part.is_volume)
        return fmt::format("{} in a volume of {}", years,
                           scene::counted(part.stroke.tips.size(), "ball"));
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
    if (edit.first.kind != LifePeriod::Kind::Grow)
        return fail(Fault::User,
                    "a new tree has nothing to cut and no space to clear: let it grow "
                    "first");
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

// Applies `change` to a tree and returns the document with the changed tree in its place.
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
    if (edit.next.kind == LifePeriod::Kind::Prune)
        return fmt::format("prunes {} along a brush: {}", scene::name_of(edit.plant),
                           scene::describe_stroke(edit.next.stroke));
    if (edit.next.kind == LifePeriod::Kind::Clear)
        return fmt::format("clears space of {} along a brush: {}", scene::name_of(edit.plant),
                           scene::describe_stroke(edit.next.stroke));
    return fmt::format("lets {} grow on, {}", scene::name_of(edit.plant), describe_part(edit.next));
}

void list(scene::Fields& fields, GrowFrom& edit)
{
    fields.field("plant", &edit.plant);
    fields.field("seed", &edit.seed);
    fields.sparse_field("kept_axes", &edit.kept_axes);
    list_habit(fields, edit.habit);
    list_part(fields, edit.next);
}

Result<scene::DocumentState> applied(scene::DocumentState state, GrowFrom const& edit,
                                     scene::SceneBuilder& builder)
{
    TRY(check_habit(edit.habit));
    TRY(check_life(edit.next));
    auto const number = TRY(scene::plant_number(state, edit.plant));
    auto const start = TRY(
        beginning_from(state, number, edit.kept_axes, !edit.next.stroke.tips.empty(), builder));
    auto part = edit.next;
    if (!part.stroke.tips.empty())
        state.scale = start->scale;
    part.scale = start->scale;
    part.stands_at_mm = start->plant->stands_at_mm;
    GrownTree tree {
        .habit = edit.habit, .seed = edit.seed, .life = { std::move(part) }, .start = start
    };
    TRY(check_age(tree));
    scene::change_plant(state, number, [&](scene::PlantState& plant) {
        plant.source = source_of(std::move(tree));
        plant.source_edit = state.last_edit;
        plant.grafts.clear();
        plant.hidden_branches.clear();
        plant.selection = {};
        plant.strokes = {};
        plant.indicators.clear();
    });
    return state;
}

std::string described(GrowFrom const& edit)
{
    return fmt::format("lets {} grow on as it stands by the habit {}, {}",
                       scene::name_of(edit.plant), edit.habit.name, describe_part(edit.next));
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

void list(scene::Fields& fields, TurnBrushStroke& edit)
{
    fields.field("plant", &edit.plant);
}

Result<scene::DocumentState> applied(scene::DocumentState state, TurnBrushStroke const& edit,
                                     scene::SceneBuilder&)
{
    auto const number = TRY(scene::plant_number(state, edit.plant));
    auto const* const tree = grown_tree_of(state.plants[number]->source);
    std::optional<std::size_t> newest;
    for (std::size_t i = 0; tree && i < tree->life.size(); ++i)
        if (tree->life[i].kind == LifePeriod::Kind::Grow && !tree->life[i].stroke.tips.empty())
            newest = i;
    if (!newest)
        return fail(Fault::User,
                    fmt::format("plant {} has grown along no brush stroke that could be turned "
                                "round",
                                scene::name_of(edit.plant)));
    auto part = tree->life[*newest];
    part.stroke = turned_round({ TRY(part.stroke.tips.in_memory()) });
    part.is_drawn_reversed = !part.is_drawn_reversed;
    if (*newest == 0 && !tree->start) {
        Vec3 const moved_mm = part.stroke.tips.front().position_mm - part.stands_at_mm;
        part.stands_at_mm += moved_mm;
        scene::change_plant(state, number,
                            [&](scene::PlantState& plant) { plant.stands_at_mm += moved_mm; });
    }
    return changed(std::move(state), edit.plant,
                   [&](GrownTree& grown) { grown.life[*newest] = std::move(part); });
}

std::string described(TurnBrushStroke const& edit)
{
    return fmt::format("turns the newest brush stroke of {} round", scene::name_of(edit.plant));
}

std::string described(ChangeHabit const& edit)
{
    return fmt::format("lets {} grow again by the habit {}, seed {}", scene::name_of(edit.plant),
                       edit.habit.name, edit.seed);
}

} // namespace

constexpr scene::EditKind PlantTree::kKind
    = scene::make_edit_kind<PlantTree, list, applied, described>("plant_tree", true);
constexpr scene::EditKind GrowOn::kKind
    = scene::make_edit_kind<GrowOn, list, applied, described>("grow_on");
constexpr scene::EditKind GrowFrom::kKind
    = scene::make_edit_kind<GrowFrom, list, applied, described>("grow_from", true);
constexpr scene::EditKind TurnBrushStroke::kKind
    = scene::make_edit_kind<TurnBrushStroke, list, applied, described>("turn_brush_stroke");
constexpr scene::EditKind ChangeHabit::kKind
    = scene::make_edit_kind<ChangeHabit, list, applied, described>("change_habit");

} // namespace tractus::self_organising
