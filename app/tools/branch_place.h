#pragma once

#include "engine/base/result.h"
#include "engine/scene/edit.h"
#include "engine/scene/scene.h"

#include <optional>
#include <vector>

namespace tractus::tools {

// Fate of a branch onto which another plant is grafted.
enum class Grafting {
    Beside, // The branch stays.
    // The branch is hidden and replaced by the plant; of a stem, only the part above the place is
    // hidden.
    InPlace,
};

// A place on a plant of the document, as bent by strokes, where another plant can be grafted.
struct BranchPlace {
    scene::ItemId plant = 0;
    SegmentId touched = 0; // Segment of the base plant that was touched.
    SegmentId on = 0;      // Segment to whose end the new plant is grafted.
    // First segment to hide, up to its axis's tip; no value: none.
    std::optional<SegmentId> hidden {};
    double diameter_mm = 0; // Diameter at the end of segment `on`, world frame.
    // Base of the grafted plant, world frame: the requested place if it is close to the branch,
    // otherwise the end of segment `on`.
    Vec3 base_mm = Vec3::Zero();
};

// Finds the place on the nearest branch of a visible plant for a plant whose base is at `base_mm`
// (world frame). `except` is a plant to ignore (0: none). Seen along `sight`, the branch is at most
// a finger's breadth away, and not far in front or behind. Fails with a user error if there is no
// such branch.
Result<BranchPlace> branch_at(scene::Scene const& scene, Vec3 const& base_mm, Vec3 const& sight,
                              Grafting grafting, scene::ItemId except = 0);

// Edits that graft a plant at the place. The plant is in the document or made by the preceding
// edit; 0 means the active plant.
std::vector<scene::Edit> graft_edits(scene::Scene const& scene, BranchPlace const& place,
                                     scene::ItemId plant);

} // namespace tractus::tools
