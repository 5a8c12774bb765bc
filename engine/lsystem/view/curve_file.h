#pragma once

#include "engine/base/result.h"
#include "engine/base/vectors.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::lsystem {

// A curve in space from a curve file of cpfg's, as curveX, curveY and curveZ ask for it.
struct CurveTable {
    // How the control points make the curve.
    enum class Kind {
        Uniform, // A cubic B-spline with equal knots: it begins and ends near its end points.
        Clamped, // A cubic B-spline that begins and ends in them.
        Bezier,  // Bézier cubics, each of which begins in the last point of the one before.
    };

    std::string name;
    Kind kind = Kind::Uniform;
    std::vector<Vec3> control; // At least 4.
    // Length of the curve up to equal steps of its parameter, as shares of the whole, 0 to 1.
    std::vector<double> lengths;
    double length = 0; // Length of the whole, in the file's units.

    // The point that `share` of the curve's length leads to; outside of [0, 1] the nearest end.
    Vec3 at(double share) const;
};

// Reads a curve file: lines `points: N`, `dim: 2|3|4` (with 4 the last number repeats the point),
// `type: bspline|bspline-closed|bspline-endpoint|bspline-phantom|bezier|bezier-surface`, then N
// points. Of a surface the first edge counts; what else the file says is about an editor. The
// lengths are measured at `samples` places, as cpfg does. Fails, as the user's fault, with
// "FILE:LINE: …".
Result<CurveTable> parse_curve(std::string const& name, std::string_view text,
                               std::size_t samples = 100);

} // namespace tractus::lsystem
