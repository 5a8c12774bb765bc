#include "engine/scene/edit_words.h"
#include "engine/scene/make_edit_kind.h"
#include "engine/stroke/derived_tips.h"
#include "engine/stroke/oversketch.h"

#include <algorithm>
#include <array>
#include <fmt/core.h>
#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace tractus {

namespace {

// In the order of the enumerations' values.
constexpr std::array kPropagations { "selected", "descendants", "both" };
constexpr std::array kFits { "start", "chord", "world" };

// After hours of drawing each branch has been drawn many times: its place is held once.
void share_with_earlier(PlantState const& plant, Anchored<ShapingStroke>& drawn)
{
    for (auto i = plant.strokes.size(); i-- > 0;)
        if (plant.strokes[i].at == drawn.at) {
            drawn.at = plant.strokes[i].at;
            return;
        }
}

// A stroke by its number among those of a plant, and that plant's number.
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
    std::map<ItemId, StrokeNumber> all; // Looked through once, however many are wanted.
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

// Each once, the last first: the others keep their numbers when it goes. Refuses strokes that are
// not there, and none at all.
Result<std::vector<StrokeNumber>> find_strokes(DocumentState const& state, Items const& strokes)
{
    if (strokes.empty())
        return fail(Fault::User, "no stroke is chosen: select a branch that has been drawn");
    auto found = TRY(numbered_strokes(state, strokes.numbers));
    for (auto const& stroke : TRY(named_strokes(state, strokes.ids)))
        found.push_back(stroke);
    std::sort(found.begin(), found.end(), std::greater<> {});
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

void replace_stroke(DocumentState& state, StrokeNumber const& number,
                    Anchored<ShapingStroke> stroke)
{
    change_plant(state, number.first, [&](PlantState& plant) {
        plant.strokes.replace(number.second, std::move(stroke));
    });
}

// As find_strokes() understands them: what older sessions count from 0, people count from 1.
std::string names_of(Items const& strokes)
{
    return strokes.ids.empty() ? list_numbers(strokes.numbers) : list_names(strokes.ids);
}

void list(Fields& fields, Items& strokes)
{
    fields.sparse_field("strokes", &strokes.ids);
    fields.sparse_field("associations", &strokes.numbers);
}

// Puts what `change` makes of them in the place of strokes. One stroke for several branches stays
// one: its tips are held once.
Result<DocumentState>
with_changed_strokes(DocumentState state, Items const& strokes,
                     std::function<Result<Stroke>(Stroke const& drawn)> const& change)
{
    Stroke drawn;
    Stroke changed;
    for (auto const& number : TRY(find_strokes(state, strokes))) {
        auto stroke = state.plants[number.first]->strokes[number.second];
        if (stroke.what.stroke.tips.id() != drawn.tips.id()) {
            drawn = stroke.what.stroke;
            changed = TRY(change(drawn));
        }
        stroke.what.stroke = changed;
        TRY(check_shaping_stroke(stroke.what));
        replace_stroke(state, number, std::move(stroke));
    }
    return state;
}

void list(Fields& fields, Associate& edit)
{
    fields.word("propagation", edit.propagation, kPropagations);
    fields.word("fit", edit.fit, kFits);
    fields.field("kept_hand", &edit.detail_weight);
    fields.id(edit.id);
    fields.numbers(edit.stroke);
}

Result<DocumentState> applied(DocumentState state, Associate const& edit, SceneBuilder&)
{
    auto const* const active = active_plant(state);
    if (!active || active->selection.empty())
        return fail(Fault::User,
                    "nothing is selected for the stroke to shape: select a branch first");
    ShapingStroke const stroke { edit.stroke, edit.propagation, edit.fit, edit.detail_weight };
    // Refused here, at its own edit, rather than later when the plant is grown.
    TRY(check_shaping_stroke(stroke));
    auto const edit_number = edit_of_item(take_id(state, edit.id));
    change_active(state, [&](PlantState& plant) {
        std::size_t item = 0;
        for (auto const& at : plant.selection) {
            Anchored<ShapingStroke> drawn { item_id(edit_number, item++), stroke, { at } };
            share_with_earlier(plant, drawn);
            plant.strokes.push_back(std::move(drawn));
        }
    });
    return state;
}

std::string described(Associate const& edit)
{
    static constexpr std::array kWhat { "what is selected", "what the selected bears",
                                        "what is selected and bears" };
    static constexpr std::array kHow { "", ", tip where it was", ", as in the world" };
    return fmt::format("shapes {} by a stroke: {}{}",
                       kWhat[static_cast<std::size_t>(edit.propagation)],
                       describe_stroke(edit.stroke), kHow[static_cast<std::size_t>(edit.fit)]);
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
    for (auto const& number : TRY(find_strokes(state, edit.strokes))) {
        auto stroke = state.plants[number.first]->strokes[number.second];
        stroke.what.detail_weight = edit.detail_weight;
        TRY(check_shaping_stroke(stroke.what));
        replace_stroke(state, number, std::move(stroke));
    }
    return state;
}

std::string described(SmoothStroke const& edit)
{
    return fmt::format("smooths stroke {}, keeping {:.0f} % of the hand", names_of(edit.strokes),
                       100 * edit.detail_weight);
}

void list(Fields& fields, DeleteStroke& edit)
{
    list(fields, edit.strokes);
}

Result<DocumentState> applied(DocumentState state, DeleteStroke const& edit, SceneBuilder&)
{
    for (auto const& number : TRY(find_strokes(state, edit.strokes)))
        change_plant(state, number.first,
                     [&](PlantState& plant) { plant.strokes.erase(number.second); });
    return state;
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

constexpr EditKind DeleteStroke::kKind
    = make_edit_kind<DeleteStroke, list, applied, described>("delete_stroke");

constexpr EditKind EraseTips::kKind
    = make_edit_kind<EraseTips, list, applied, described>("erase_tips");

} // namespace tractus
