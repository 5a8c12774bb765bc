#pragma once

#include "engine/base/vectors.h"
#include "engine/plant/contour.h"

#include <array>
#include <cstdint>
#include <vector>

namespace tractus::lsystem {

// Appearance of a generalised cylinder at a control point, as @Gt, @Gr, @# and @! set it.
struct CylinderStyle {
    // Lengths of the path's tangents before and after the point, as shares of the distances to the
    // neighbouring points.
    std::array<double, 2> tangents { 1.2, 1.2 };
    // Tangents of the radius before and after the point: (share of the path, change of radius in
    // turtle units). Zero: the radius changes linearly.
    std::array<Vec2, 2> radius_tangents { Vec2::Zero(), Vec2::Zero() };
    // True: the changes of radius are shares of the distance between the control points, not turtle
    // units.
    bool scales_radius_tangents = false;
    ContourId contour = kNoContour;
    std::uint16_t sides = 8;

    bool operator==(CylinderStyle const&) const = default;
};

// State of the turtle at a control point, in the plant's frame. Heading and normal are unit
// vectors.
struct CylinderPoint {
    Vec3 position_mm = Vec3::Zero();
    Vec3 heading = Vec3::UnitZ();
    Vec3 normal = Vec3::UnitY(); // X axis of the contour; cpfg calls this vector up.
    double radius_mm = 0;
    std::uint8_t color = 0;
    CylinderStyle style {};
};

// A cross-section of a cylinder between two control points, in the plant's frame.
struct CylinderSection {
    Vec3 position_mm = Vec3::Zero();
    Vec3 normal = Vec3::UnitY();
    double radius_mm = 0;
    // Position on the path between the two points: 0 at the first, 1 at the second.
    double share = 0;
};

// A generalised cylinder while the turtle draws it (Mech, "CPFG User's Manual"; for the curves,
// Foley et al., "Computer Graphics", section 11.2). Its sections are placed by parallel transport
// along Hermite cubics through the control points, or along a uniform cubic B-spline near them.
// With `twists`, the turtle's rolls at the control points are distributed over the sections
// between.
class Cylinder {
public:
    enum class Path { OpenHermite, ClosedHermite, OpenBSpline, ClosedBSpline };

    struct Options {
        Path path = Path::OpenHermite;
        int rings = 4; // Default number of sections from one control point to the next.
        bool twists = false;
        double unit_mm = 1; // Unit of radius tangents: length of a turtle unit in millimetres.
    };

    Cylinder() = default;
    explicit Cylinder(Options const& options)
        : options_(options)
    {
    }

    // Adds a control point and returns the piece of the cylinder that ends at `to`: the sections
    // after `from`. There are no sections if the path needs more points first. `rings` is the
    // number of sections, 0 for the default.
    struct Piece {
        CylinderPoint from;
        CylinderPoint to;
        std::vector<CylinderSection> sections;
    };
    Piece add(CylinderPoint point, int rings = 0);

    // Ends the cylinder. Returns the pieces that close a closed path.
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
    std::size_t count_ = 0; // Number of control points so far.
    CylinderPoint current_; // End of the last piece.
    // First control points of a closed path, which are needed again at its end.
    std::vector<CylinderPoint> first_;
    std::vector<CylinderPoint> last_; // Last three control points of a B-spline.
};

} // namespace tractus::lsystem
