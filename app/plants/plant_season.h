#pragma once

#include "engine/base/result.h"
#include "engine/scene/edit.h"
#include "engine/scene/scene.h"

#include <optional>
#include <vector>

namespace tractus {

// The edits that show a document in a season, or without one: with the leaves that its plants need
// for that and the document does not have yet, which are grown here (0.4 s for each kind). Fails,
// as the user's fault, where a leaf cannot be grown.
Result<std::vector<Edit>> season_edits(Scene const& scene, std::optional<Season> const& season);

// The scene in that season; as it is without one.
Result<Scene> with_season(Scene scene, std::optional<Season> const& season);

} // namespace tractus
