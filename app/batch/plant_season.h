#pragma once

#include "engine/base/result.h"
#include "engine/scene/edit.h"
#include "engine/scene/scene.h"

#include <optional>
#include <vector>

namespace tractus::batch {

// Edits that show a document in a season, or without one. They include the leaves that its plants
// need for that and the document lacks; these are grown here (0.4 s for each kind). Fails with a
// user error if a leaf cannot be grown.
Result<std::vector<scene::Edit>> season_edits(scene::Scene const& scene,
                                              std::optional<scene::Season> const& season);

// Edits that must follow a step, as in dependent_edits(); leaves that follow a drawing are grown
// for the document's season.
std::vector<scene::Edit> following_edits(scene::Scene const& scene,
                                         std::vector<scene::Edit> const& step);

// The scene as it looks in a season; unchanged without one.
Result<scene::Scene> with_season(scene::Scene scene, std::optional<scene::Season> const& season);

} // namespace tractus::batch
