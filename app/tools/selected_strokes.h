#pragma once

#include "engine/base/result.h"
#include "engine/scene/edit.h"
#include "engine/scene/scene.h"

namespace tractus::tools {

// The strokes that shape the selected branches, oldest first. Fails, as the user's fault, if there
// is none.
Result<scene::Items> selected_strokes(scene::Scene const& scene);

// The newest of them.
Result<scene::Items> newest_selected_stroke(scene::Scene const& scene);

} // namespace tractus::tools
