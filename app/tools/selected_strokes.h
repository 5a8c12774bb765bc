#pragma once

#include "engine/base/result.h"
#include "engine/scene/edit.h"
#include "engine/scene/scene.h"

namespace tractus {

// The strokes that shape the selected branches, oldest first. Fails, as the user's fault, if there
// is none.
Result<Items> selected_strokes(Scene const& scene);

// The newest of them.
Result<Items> newest_selected_stroke(Scene const& scene);

} // namespace tractus
