#pragma once

#include "engine/base/result.h"
#include "engine/base/vectors.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::lsystem {

// A space curve from a curve file of cpfg, which curveX, curveY and curveZ read.
struct CurveTable {
    // The kind of curve that the control points define.
    enum class Kind {
        Uniform, // A cubic B-spline with equal knots, which begins and ends near its end points.
        Clamped, // A cubic B-spline that begins and ends at its end points.
        Bezier,  // Bézier cubics, each beginning at the last point of the one before.
    };

    std::string name;
    Kind kind = Kind::Uniform;
    std::vector<Vec3> control; // Control points of the curve; at least 4.
    // Arc length at equal steps of the parameter, as a share of the whole length, from 0 to 1.
    std::vector<double> lengths;
    double length = 0; // Length of the whole curve, in the file's units.

    // Returns the point at `share` of the curve's length. Outside [0, 1] this is the nearest end.
    Vec3 at(double share) const;
};

// Reads a curve file: the lines `points: N`, `dim: 2|3|4` (with 4, the last number repeats the
// point), `type: bspline|bspline-closed|bspline-endpoint|bspline-phantom|bezier|bezier-surface`,
// then N points. Of a surface only the first edge is used. Other lines are for an editor and are
// ignored. As in cpfg, the arc length is measured at `samples` places. Fails with a user error of
// the form "FILE:LINE: ...".
Result<CurveTable> parse_curve(std::string const& name, std::string_view text,
                               std::size_t samples = 100);

} // namespace tractus::lsystem
