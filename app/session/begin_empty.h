#pragma once

#include "engine/scene/edit_kind.h"

namespace tractus::session {

// Takes all plants away: what a drawing begins with on an empty sheet. A session needs something at
// step 0, where undo ends, and beginning again leads back there from any scene. A program that does
// not know it begins with an empty sheet all the same.
struct BeginEmpty {
    static scene::EditKind const kKind;
};

} // namespace tractus::session
