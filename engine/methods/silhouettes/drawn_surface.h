#pragma once

#include "engine/base/result.h"
#include "engine/methods/silhouettes/crown_line.h"
#include "engine/methods/silhouettes/meridian.h"
#include "engine/methods/silhouettes/outline.h"

#include <optional>
#include <vector>

namespace tractus::silhouette {

// The surface of a crown that was drawn in space: rings at several heights, a line that winds
// around it as it climbs, outlines in upright planes at several azimuths, or all of these.
// `outline` is the one on the sheet, in the trunk's frame and counter-clockwise; empty: none.
//
// Rings and lines that climb give the distance from the trunk at heights, at each of kAzimuths; a
// monotone curve goes through these, and beyond the last the surface closes as it goes on there.
// Near the azimuths of outlines it is what these say. With outlines alone it goes from one to the
// next (CrownSurface). Fails like kind_of(), add_ring() and add_climb().
Result<std::vector<Meridian>> meridians_of(std::vector<CrownLine> const& lines,
                                           TrunkFrame const& trunk,
                                           std::vector<Vec2> const& outline);

// Gives a drawing the surface that lines in space say: Drawing::surface. Without an outline the
// surface's section with the sheet is one, and without a trunk, too, one rises from `foot`; no
// value: from below the crown's middle, a quarter of its height. Fails like meridians_of() and
// clean_drawing().
Result<void> add_surface(Drawing& drawing, std::vector<CrownLine> const& lines,
                         std::optional<Vec2> const& foot);

} // namespace tractus::silhouette
