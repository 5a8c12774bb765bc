#pragma once

#include "engine/base/result.h"
#include "engine/scene/edit.h"
#include "engine/scene/scene.h"

#include <optional>
#include <vector>

namespace tractus::batch {

// Returns edits that show a document in a season, or without a season. They include those seasonal
// leaves of its plants that the document does not contain yet; each kind of leaf takes 0.4 s to
// grow. Fails with a user error if a leaf cannot be grown.
Result<std::vector<scene::Edit>> season_edits(scene::Scene const& scene,
                                              std::optional<scene::Season> const& season);

// Returns edits that must follow a step, as dependent_edits() does. Leaves that change with a
// drawing are grown for the document's season.
std::vector<scene::Edit> following_edits(scene::Scene const& scene,
                                         std::vector<scene::Edit> const& step);

// Returns the scene as it looks in a season; the scene is unchanged if `season` has no value.
Result<scene::Scene> with_season(scene::Scene scene, std::optional<scene::Season> const& season);

} // namespace tractus::batch
