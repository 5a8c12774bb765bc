#pragma once

#include "engine/scene/edit_kind.h"

namespace tractus::session {

// Removes all plants: the first edit of a drawing that begins with an empty sheet. Each session
// needs an edit at step 0, where undo ends and to which "begin again" returns from any scene. A
// program that does not know this kind of edit begins with an empty sheet anyway.
struct BeginEmpty {
    static scene::EditKind const kKind;
};

} // namespace tractus::session
