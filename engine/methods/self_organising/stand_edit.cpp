#include "engine/methods/self_organising/grown_tree.h"
#include "engine/methods/self_organising/stand.h"
#include "engine/scene/edit_words.h"
#include "engine/scene/make_edit_kind.h"

#include <fmt/core.h>
#include <utility>

namespace tractus::self_organising {

namespace {

void list(scene::Fields& fields, GrowStand& edit)
{
    fields.field("years", &edit.years);
}

Result<scene::DocumentState> applied(scene::DocumentState state, GrowStand const& edit,
                                     scene::SceneBuilder& builder)
{
    TRY(check_life({ .years = edit.years }));
    Stand::Place place { .years = edit.years };
    std::vector<std::size_t> numbers; // Indices of the stand's members in the document.
    for (std::size_t i = 0; i < state.plants.size(); ++i) {
        auto const& plant = *state.plants[i];
        if (plant.is_hidden)
            continue;
        if (auto const* const tree = grown_tree_of(plant.source)) {
            numbers.push_back(i);
            place.members.push_back({ *tree, plant.stands_at_mm });
        } else {
            place.others.push_back(state.plants[i]);
        }
    }
    if (numbers.empty())
        return fail(Fault::User,
                    "no plant of the drawing has grown by itself or under the brush: "
                    "plant a tree first");
    place.scale = state.scale ? *state.scale : TRY(builder.build(state)).placement.scale;
    auto const stand = std::make_shared<Stand const>(std::move(place));
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        auto tree = stand->place().members[k].tree;
        tree.life.push_back({ .years = edit.years, .stand = stand, .place_in_stand = k });
        TRY(check_age(tree));
        scene::change_plant(state, numbers[k], [&](scene::PlantState& plant) {
            plant.source = source_of(std::move(tree));
            plant.source_edit = state.last_edit;
        });
    }
    return state;
}

std::string described(GrowStand const& edit)
{
    return fmt::format("lets all trees grow on beside each other, {}",
                       scene::counted(static_cast<std::size_t>(std::max(edit.years, 0)), "year"));
}

} // namespace

constexpr scene::EditKind GrowStand::kKind
    = scene::make_edit_kind<GrowStand, list, applied, described>("grow_stand");

} // namespace tractus::self_organising
