#pragma once

#include "engine/base/result.h"
#include "engine/scene/edit.h"
#include "engine/scene/scene.h"

#include <optional>
#include <vector>

namespace tractus::tools {

// What becomes of a branch that another plant is put on.
enum class Grafting {
    Beside,  // It goes on.
    InPlace, // It is hidden, and the plant stands where it stood; of a stem what is above is.
};

// A place on a plant of the document, as strokes bend it, where another plant can stand.
struct BranchPlace {
    scene::ItemId plant = 0;
    SegmentId touched = 0;              // Of its base plant.
    SegmentId on = 0;                   // The segment on whose end the other one stands.
    std::optional<SegmentId> hidden {}; // The first of those that are hidden then.
    double diameter_mm = 0;             // Of what bears it there. World frame, as the next one.
    // Where the other one's base is then: the place that was asked about if it is as near to the
    // branch as a hand would have joined it, else on the branch.
    Vec3 base_mm = Vec3::Zero();
};

// The place for a plant whose base is at `base_mm` (world frame), on the nearest branch of any
// plant that is shown but for one (0: none). Seen along `sight` it is at most a finger's breadth
// away, and not far in front or behind. Fails, as the user's fault, where there is none.
Result<BranchPlace> branch_at(scene::Scene const& scene, Vec3 const& base_mm, Vec3 const& sight,
                              Grafting grafting, scene::ItemId except = 0);

// The edits that put a plant there, which is in the document or made by the edit before: 0 is the
// active one.
std::vector<scene::Edit> graft_edits(scene::Scene const& scene, BranchPlace const& place,
                                     scene::ItemId plant);

} // namespace tractus::tools
