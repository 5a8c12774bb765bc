#include "engine/scene/back_picture.h"
#include "engine/scene/derive_anew.h"
#include "engine/scene/edit.h"
#include "engine/scene/limb_edits.h"
#include "engine/scene/make_edit_kind.h"
#include "engine/scene/write_rules.h"

#include <algorithm>
#include <array>
#include <fmt/core.h>

namespace tractus::scene {

namespace {

void list(Fields&, UnknownEdit&) { }

// NOLINTNEXTLINE(performance-unnecessary-value-param): all kinds have the same signature.
Result<DocumentState> applied(DocumentState, UnknownEdit const& edit, SceneBuilder&)
{
    return fail(Fault::User, edit.why);
}

std::string described(UnknownEdit const& edit)
{
    return fmt::format("does what this tractus does not know (\"{}\"): {}", edit.word, edit.why);
}

} // namespace

constexpr EditKind UnknownEdit::kKind = make_edit_kind<UnknownEdit, list, applied, described>("");

EditKinds core_edit_kinds()
{
    static constexpr std::array kKinds {
        &LoadModel::kKind,        &LoadSkeleton::kKind,    &LoadMeasured::kKind,
        &Select::kKind,           &Associate::kKind,       &Oversketch::kKind,
        &SmoothStroke::kKind,     &DeleteStroke::kKind,    &EraseTips::kKind,
        &Indicate::kKind,         &ChangeIndicator::kKind, &DeleteIndicator::kKind,
        &SetGrowth::kKind,        &ActivatePlant::kKind,   &MovePlant::kKind,
        &CopyPlant::kKind,        &HidePlant::kKind,       &NamePlant::kKind,
        &RemovePlant::kKind,      &SetScale::kKind,        &GraftPlant::kKind,
        &TakeOffGraft::kKind,     &HideBranch::kKind,      &KeepLeaves::kKind,
        &SetSeason::kKind,        &LayPicture::kKind,      &PlacePicture::kKind,
        &SetPictureGround::kKind, &RemovePicture::kKind,   &SetFoliage::kKind,
        &KeepGrammar::kKind,      &WriteRules::kKind,      &DrawLimb::kKind,
        &EraseLimb::kKind,        &DeriveAnew::kKind,      &TurnStroke::kKind
    };
    return kKinds;
}

EditKind const* find_edit_kind(EditKinds kinds, std::string_view word)
{
    auto const found = std::find_if(kinds.begin(), kinds.end(), [&](EditKind const* kind) {
        return std::string_view(kind->word) == word;
    });
    return found == kinds.end() ? nullptr : *found;
}

void Edit::show(Fields& visitor) const
{
    static_cast<void>(changed_by(visitor));
}

Edit Edit::changed_by(Fields& visitor) const
{
    auto const copy = kind_->copy(fields_.get());
    kind_->fields(visitor, copy.get());
    return { *kind_, copy };
}

Result<DocumentState> apply_edit(DocumentState state, Edit const& edit, SceneBuilder& builder)
{
    ++state.last_edit;
    return edit.kind_->apply(std::move(state), edit.fields_.get(), builder);
}

} // namespace tractus::scene
