#pragma once

#include "engine/base/result.h"
#include "engine/scene/edit.h"
#include "engine/scene/scene.h"

#include <optional>
#include <vector>

namespace tractus::batch {

// The edits that show a document in a season, or without one: with the leaves that its plants need
// for that and the document does not have yet, which are grown here (0.4 s for each kind). Fails,
// as the user's fault, where a leaf cannot be grown.
Result<std::vector<scene::Edit>> season_edits(scene::Scene const& scene,
                                              std::optional<scene::Season> const& season);

// The edits that a step brings with it, as edits_that_follow() says; leaves that follow a drawing
// do so in the document's season, too.
std::vector<scene::Edit> following_edits(scene::Scene const& scene,
                                         std::vector<scene::Edit> const& step);

// The scene in that season; as it is without one.
Result<scene::Scene> with_season(scene::Scene scene, std::optional<scene::Season> const& season);

} // namespace tractus::batch
