#pragma once

#include "engine/base/result.h"
#include "engine/base/vectors.h"
#include "engine/methods/silhouettes/meridian.h"

#include <array>
#include <vector>

namespace tractus::silhouette {

// A line in space on a crown's surface: x and y as on the sheet, z how far behind it. Millimetres.
using CrownLine = std::vector<Vec3>;

// What a line on a crown's surface is, by its shape.
enum class CrownLineKind {
    Ring,  // Once around at nearly one height,
    Climb, // around more than once while it climbs,
    Side,  // or an outline in an upright plane.
};

// A ring rises by at most a quarter of its greatest width, a line that climbs goes around one and a
// quarter times at least, and an outline is in its plane by a fifth of its width. Fails, as the
// user's fault, for what is none of them.
Result<CrownLineKind> kind_of(CrownLine const& line);

// Of an outline in an upright plane, 0 to below 180: 0 in the sheet, 90 across it.
double azimuth_deg(CrownLine const& side);

// Around where on the desk it goes: to the right and behind the sheet. Of a ring its area's middle.
Vec2 plan_middle(CrownLine const& line);

double mean_height(CrownLine const& line); // On the sheet.

// Whether a line takes another one's place: rings within 4 mm of one height, outlines within ten
// degrees of one azimuth, and any two that climb.
bool takes_place_of(CrownLine const& line, CrownLine const& other);

// Azimuths around the trunk at which a crown is measured: every five degrees, from 0 on.
constexpr std::size_t kAzimuths = 72;

// Where a line is at an azimuth: (height along the trunk, distance from it).
using Crossings = std::array<std::vector<Vec2>, kAzimuths>;

// Adds where a ring is at each azimuth, once. Fails, as the user's fault, if it does not go around
// the trunk.
Result<void> add_ring(CrownLine const& ring, TrunkFrame const& trunk, Crossings& crossings);

// Likewise, as often as the line goes around.
Result<void> add_climb(CrownLine const& climb, TrunkFrame const& trunk, Crossings& crossings);

} // namespace tractus::silhouette
