#pragma once

#include "engine/base/vectors.h"
#include "engine/plant/contour.h"

#include <array>
#include <cstdint>
#include <vector>

namespace tractus::lsystem {

// Looks of a generalised cylinder at one of its control points, as @Gt, @Gr, @# and @! set it.
struct CylinderStyle {
    // Length of the path's tangent at the point, as a share of the distance to the point before and
    // to the one behind.
    std::array<double, 2> tangents { 1.2, 1.2 };
    // Tangents of the radius: (share of the path, change of radius in turtle units). Zero: the
    // radius changes evenly.
    std::array<Vec2, 2> radius_tangents { Vec2::Zero(), Vec2::Zero() };
    bool scales_radius_tangents = false; // They grow with the distance.
    ContourId contour = kNoContour;
    std::uint16_t sides = 8;

    bool operator==(CylinderStyle const&) const = default;
};

// The turtle at a control point. Plant frame; heading and normal have unit length.
struct CylinderPoint {
    Vec3 position_mm = Vec3::Zero();
    Vec3 heading = Vec3::UnitZ();
    Vec3 normal = Vec3::UnitY(); // The contour's x: what cpfg calls up.
    double radius_mm = 0;
    std::uint8_t color = 0;
    CylinderStyle style {};
};

// A cross-section between two control points. Plant frame.
struct CylinderSection {
    Vec3 position_mm = Vec3::Zero();
    Vec3 normal = Vec3::UnitY();
    double radius_mm = 0;
    double share = 0; // Share of the way from one control point to the next.
};

// A generalised cylinder while the turtle draws it (Mech, "CPFG User's Manual"; Foley et al.,
// "Computer Graphics", section 11.2, for the curves): sections along Hermite cubics through the
// control points, or along a uniform cubic B-spline near them. Sections are carried along with the
// least twist; with `twists` the turtle's rolls at the control points are spread between them.
class Cylinder {
public:
    enum class Path { OpenHermite, ClosedHermite, OpenBSpline, ClosedBSpline };

    struct Options {
        Path path = Path::OpenHermite;
        int rings = 4; // Pieces between two control points that do not say how many.
        bool twists = false;
        double unit_mm = 1; // Unit of radius tangents.
    };

    Cylinder() = default;
    explicit Cylinder(Options const& options)
        : options_(options)
    {
    }

    // The piece that ends in `to`, as sections behind `from`; none where the path is only prepared.
    // `rings`: 0 for the default.
    struct Piece {
        CylinderPoint from;
        CylinderPoint to;
        std::vector<CylinderSection> sections;
    };
    Piece add(CylinderPoint point, int rings = 0);

    // The pieces that close a closed path.
    std::vector<Piece> finish();

private:
    bool is_bspline() const
    {
        return options_.path == Path::OpenBSpline || options_.path == Path::ClosedBSpline;
    }
    Piece make_piece(CylinderPoint const& to, struct CylinderCourse const& course) const;
    Piece add_to_hermite(CylinderPoint point, int rings);
    Piece add_to_bspline(CylinderPoint const& point, int rings);

    Options options_;
    std::size_t count_ = 0;            // Number of control points.
    CylinderPoint current_;            // The end of the piece that came last.
    std::vector<CylinderPoint> first_; // Start of a closed path, which its end meets.
    std::vector<CylinderPoint> last_;  // The last three points of a B-spline.
};

} // namespace tractus::lsystem
