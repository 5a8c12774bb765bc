#include "engine/scene/edit_words.h"
#include "engine/scene/limb_edits.h"
#include "engine/scene/make_edit_kind.h"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>
#include <map>
#include <utility>
#include <vector>

namespace tractus::scene {

namespace {

Result<void> check_place(Vec3 const& place_mm)
{
    if (!place_mm.allFinite())
        return fail(Fault::User, "the place for the plant is not a number: choose it again");
    return {};
}

std::string describe_place(Vec3 const& place_mm)
{
    // Adding 0.0 turns -0 into 0.
    auto const whole = [](double mm) { return std::round(mm) + 0.0; };
    return fmt::format("({}, {}, {}) mm", whole(place_mm.x()), whole(place_mm.y()),
                       whole(place_mm.z()));
}

void list(Fields& fields, ActivatePlant& edit)
{
    fields.field("plant", &edit.plant);
}

Result<DocumentState> applied(DocumentState state, ActivatePlant const& edit, SceneBuilder&)
{
    TRY(plant_number(state, edit.plant));
    state.active = edit.plant;
    return state;
}

std::string described(ActivatePlant const& edit)
{
    return fmt::format("goes on with plant {}", name_of(edit.plant));
}

void list(Fields& fields, MovePlant& edit)
{
    fields.field("plant", &edit.plant);
    fields.field("to_mm", &edit.to_mm);
}

Result<DocumentState> applied(DocumentState state, MovePlant const& edit, SceneBuilder&)
{
    TRY(check_place(edit.to_mm));
    change_plant(state, TRY(plant_number(state, edit.plant)),
                 [&](PlantState& plant) { plant.stands_at_mm = edit.to_mm; });
    return state;
}

std::string described(MovePlant const& edit)
{
    return fmt::format("moves plant {} to {}", name_of(edit.plant), describe_place(edit.to_mm));
}

void list(Fields& fields, CopyPlant& edit)
{
    fields.field("plant", &edit.plant);
    fields.field("stands_at_mm", &edit.stands_at_mm);
    fields.id(edit.id);
}

// Gives the items of a copied plant new ids, so that they can be edited separately from the items
// of the original plant.
void rename_items(PlantState& plant, std::uint64_t edit)
{
    std::size_t item = 1;
    std::map<ItemId, ItemId> renamed;
    auto const strokes = std::exchange(plant.strokes, {});
    for (auto stroke : strokes) {
        auto const id = item_id(edit, item++);
        renamed.emplace(stroke.id, id);
        stroke.id = id;
        plant.strokes.push_back(std::move(stroke));
    }
    for (auto& graft : plant.grafts) {
        if (!graft.limb || graft.limb->older_strokes.empty())
            continue;
        auto limb = *graft.limb;
        limb.older_strokes.clear();
        for (auto const id : graft.limb->older_strokes)
            if (auto const found = renamed.find(id); found != renamed.end())
                limb.older_strokes.push_back(found->second);
        graft.limb = std::make_shared<DrawnLimb const>(std::move(limb));
    }
    for (auto& indicator : plant.indicators)
        indicator.id = item_id(edit, item++);
}

Result<DocumentState> applied(DocumentState state, CopyPlant const& edit, SceneBuilder&)
{
    TRY(check_place(edit.stands_at_mm));
    auto copy = *state.plants[TRY(plant_number(state, edit.plant))];
    copy.id = take_id(state, edit.id);
    copy.stands_at_mm = edit.stands_at_mm;
    copy.is_hidden = false;
    rename_items(copy, edit_of_item(copy.id));
    state.active = copy.id;
    state.plants.push_back(std::make_shared<PlantState const>(std::move(copy)));
    return state;
}

std::string described(CopyPlant const& edit)
{
    return fmt::format("copies plant {} to {}", name_of(edit.plant),
                       describe_place(edit.stands_at_mm));
}

void list(Fields& fields, HidePlant& edit)
{
    fields.field("plant", &edit.plant);
    fields.field("hidden", &edit.hidden);
}

Result<DocumentState> applied(DocumentState state, HidePlant const& edit, SceneBuilder&)
{
    change_plant(state, TRY(plant_number(state, edit.plant)),
                 [&](PlantState& plant) { plant.is_hidden = edit.hidden; });
    return state;
}

std::string described(HidePlant const& edit)
{
    return fmt::format("{} plant {}", edit.hidden ? "hides" : "shows", name_of(edit.plant));
}

void list(Fields& fields, NamePlant& edit)
{
    fields.field("plant", &edit.plant);
    fields.field("name", &edit.name);
}

Result<DocumentState> applied(DocumentState state, NamePlant const& edit, SceneBuilder&)
{
    if (edit.name.empty())
        return fail(Fault::User, "a plant needs a name: give one");
    change_plant(state, TRY(plant_number(state, edit.plant)),
                 [&](PlantState& plant) { plant.name = edit.name; });
    return state;
}

std::string described(NamePlant const& edit)
{
    return fmt::format("calls plant {} \"{}\"", name_of(edit.plant), edit.name);
}

void list(Fields& fields, RemovePlant& edit)
{
    fields.field("plant", &edit.plant);
}

Result<DocumentState> applied(DocumentState state, RemovePlant const& edit, SceneBuilder&)
{
    auto const number = TRY(plant_number(state, edit.plant));
    state.plants.erase(state.plants.begin() + static_cast<std::ptrdiff_t>(number));
    if (state.active == edit.plant)
        state.active = state.plants.empty() ? 0 : state.plants[number == 0 ? 0 : number - 1]->id;
    return state;
}

std::string described(RemovePlant const& edit)
{
    return fmt::format("takes plant {} away", name_of(edit.plant));
}

void list(Fields& fields, SetScale& edit)
{
    fields.field("scale", &edit.scale);
}

Result<DocumentState> applied(DocumentState state, SetScale const& edit, SceneBuilder&)
{
    constexpr double kMin = 1e-6;
    constexpr double kMax = 1e6;
    if (!(edit.scale >= kMin && edit.scale <= kMax))
        return fail(Fault::User,
                    fmt::format("plants cannot be shown {} times as large as they are: give {} "
                                "to {}",
                                edit.scale, kMin, kMax));
    state.scale = edit.scale;
    return state;
}

std::string described(SetScale const& edit)
{
    return edit.scale < 1 ? fmt::format("shows plants 1:{:.3g}", 1 / edit.scale)
                          : fmt::format("shows plants {:.3g}:1", edit.scale);
}

} // namespace

constexpr EditKind ActivatePlant::kKind
    = make_edit_kind<ActivatePlant, list, applied, described>("activate_plant");

constexpr EditKind MovePlant::kKind
    = make_edit_kind<MovePlant, list, applied, described>("move_plant");

constexpr EditKind CopyPlant::kKind
    = make_edit_kind<CopyPlant, list, applied, described>("copy_plant");

constexpr EditKind HidePlant::kKind
    = make_edit_kind<HidePlant, list, applied, described>("hide_plant");

constexpr EditKind NamePlant::kKind
    = make_edit_kind<NamePlant, list, applied, described>("name_plant");

constexpr EditKind RemovePlant::kKind
    = make_edit_kind<RemovePlant, list, applied, described>("remove_plant");

constexpr EditKind SetScale::kKind
    = make_edit_kind<SetScale, list, applied, described>("set_scale");

} // namespace tractus::scene
