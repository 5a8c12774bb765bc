#include "engine/scene/document_state.h"

#include <algorithm>
#include <fmt/core.h>
#include <utility>

namespace tractus::scene {

bool Graft::operator==(Graft const& other) const
{
    return prefix == other.prefix && source == other.source && at == other.at
        && turn_rad == other.turn_rad && base_mm == other.base_mm && limb == other.limb;
}

std::optional<std::size_t> find_plant(DocumentState const& state, ItemId id)
{
    auto const found = std::find_if(state.plants.begin(), state.plants.end(),
                                    [&](auto const& plant) { return plant->id == id; });
    if (found == state.plants.end())
        return std::nullopt;
    return static_cast<std::size_t>(found - state.plants.begin());
}

Result<std::size_t> plant_number(DocumentState const& state, ItemId id)
{
    auto const number = find_plant(state, id);
    if (!number)
        return fail(Fault::User, fmt::format("there is no plant {} any more", name_of(id)));
    return *number;
}

PlantState const* active_plant(DocumentState const& state)
{
    auto const number = find_plant(state, state.active);
    return number ? state.plants[*number].get() : nullptr;
}

void change_plant(DocumentState& state, std::size_t number,
                  std::function<void(PlantState& plant)> const& change)
{
    auto changed = *state.plants[number];
    change(changed);
    state.plants[number] = std::make_shared<PlantState const>(std::move(changed));
}

static void add_plant(DocumentState& state, PlantState plant)
{
    state.active = plant.id;
    state.plants.push_back(std::make_shared<PlantState const>(std::move(plant)));
}

void change_active(DocumentState& state, std::function<void(PlantState& plant)> const& change)
{
    if (!active_plant(state))
        add_plant(state, { .id = item_id(state.last_edit, 0) });
    change_plant(state, *find_plant(state, state.active), change);
}

ItemId take_id(DocumentState& state, ItemId own)
{
    if (own == 0)
        return item_id(state.last_edit, 0);
    state.last_edit = std::max(state.last_edit, edit_of_item(own));
    return own;
}

DocumentState with_source(DocumentState state, NewSource added)
{
    if (added.drawn == Drawn::Beside) {
        auto const id = take_id(state, added.id);
        add_plant(state,
                  { .id = id,
                    .stands_at_mm = added.stands_at_mm,
                    .paper_mm = added.paper_mm,
                    .paper_unit = added.paper_unit });
    }
    change_active(state, [&](PlantState& plant) {
        plant.name = std::move(added.name);
        plant.source = std::move(added.source);
        plant.source_edit = state.last_edit;
        plant.selection.clear();
        if (added.drawn == Drawn::Forget) {
            plant.grafts.clear();
            plant.hidden_branches.clear();
            plant.leaves.clear();
            plant.strokes.clear();
            plant.indicators.clear();
        }
    });
    return state;
}

} // namespace tractus::scene
