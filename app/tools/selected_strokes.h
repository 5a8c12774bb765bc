#pragma once

#include "engine/base/result.h"
#include "engine/scene/edit.h"
#include "engine/scene/scene.h"

namespace tractus::tools {

// The strokes that shape the selected branches, oldest first. Fails with a user error if there are
// none.
Result<scene::Items> selected_strokes(scene::Scene const& scene);

// The newest stroke that shapes the selected branches. Fails with a user error if there is none.
Result<scene::Items> newest_selected_stroke(scene::Scene const& scene);

} // namespace tractus::tools
