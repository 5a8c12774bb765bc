#pragma once

#include "engine/base/result.h"
#include "engine/scene/edit.h"
#include "engine/scene/scene.h"

#include <optional>
#include <vector>

namespace tractus::tools {

// What happens to the branch onto which another plant is grafted.
enum class Grafting {
    Beside, // The branch stays beside the grafted plant.
    // The grafted plant replaces the branch, which is hidden. If the branch is a stem, only its
    // part above the grafting place is hidden.
    InPlace,
};

// A place on a plant of the document, as bent by strokes, onto which another plant can be grafted.
struct BranchPlace {
    scene::ItemId plant = 0;
    SegmentId touched = 0; // Segment of the base plant that was touched.
    SegmentId on = 0;      // Segment to whose end the new plant is grafted.
    // First segment to hide; the branch is hidden from there to its tip. No value: hides nothing.
    std::optional<SegmentId> hidden {};
    double diameter_mm = 0; // Diameter of the branch at the end of segment `on`, world frame.
    // Base of the grafted plant, world frame: the requested place if it is close to the branch,
    // otherwise the end of segment `on`.
    Vec3 base_mm = Vec3::Zero();
};

// Finds the place for grafting a plant whose base is at `base_mm` (world frame) onto the nearest
// branch of a visible plant. The branch must be at most 10 mm away as seen along `sight`, and at
// most 30 mm in front or behind. The plant `except` is ignored (0: none). Fails with a user error
// if there is no such branch.
Result<BranchPlace> branch_at(scene::Scene const& scene, Vec3 const& base_mm, Vec3 const& sight,
                              Grafting grafting, scene::ItemId except = 0);

// Edits that graft a plant at the place. `plant` is in the document or is made by the preceding
// edit; 0 means the active plant.
std::vector<scene::Edit> graft_edits(scene::Scene const& scene, BranchPlace const& place,
                                     scene::ItemId plant);

} // namespace tractus::tools
