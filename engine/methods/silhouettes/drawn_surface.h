#pragma once

#include "engine/base/result.h"
#include "engine/methods/silhouettes/crown_line.h"
#include "engine/methods/silhouettes/meridian.h"
#include "engine/methods/silhouettes/outline.h"

#include <optional>
#include <vector>

namespace tractus::silhouette {

// The surface of a crown drawn in space by rings at several heights, a line that winds around the
// crown as it climbs, outlines in vertical planes at several azimuths, or any mixture. `outline` is
// the crown's outline on the sheet, in the trunk's frame, counter-clockwise; empty if there is
// none.
//
// Rings and climbing lines give the distance from the trunk by height at each of kAzimuths
// azimuths. A monotone curve interpolates these; beyond its ends the surface is extrapolated until
// it closes. Near the azimuths of outlines, the outlines define the surface. With outlines alone,
// the surface is interpolated from one to the next (CrownSurface). Fails like kind_of(), add_ring()
// and add_climb().
Result<std::vector<Meridian>> meridians_of(std::vector<CrownLine> const& lines,
                                           TrunkFrame const& trunk,
                                           std::vector<Vec2> const& outline);

// Sets Drawing::surface from lines in space. If the drawing has no outline, the surface's section
// with the sheet becomes the outline. If the drawing has no trunk either, a trunk is added that
// rises from `foot`. Default of `foot`: below the crown by a quarter of the crown's height. Fails
// like meridians_of() and clean_drawing().
Result<void> add_surface(Drawing& drawing, std::vector<CrownLine> const& lines,
                         std::optional<Vec2> const& foot);

} // namespace tractus::silhouette
