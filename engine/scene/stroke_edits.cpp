#include "engine/scene/edit_words.h"
#include "engine/scene/make_edit_kind.h"
#include "engine/stroke/derived_tips.h"
#include "engine/stroke/foot_first.h"
#include "engine/stroke/oversketch.h"

#include <algorithm>
#include <array>
#include <fmt/core.h>
#include <functional>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

namespace tractus::scene {

namespace {

// Words for Propagation, StrokeFit and StrokeLaying in sessions, in the order of the enumerations.
constexpr std::array kPropagations { "selected", "descendants", "both" };
constexpr std::array kFits { "start", "chord", "world" };
constexpr std::array kLayings { "least_twist", "heading" };

struct AddressHash {
    std::size_t operator()(PathAddress const& path) const
    {
        std::size_t hash = 0;
        for (auto const* const address : { &path.first, &path.last })
            for (auto const number : *address)
                hash = (hash ^ number) * 0x100000001B3u;
        return hash;
    }
};

using Place = SharedVector<PathAddress>;

// Returns the wanted addresses, each sharing its elements with an earlier stroke at the same
// address. Each address is thus stored once, even after hours of drawing, when many strokes have
// the same one.
std::vector<Place> shared_places(SharedList<Anchored<variation::ShapingStroke>> const& strokes,
                                 SharedVector<PathAddress> const& wanted)
{
    std::unordered_map<PathAddress, Place, AddressHash> places;
    for (auto const& at : wanted)
        places.try_emplace(at, Place { at });
    std::size_t left = places.size();
    for (auto i = strokes.size(); i-- > 0 && left > 0;) {
        auto const& at = strokes[i].at;
        auto const found = at.size() == 1 ? places.find(at.front()) : places.end();
        if (found == places.end() || found->second.id() == at.id())
            continue;
        found->second = at;
        --left;
    }
    std::vector<Place> shared;
    for (auto const& at : wanted)
        shared.push_back(places.at(at));
    return shared;
}

// Index of a plant, and index of a stroke of that plant.
using StrokeNumber = std::pair<std::size_t, std::size_t>;

Result<std::vector<StrokeNumber>> numbered_strokes(DocumentState const& state,
                                                   std::vector<std::uint64_t> const& numbers)
{
    std::vector<StrokeNumber> found;
    auto const active = find_plant(state, state.active);
    auto const count = active ? state.plants[*active]->strokes.size() : 0;
    for (auto const number : numbers) {
        if (number >= count)
            return fail(Fault::User,
                        fmt::format("there is no stroke {}: the scene has {}", number + 1, count));
        found.emplace_back(*active, number);
    }
    return found;
}

Result<std::vector<StrokeNumber>> named_strokes(DocumentState const& state,
                                                std::vector<ItemId> const& ids)
{
    // All strokes by id: collected in one pass, however many are wanted.
    std::map<ItemId, StrokeNumber> all;
    for (std::size_t i = 0; i < state.plants.size() && !ids.empty(); ++i)
        for (std::size_t k = 0; k < state.plants[i]->strokes.size(); ++k)
            all.emplace(state.plants[i]->strokes[k].id, StrokeNumber(i, k));
    std::vector<StrokeNumber> found;
    for (auto const id : ids) {
        auto const stroke = all.find(id);
        if (stroke == all.end())
            return fail(Fault::User, fmt::format("there is no stroke {} any more", name_of(id)));
        found.push_back(stroke->second);
    }
    return found;
}

// Returns the strokes, each once, in the order of plants and of strokes in a plant. Fails if one of
// them does not exist or the list is empty.
Result<std::vector<StrokeNumber>> find_strokes(DocumentState const& state, Items const& strokes)
{
    if (strokes.empty())
        return fail(Fault::User, "no stroke is chosen: select a branch that has been drawn");
    auto found = TRY(numbered_strokes(state, strokes.numbers));
    for (auto const& stroke : TRY(named_strokes(state, strokes.ids)))
        found.push_back(stroke);
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

// Calls `change(plant, numbers)` for each plant that has some of the strokes. `found` is the result
// of find_strokes().
template<typename Change>
Result<DocumentState> change_plants(DocumentState state, std::vector<StrokeNumber> const& found,
                                    Change const& change)
{
    for (auto stroke = found.begin(); stroke != found.end();) {
        auto const plant = stroke->first;
        std::vector<std::size_t> numbers;
        for (; stroke != found.end() && stroke->first == plant; ++stroke)
            numbers.push_back(stroke->second);
        Result<void> changed;
        change_plant(state, plant,
                     [&](PlantState& of) { changed = change(of, std::as_const(numbers)); });
        TRY(std::move(changed));
    }
    return state;
}

// Replaces strokes by copies that `change` has modified. Fails if `change` fails.
Result<DocumentState>
with_other_strokes(DocumentState state, Items const& strokes,
                   std::function<Result<void>(variation::ShapingStroke&)> const& change)
{
    auto const found = TRY(find_strokes(state, strokes));
    return change_plants(
        std::move(state), found,
        [&](PlantState& plant, std::vector<std::size_t> const& numbers) -> Result<void> {
            std::vector<std::pair<std::size_t, Anchored<variation::ShapingStroke>>> changed;
            for (auto const number : numbers) {
                auto stroke = plant.strokes[number];
                TRY(change(stroke.what));
                TRY(variation::check_shaping_stroke(stroke.what));
                changed.emplace_back(number, std::move(stroke));
            }
            plant.strokes.replace(std::move(changed));
            return {};
        });
}

// Returns the names of strokes for display: their ids or, in sessions without ids, their numbers,
// counted from 1.
std::string names_of(Items const& strokes)
{
    return strokes.ids.empty() ? list_numbers(strokes.numbers) : list_names(strokes.ids);
}

void list(Fields& fields, Items& strokes)
{
    fields.sparse_field("strokes", &strokes.ids);
    fields.sparse_field("associations", &strokes.numbers);
}

// Replaces strokes by those that `change` returns. Branches that shared a stroke share the new one,
// so that its tips are stored once.
Result<DocumentState>
with_changed_strokes(DocumentState state, Items const& strokes,
                     std::function<Result<Stroke>(Stroke const& drawn)> const& change)
{
    Stroke drawn;
    Stroke changed;
    return with_other_strokes(std::move(state), strokes,
                              [&](variation::ShapingStroke& stroke) -> Result<void> {
                                  if (stroke.stroke.tips.id() != drawn.tips.id()) {
                                      drawn = stroke.stroke;
                                      changed = TRY(change(drawn));
                                  }
                                  stroke.stroke = changed;
                                  return {};
                              });
}

void list(Fields& fields, Associate& edit)
{
    fields.word("propagation", edit.propagation, kPropagations);
    fields.word("fit", edit.fit, kFits);
    fields.field("kept_hand", &edit.detail_weight);
    fields.word("laying", edit.laying, kLayings);
    fields.sparse_field("turned_round", &edit.is_drawn_reversed);
    fields.id(edit.id);
    fields.numbers(edit.stroke);
}

Result<DocumentState> applied(DocumentState state, Associate const& edit, SceneBuilder&)
{
    auto const* const active = active_plant(state);
    if (!active || active->selection.empty())
        return fail(Fault::User,
                    "nothing is selected for the stroke to shape: select a branch first");
    variation::ShapingStroke const stroke { edit.stroke, edit.propagation,
                                            edit.fit,    edit.detail_weight,
                                            edit.laying, edit.is_drawn_reversed };
    // Checked here, so that this edit fails instead of the plant's growth later.
    TRY(variation::check_shaping_stroke(stroke));
    auto const edit_number = edit_of_item(take_id(state, edit.id));
    change_active(state, [&](PlantState& plant) {
        std::vector<Anchored<variation::ShapingStroke>> drawn;
        for (auto& at : shared_places(plant.strokes, plant.selection))
            drawn.push_back({ item_id(edit_number, drawn.size()), stroke, std::move(at) });
        plant.strokes.append(std::move(drawn));
    });
    return state;
}

std::string described(Associate const& edit)
{
    static constexpr std::array kWhat { "what is selected", "what the selected bears",
                                        "what is selected and bears" };
    static constexpr std::array kHow { "", ", tip where it was", ", as in the world" };
    return fmt::format("shapes {} by a stroke{}: {}{}",
                       kWhat[static_cast<std::size_t>(edit.propagation)],
                       edit.is_drawn_reversed ? ", turned round" : "", describe_stroke(edit.stroke),
                       kHow[static_cast<std::size_t>(edit.fit)]);
}

void list(Fields& fields, Oversketch& edit)
{
    list(fields, edit.strokes);
    fields.numbers(edit.over);
}

Result<DocumentState> applied(DocumentState state, Oversketch const& edit, SceneBuilder&)
{
    return with_changed_strokes(
        std::move(state), edit.strokes, [&](Stroke const& drawn) -> Result<Stroke> {
            auto const tips = TRY(drawn.tips.in_memory());
            auto const redrawn = TRY(oversketch({ tips }, edit.over));
            return Stroke { { redrawn.tips.vector(),
                              redrawn_source(drawn.tips.source(), edit.over.tips.source()) } };
        });
}

std::string described(Oversketch const& edit)
{
    return fmt::format("redraws a part of stroke {}: {}", names_of(edit.strokes),
                       describe_stroke(edit.over));
}

void list(Fields& fields, SmoothStroke& edit)
{
    list(fields, edit.strokes);
    fields.field("kept_hand", &edit.detail_weight);
}

Result<DocumentState> applied(DocumentState state, SmoothStroke const& edit, SceneBuilder&)
{
    return with_other_strokes(std::move(state), edit.strokes,
                              [&](variation::ShapingStroke& stroke) -> Result<void> {
                                  stroke.detail_weight = edit.detail_weight;
                                  return {};
                              });
}

std::string described(SmoothStroke const& edit)
{
    return fmt::format("smooths stroke {}, keeping {:.0f} % of the hand", names_of(edit.strokes),
                       100 * edit.detail_weight);
}

void list(Fields& fields, TurnStroke& edit)
{
    list(fields, edit.strokes);
}

Result<DocumentState> applied(DocumentState state, TurnStroke const& edit, SceneBuilder&)
{
    auto const turn = [](Stroke const& drawn) -> Result<Stroke> {
        return turned_round({ TRY(drawn.tips.in_memory()) });
    };
    auto turned = TRY(with_changed_strokes(std::move(state), edit.strokes, turn));
    return with_other_strokes(std::move(turned), edit.strokes,
                              [](variation::ShapingStroke& stroke) -> Result<void> {
                                  stroke.is_drawn_reversed = !stroke.is_drawn_reversed;
                                  return {};
                              });
}

std::string described(TurnStroke const& edit)
{
    return fmt::format("turns stroke {} round", names_of(edit.strokes));
}

void list(Fields& fields, DeleteStroke& edit)
{
    list(fields, edit.strokes);
}

Result<DocumentState> applied(DocumentState state, DeleteStroke const& edit, SceneBuilder&)
{
    auto const found = TRY(find_strokes(state, edit.strokes));
    return change_plants(
        std::move(state), found,
        [](PlantState& plant, std::vector<std::size_t> const& numbers) -> Result<void> {
            plant.strokes.erase(numbers);
            return {};
        });
}

std::string described(DeleteStroke const& edit)
{
    return fmt::format("takes stroke {} away", names_of(edit.strokes));
}

void list(Fields& fields, EraseTips& edit)
{
    list(fields, edit.strokes);
    fields.field("ranges", &edit.ranges);
}

Result<DocumentState> applied(DocumentState state, EraseTips const& edit, SceneBuilder&)
{
    return with_changed_strokes(
        std::move(state), edit.strokes, [&](Stroke const& drawn) -> Result<Stroke> {
            auto const tips = TRY(drawn.tips.in_memory());
            auto const rest = TRY(erase_tips({ tips }, edit.ranges));
            return Stroke { { rest.tips.vector(),
                              erased_source(drawn.tips.source(), edit.ranges) } };
        });
}

std::string described(EraseTips const& edit)
{
    std::size_t count = 0;
    for (auto const& [first, last] : edit.ranges)
        count += last + 1 - first;
    return fmt::format("erases {} of stroke {}", counted(count, "tip"), names_of(edit.strokes));
}

} // namespace

constexpr EditKind Associate::kKind
    = make_edit_kind<Associate, list, applied, described>("associate");

constexpr EditKind Oversketch::kKind
    = make_edit_kind<Oversketch, list, applied, described>("oversketch");

constexpr EditKind SmoothStroke::kKind
    = make_edit_kind<SmoothStroke, list, applied, described>("smooth_stroke");

constexpr EditKind TurnStroke::kKind
    = make_edit_kind<TurnStroke, list, applied, described>("turn_stroke");

constexpr EditKind DeleteStroke::kKind
    = make_edit_kind<DeleteStroke, list, applied, described>("delete_stroke");

constexpr EditKind EraseTips::kKind
    = make_edit_kind<EraseTips, list, applied, described>("erase_tips");

} // namespace tractus::scene
