#include "app/session/begin_empty.h"

#include "engine/scene/make_edit_kind.h"

#include <string>

namespace tractus::session {

namespace {

void list_nothing(scene::Fields&, BeginEmpty&) { }

// NOLINTNEXTLINE(performance-unnecessary-value-param): as for all kinds.
Result<scene::DocumentState> emptied(scene::DocumentState state, BeginEmpty const&,
                                     scene::SceneBuilder&)
{
    return scene::DocumentState { .last_edit = state.last_edit };
}

std::string described_as_empty(BeginEmpty const&)
{
    return "begins with an empty sheet";
}

} // namespace

constexpr scene::EditKind BeginEmpty::kKind
    = scene::make_edit_kind<BeginEmpty, list_nothing, emptied, described_as_empty>("begin_empty");

} // namespace tractus::session
