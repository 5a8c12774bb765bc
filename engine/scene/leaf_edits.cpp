#include "engine/lsystem/view/leaf_word.h"
#include "engine/scene/make_edit_kind.h"

#include <fmt/core.h>
#include <map>
#include <utility>

namespace tractus::scene {

namespace {

void list(Fields& fields, SetFoliage& edit)
{
    fields.field("plant", &edit.plant);
    fields.field("leaves", &edit.leaves);
}

Result<DocumentState> applied(DocumentState state, SetFoliage const& edit, SceneBuilder&)
{
    auto const number = TRY(plant_number(state, edit.plant));
    if (!edit.leaves.empty() && !state.leaf_sheets.contains(edit.leaves))
        return fail(Fault::User,
                    fmt::format("the drawing keeps no leaves called \"{}\"", edit.leaves));
    change_plant(state, number, [&](PlantState& plant) { plant.leaves = edit.leaves; });
    return state;
}

std::string described(SetFoliage const& edit)
{
    auto const order = lsystem::parse_leaf_sheet_name(edit.leaves);
    return order ? fmt::format("gives plant {} leaves of {}", name_of(edit.plant), order->grammar)
                 : fmt::format("gives plant {} its own leaves", name_of(edit.plant));
}

void list(Fields& fields, KeepGrammar& edit)
{
    fields.field("name", &edit.name);
    fields.field("text", &edit.text);
}

// Stores a grammar and removes leaves that were grown with an earlier grammar of the same name:
// when the user redraws a leaf that is in use, its name stays (app/methods/all_leaves.h).
Result<DocumentState> applied(DocumentState state, KeepGrammar const& edit, SceneBuilder&)
{
    if (edit.name.empty())
        return fail(Fault::User, "a leaf grammar is kept without a name");
    auto const before = state.leaf_grammars.find(edit.name);
    if (before != state.leaf_grammars.end() && *before->second != edit.text)
        std::erase_if(state.leaf_sheets, [&](auto const& sheet) {
            auto const order = lsystem::parse_leaf_sheet_name(sheet.first);
            return order && lsystem::parse_leaf_word(order->grammar).grammar == edit.name;
        });
    state.leaf_grammars[edit.name] = std::make_shared<std::string const>(edit.text);
    return state;
}

std::string described(KeepGrammar const& edit)
{
    return fmt::format("keeps the leaf grammar {}, {} bytes", edit.name, edit.text.size());
}

} // namespace

constexpr EditKind SetFoliage::kKind
    = make_edit_kind<SetFoliage, list, applied, described>("dress_plant");

constexpr EditKind KeepGrammar::kKind
    = make_edit_kind<KeepGrammar, list, applied, described>("keep_grammar");

} // namespace tractus::scene
