#include "engine/plant/plant_addresses.h"
#include "engine/scene/edit_words.h"
#include "engine/scene/make_edit_kind.h"

#include <algorithm>
#include <fmt/core.h>
#include <map>
#include <utility>
#include <vector>

namespace tractus::scene {

namespace {

using Addresses = SharedVector<PathAddress>;

// Applies a change to lists of paths. Lists that shared their elements still do afterwards.
template<typename Change> class ChangedPaths {
public:
    explicit ChangedPaths(Change change)
        : change_(std::move(change))
    {
    }

    Addresses of(Addresses const& at)
    {
        auto const [entry, is_new] = changed_.try_emplace(at.id());
        if (is_new) {
            std::vector<PathAddress> paths;
            for (auto const& path : at)
                paths.push_back(change_(path));
            entry->second = { at, std::move(paths) };
        }
        return entry->second.second;
    }

private:
    Change change_;
    // Original and changed list for each id of an original. The originals are kept alive, since ids
    // are memory addresses, which could be reused.
    std::map<void const*, std::pair<Addresses, Addresses>> changed_;
};

// True if an item at these paths was drawn entirely on the part. Only such an item leaves with the
// part.
bool is_on_part(PartPrefix const& prefix, Addresses const& at)
{
    return !at.empty() && std::all_of(at.begin(), at.end(), [&](PathAddress const& path) {
        return is_in_part(prefix, path.first) && is_in_part(prefix, path.last);
    });
}

// Returns the path of the first stem of a part. An indicator that acts on a whole plant acts below
// this path once the plant is grafted.
PathAddress stem_of(PartPrefix const& prefix)
{
    auto const at = in_part(prefix, SegmentAddress { 0, 0 });
    return { at, at };
}

// Moves the items drawn on `part` to `plant`, of which it becomes a part.
void take_over(PlantState& plant, PlantState const& part, PartPrefix const& prefix)
{
    ChangedPaths paths([&](PathAddress const& path) { return in_part(prefix, path); });
    for (auto stroke : part.strokes) {
        stroke.at = paths.of(stroke.at);
        plant.strokes.push_back(std::move(stroke));
    }
    for (auto indicator : part.indicators) {
        indicator.at = indicator.at.empty() ? Addresses(std::vector { stem_of(prefix) })
                                            : paths.of(indicator.at);
        plant.indicators.push_back(std::move(indicator));
    }
    for (auto const& at : part.hidden_branches)
        plant.hidden_branches.push_back(in_part(prefix, at));
    for (auto graft : part.grafts) {
        graft.prefix = in_part(prefix, graft.prefix);
        graft.at = in_part(prefix, graft.at);
        plant.grafts.push_back(std::move(graft));
    }
}

// Moves the items drawn on a part of `plant` back to `part`, which becomes a plant again.
void hand_back(PlantState& plant, PlantState& part, PartPrefix const& prefix)
{
    ChangedPaths paths([&](PathAddress const& path) { return without_part(prefix, path); });
    for (auto stroke : std::exchange(plant.strokes, {})) {
        bool const goes = is_on_part(prefix, stroke.at);
        if (goes)
            stroke.at = paths.of(stroke.at);
        (goes ? part : plant).strokes.push_back(std::move(stroke));
    }
    for (auto& indicator : std::exchange(plant.indicators, {})) {
        bool const goes = is_on_part(prefix, indicator.at);
        if (goes)
            indicator.at = paths.of(indicator.at);
        (goes ? part : plant).indicators.push_back(std::move(indicator));
    }
    for (auto& at : std::exchange(plant.hidden_branches, {})) {
        bool const goes = is_in_part(prefix, at);
        (goes ? part : plant).hidden_branches.push_back(goes ? without_part(prefix, at) : at);
    }
    for (auto& graft : std::exchange(plant.grafts, {})) {
        if (graft.prefix == prefix)
            continue;
        bool const goes = is_in_part(prefix, graft.prefix);
        if (goes) {
            graft.prefix = without_part(prefix, graft.prefix);
            graft.at = without_part(prefix, graft.at);
        }
        (goes ? part : plant).grafts.push_back(std::move(graft));
    }
    plant.selection.clear();
}

void erase_plant(DocumentState& state, std::size_t number)
{
    state.plants.erase(state.plants.begin() + static_cast<std::ptrdiff_t>(number));
}

void list(Fields& fields, GraftPlant& edit)
{
    fields.sparse_field("plant", &edit.plant);
    fields.field("onto", &edit.onto);
    fields.field("at", &edit.at);
    fields.field("turn_rad", &edit.turn_rad);
    fields.field("base_mm", &edit.base_mm);
}

Result<DocumentState> applied(DocumentState state, GraftPlant const& edit, SceneBuilder&)
{
    auto const id = edit.plant == 0 ? state.active : edit.plant;
    auto const number = TRY(plant_number(state, id));
    TRY(plant_number(state, edit.onto));
    if (id == edit.onto)
        return fail(Fault::User, "a plant cannot stand on itself: choose a branch of another one");
    if (edit.at.empty() || !edit.turn_rad.allFinite() || !edit.base_mm.allFinite())
        return fail(Fault::User, "the place for the plant is not on a branch: choose it again");
    auto const part = state.plants[number];
    erase_plant(state, number);
    if (state.active == id)
        state.active = edit.onto;
    change_plant(state, TRY(plant_number(state, edit.onto)), [&](PlantState& plant) {
        Graft graft { .prefix = part_prefix(id),
                      .name = part->name,
                      .source = part->source,
                      .source_edit = part->source_edit,
                      .paper_mm = part->paper_mm,
                      .growth = part->growth,
                      .at = edit.at,
                      .turn_rad = edit.turn_rad,
                      .base_mm = edit.base_mm };
        plant.grafts.push_back(std::move(graft));
        take_over(plant, *part, part_prefix(id));
    });
    return state;
}

std::string described(GraftPlant const& edit)
{
    return fmt::format("puts {} on a branch of plant {}",
                       edit.plant == 0 ? "it" : "plant " + name_of(edit.plant), name_of(edit.onto));
}

void list(Fields& fields, TakeOffGraft& edit)
{
    fields.field("plant", &edit.plant);
    fields.field("graft", &edit.graft);
    fields.field("stands_at_mm", &edit.stands_at_mm);
    fields.id(edit.id);
}

Result<DocumentState> applied(DocumentState state, TakeOffGraft const& edit, SceneBuilder&)
{
    if (!edit.stands_at_mm.allFinite())
        return fail(Fault::User, "the place for the plant is not a number: choose it again");
    auto const number = TRY(plant_number(state, edit.plant));
    auto const prefix = part_prefix(edit.graft);
    auto const& grafts = state.plants[number]->grafts;
    auto const found = std::find_if(grafts.begin(), grafts.end(),
                                    [&](Graft const& graft) { return graft.prefix == prefix; });
    if (found == grafts.end())
        return fail(Fault::User,
                    fmt::format("plant {} has no part {} any more", name_of(edit.plant),
                                name_of(edit.graft)));
    if (found->limb)
        return fail(
            Fault::User,
            fmt::format("{} was drawn and is no plant of its own: erase it instead", found->name));
    PlantState part { .id = take_id(state, edit.id),
                      .name = found->name,
                      .source = found->source,
                      .source_edit = found->source_edit,
                      .stands_at_mm = edit.stands_at_mm,
                      .paper_mm = found->paper_mm,
                      .growth = found->growth };
    change_plant(state, number, [&](PlantState& plant) { hand_back(plant, part, prefix); });
    state.active = part.id;
    state.plants.push_back(std::make_shared<PlantState const>(std::move(part)));
    return state;
}

std::string described(TakeOffGraft const& edit)
{
    return fmt::format("takes {} off plant {}", name_of(edit.graft), name_of(edit.plant));
}

void list(Fields& fields, HideBranch& edit)
{
    fields.field("plant", &edit.plant);
    fields.field("at", &edit.at);
    fields.field("hidden", &edit.hidden);
}

Result<DocumentState> applied(DocumentState state, HideBranch const& edit, SceneBuilder&)
{
    if (edit.at.empty())
        return fail(Fault::User, "there is no branch to hide: choose one");
    auto const number = TRY(plant_number(state, edit.plant));
    auto const& hidden = state.plants[number]->hidden_branches;
    bool const is_hidden = std::find(hidden.begin(), hidden.end(), edit.at) != hidden.end();
    if (is_hidden == edit.hidden)
        return fail(Fault::User,
                    edit.hidden ? "the branch is hidden already" : "no such branch is hidden");
    change_plant(state, number, [&](PlantState& plant) {
        if (edit.hidden)
            plant.hidden_branches.push_back(edit.at);
        else
            std::erase(plant.hidden_branches, edit.at);
    });
    return state;
}

std::string described(HideBranch const& edit)
{
    return fmt::format("{} a branch of plant {}", edit.hidden ? "hides" : "shows",
                       name_of(edit.plant));
}

} // namespace

constexpr EditKind GraftPlant::kKind
    = make_edit_kind<GraftPlant, list, applied, described>("graft_plant");

constexpr EditKind TakeOffGraft::kKind
    = make_edit_kind<TakeOffGraft, list, applied, described>("take_off_graft");

constexpr EditKind HideBranch::kKind
    = make_edit_kind<HideBranch, list, applied, described>("hide_branch");

} // namespace tractus::scene
