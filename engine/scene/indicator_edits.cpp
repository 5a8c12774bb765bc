#include "engine/scene/edit_words.h"
#include "engine/scene/make_edit_kind.h"

#include <array>
#include <cmath>
#include <fmt/core.h>
#include <utility>
#include <vector>

namespace tractus::scene {

namespace {

// Words for MotionIndicator::Kind in sessions, in the order of the enumeration.
constexpr std::array kIndicatorKinds { "push", "light" };

void list(Fields& fields, variation::MotionIndicator& indicator)
{
    fields.field("start_mm", &indicator.start_mm);
    fields.field("end_mm", &indicator.end_mm);
    fields.word("kind", indicator.kind, kIndicatorKinds);
    fields.field("below", &indicator.below);
    fields.field("reach_mm", &indicator.reach_mm);
    fields.field("is_orphaned", &indicator.is_orphaned);
}

// Returns the addresses of the segments by which an indicator is given in sessions before format 4.
Result<std::vector<PathAddress>> places_of(variation::MotionIndicator const& indicator,
                                           DocumentState const& state, SceneBuilder& builder)
{
    std::vector<PathAddress> places;
    if (indicator.below.empty())
        return places;
    auto const base = TRY(builder.active_base(state));
    TRY(variation::check_indicator(*base->plant, indicator));
    for (auto const segment : indicator.below) {
        auto const address = base->rest->addresses.address_of(*base->plant, segment);
        places.push_back({ address, address });
    }
    return places;
}

// Returns the indicator without its segments: a document stores their addresses instead.
Result<variation::MotionIndicator> placeless(variation::MotionIndicator indicator)
{
    indicator.below.clear();
    indicator.is_orphaned = false;
    TRY(variation::check_indicator({}, indicator));
    return indicator;
}

// Index of a plant, and index of an indicator of that plant.
using IndicatorNumber = std::pair<std::size_t, std::size_t>;

// Finds an indicator by its id, or, in older sessions without ids, by its number.
Result<IndicatorNumber> find_indicator(DocumentState const& state, ItemId id, std::uint64_t number)
{
    if (id != 0) {
        for (std::size_t i = 0; i < state.plants.size(); ++i) {
            auto const& all = state.plants[i]->indicators;
            for (std::size_t k = 0; k < all.size(); ++k)
                if (all[k].id == id)
                    return IndicatorNumber(i, k);
        }
        return fail(Fault::User,
                    fmt::format("there is no motion indicator {} any more", name_of(id)));
    }
    auto const active = find_plant(state, state.active);
    auto const count = active ? state.plants[*active]->indicators.size() : 0;
    if (number >= count)
        return fail(
            Fault::User,
            fmt::format("there is no motion indicator {}: the scene has {}", number + 1, count));
    return IndicatorNumber(*active, number);
}

std::string name_of_indicator(ItemId id, std::uint64_t number)
{
    return id != 0 ? name_of(id) : std::to_string(number + 1);
}

std::string describe_indicator(variation::MotionIndicator const& indicator, std::size_t places)
{
    Vec3 const way_mm = indicator.end_mm - indicator.start_mm;
    // Adding 0.0 turns -0 into 0.
    auto const whole = [](double mm) { return std::round(mm) + 0.0; };
    auto text
        = fmt::format("({}, {}, {}) mm{}", whole(way_mm.x()), whole(way_mm.y()), whole(way_mm.z()),
                      indicator.kind == variation::MotionIndicator::Kind::Light ? ", light" : "");
    if (auto const below = indicator.below.size() + places; below > 0)
        text += fmt::format(", on {} and what they bear", counted(below, "segment"));
    if (indicator.reach_mm)
        text += fmt::format(", as far as {:.0f} mm", *indicator.reach_mm);
    return text;
}

void list(Fields& fields, Indicate& edit)
{
    list(fields, edit.indicator);
    fields.sparse_field("at", &edit.below);
    fields.id(edit.id);
}

Result<DocumentState> applied(DocumentState state, Indicate const& edit, SceneBuilder& builder)
{
    auto places = TRY(places_of(edit.indicator, state, builder));
    for (auto const& address : edit.below)
        places.push_back({ address, address });
    Anchored<variation::MotionIndicator> drawn { 0, TRY(placeless(edit.indicator)),
                                                 std::move(places) };
    drawn.id = take_id(state, edit.id);
    change_active(state, [&](PlantState& plant) { plant.indicators.push_back(std::move(drawn)); });
    return state;
}

std::string described(Indicate const& edit)
{
    return fmt::format("leans the plant by {}",
                       describe_indicator(edit.indicator, edit.below.size()));
}

void list(Fields& fields, ChangeIndicator& edit)
{
    fields.sparse_field("which", &edit.which);
    fields.sparse_field("number", &edit.number);
    list(fields, edit.indicator);
}

Result<DocumentState> applied(DocumentState state, ChangeIndicator const& edit,
                              SceneBuilder& builder)
{
    auto const number = TRY(find_indicator(state, edit.which, edit.number));
    auto changed = state.plants[number.first]->indicators[number.second];
    // An orphan that is only moved keeps the address of its missing branch.
    if (edit.which == 0 && !edit.indicator.is_orphaned)
        changed.at = TRY(places_of(edit.indicator, state, builder));
    changed.what = TRY(placeless(edit.indicator));
    change_plant(state, number.first,
                 [&](PlantState& plant) { plant.indicators[number.second] = std::move(changed); });
    return state;
}

std::string described(ChangeIndicator const& edit)
{
    return fmt::format("changes motion indicator {}: {}",
                       name_of_indicator(edit.which, edit.number),
                       describe_indicator(edit.indicator, 0));
}

void list(Fields& fields, DeleteIndicator& edit)
{
    fields.sparse_field("which", &edit.which);
    fields.sparse_field("number", &edit.number);
}

Result<DocumentState> applied(DocumentState state, DeleteIndicator const& edit, SceneBuilder&)
{
    auto const number = TRY(find_indicator(state, edit.which, edit.number));
    change_plant(state, number.first, [&](PlantState& plant) {
        plant.indicators.erase(plant.indicators.begin()
                               + static_cast<std::ptrdiff_t>(number.second));
    });
    return state;
}

std::string described(DeleteIndicator const& edit)
{
    return fmt::format("takes motion indicator {} away",
                       name_of_indicator(edit.which, edit.number));
}

} // namespace

constexpr EditKind Indicate::kKind = make_edit_kind<Indicate, list, applied, described>("indicate");

constexpr EditKind ChangeIndicator::kKind
    = make_edit_kind<ChangeIndicator, list, applied, described>("change_indicator");

constexpr EditKind DeleteIndicator::kKind
    = make_edit_kind<DeleteIndicator, list, applied, described>("delete_indicator");

} // namespace tractus::scene
