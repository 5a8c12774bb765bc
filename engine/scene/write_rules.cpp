#include "engine/scene/write_rules.h"

#include "engine/scene/edit_words.h"
#include "engine/scene/make_edit_kind.h"

#include <fmt/format.h>
#include <utility>

namespace tractus::scene {

namespace {

void list(Fields& fields, WriteRules& edit)
{
    fields.field("plant", &edit.plant);
    fields.sparse_field("text", &edit.rules.text);
    fields.sparse_field("view_text", &edit.rules.view_text);
}

Result<DocumentState> applied(DocumentState state, WriteRules const& edit, SceneBuilder&)
{
    auto const number = TRY(plant_number(state, edit.plant));
    auto const& source = state.plants[number]->source;
    if (!source.accepts_rules())
        return fail(Fault::User,
                    fmt::format("plant {} has no rules that one could write", name_of(edit.plant)));
    auto other
        = source.with_rules(edit.rules.text.empty() ? std::nullopt : std::optional(edit.rules));
    change_plant(state, number, [&](PlantState& plant) {
        plant.source = std::move(other);
        plant.source_edit = state.last_edit;
        plant.selection.clear();
    });
    return state;
}

std::string described(WriteRules const& edit)
{
    if (edit.rules.text.empty())
        return fmt::format("gives plant {} the rules of its pattern again", name_of(edit.plant));
    return fmt::format("writes the rules of plant {}: {}", name_of(edit.plant),
                       counted(edit.rules.text.size(), "byte"));
}

} // namespace

constexpr EditKind WriteRules::kKind
    = make_edit_kind<WriteRules, list, applied, described>("write_rules");

} // namespace tractus::scene
