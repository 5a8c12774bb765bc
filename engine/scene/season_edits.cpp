#include "engine/scene/make_edit_kind.h"

#include <fmt/core.h>
#include <memory>
#include <utility>

namespace tractus::scene {

namespace {

void list(Fields& fields, KeepLeaves& edit)
{
    fields.field("name", &edit.name);
    fields.field("sheet", &edit.sheet);
}

Result<DocumentState> applied(DocumentState state, KeepLeaves const& edit, SceneBuilder&)
{
    if (!lsystem::parse_leaf_sheet_name(edit.name))
        return fail(Fault::User, fmt::format("{} names no leaves", edit.name));
    state.leaf_sheets[edit.name] = std::make_shared<lsystem::LeafSheet const>(
        TRY(lsystem::parse_leaf_sheet(edit.name, edit.sheet)));
    return state;
}

std::string described(KeepLeaves const& edit)
{
    auto const order = lsystem::parse_leaf_sheet_name(edit.name);
    return order ? fmt::format("keeps {} leaves of {}, of age {:.2g}", order->variants,
                               order->grammar, order->age)
                 : fmt::format("keeps leaves, {}", edit.name);
}

void list(Fields& fields, SetSeason& edit)
{
    fields.field("month", &edit.month);
    fields.field("fallen", &edit.fallen);
}

Result<DocumentState> applied(DocumentState state, SetSeason const& edit, SceneBuilder&)
{
    if (edit.month != 0 && !(edit.month >= 1 && edit.month < 13))
        return fail(Fault::User,
                    fmt::format("there is no month {}: give 1 to below 13, or 0 for no season",
                                edit.month));
    if (!(edit.fallen >= 0 && edit.fallen <= 1))
        return fail(Fault::User,
                    fmt::format("{} is no share of the fallen leaves: give 0 to 1", edit.fallen));
    state.season.reset();
    if (edit.month != 0)
        state.season = Season { edit.month, edit.fallen };
    return state;
}

std::string described(SetSeason const& edit)
{
    return edit.month == 0 ? "shows the plants as they are without a season"
                           : fmt::format("shows the plants in {}, {:.0f} % of the fallen leaves "
                                         "on the ground",
                                         month_name(edit.month), 100 * edit.fallen);
}

} // namespace

constexpr EditKind KeepLeaves::kKind
    = make_edit_kind<KeepLeaves, list, applied, described>("keep_leaves");

constexpr EditKind SetSeason::kKind
    = make_edit_kind<SetSeason, list, applied, described>("set_season");

} // namespace tractus::scene
