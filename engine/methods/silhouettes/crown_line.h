#pragma once

#include "engine/base/result.h"
#include "engine/base/vectors.h"
#include "engine/methods/silhouettes/meridian.h"

#include <array>
#include <vector>

namespace tractus::silhouette {

// A line in space on the crown's surface, millimetres: x and y on the sheet, z the distance behind
// the sheet.
using CrownLine = std::vector<Vec3>;

// Classes of crown lines, distinguished by their shape.
enum class CrownLineKind {
    Ring,  // A line once around the crown at nearly constant height.
    Climb, // A line that goes around the crown more than once while rising.
    Side,  // A closed outline in a vertical plane.
};

// Classifies a line. A ring rises by at most a quarter of its greatest width. A climbing line makes
// at least one and a quarter turns. An outline deviates from its vertical plane by at most a fifth
// of its width. Fails with a user error for any other line.
Result<CrownLineKind> kind_of(CrownLine const& line);

// Azimuth of the vertical plane of an outline, 0 to below 180 degrees: 0 in the sheet, 90 at right
// angles to the sheet.
double azimuth_deg(CrownLine const& side);

// Centre of a line in plan view (x to the right, y behind the sheet); for a ring, the centroid of
// its plan.
Vec2 plan_middle(CrownLine const& line);

double mean_height(CrownLine const& line); // Mean y of the line, millimetres on the sheet.

// True if `line` replaces `other`: two rings within 4 mm in height, two outlines within ten degrees
// of azimuth, or any two climbing lines.
bool takes_place_of(CrownLine const& line, CrownLine const& other);

// Number of azimuths around the trunk at which a crown is sampled: every five degrees from 0.
constexpr std::size_t kAzimuths = 72;

// Intersections of lines with the half plane at each azimuth, as (height along the trunk, distance
// from the trunk).
using Crossings = std::array<std::vector<Vec2>, kAzimuths>;

// Adds the intersections of a ring with the half planes, one per azimuth. Fails with a user error
// if the ring does not go around the trunk.
Result<void> add_ring(CrownLine const& ring, TrunkFrame const& trunk, Crossings& crossings);

// Adds the intersections of a climbing line with the half planes, as many per azimuth as the line
// makes turns. Fails like add_ring().
Result<void> add_climb(CrownLine const& climb, TrunkFrame const& trunk, Crossings& crossings);

} // namespace tractus::silhouette
