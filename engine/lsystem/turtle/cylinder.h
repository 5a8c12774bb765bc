#pragma once

#include "engine/base/vectors.h"
#include "engine/plant/contour.h"

#include <array>
#include <cstdint>
#include <vector>

namespace tractus::lsystem {

// Appearance of a generalised cylinder at a control point, as set by @Gt, @Gr, @# and @!.
struct CylinderStyle {
    // Lengths of the path's tangents at the point, as shares of the distances to the points before
    // and after it.
    std::array<double, 2> tangents { 1.2, 1.2 };
    // Tangents of the radius: (share of the path, change of radius in turtle units). Zero: the
    // radius changes linearly.
    std::array<Vec2, 2> radius_tangents { Vec2::Zero(), Vec2::Zero() };
    // True: radius tangents are proportional to the distance of the points.
    bool scales_radius_tangents = false;
    ContourId contour = kNoContour;
    std::uint16_t sides = 8;

    bool operator==(CylinderStyle const&) const = default;
};

// State of the turtle at a control point, in the plant's frame. Heading and normal have unit
// length.
struct CylinderPoint {
    Vec3 position_mm = Vec3::Zero();
    Vec3 heading = Vec3::UnitZ();
    Vec3 normal = Vec3::UnitY(); // The x axis of the contour, which cpfg calls up.
    double radius_mm = 0;
    std::uint8_t color = 0;
    CylinderStyle style {};
};

// A cross-section between two control points, in the plant's frame.
struct CylinderSection {
    Vec3 position_mm = Vec3::Zero();
    Vec3 normal = Vec3::UnitY();
    double radius_mm = 0;
    double share = 0; // Share of the path from one control point to the next.
};

// A generalised cylinder while the turtle draws it (Mech, "CPFG User's Manual"; for the curves,
// Foley et al., "Computer Graphics", section 11.2). Its sections are placed along Hermite cubics
// through the control points or along a uniform cubic B-spline near them, with parallel transport.
// With `twists`, the turtle's rolls at the control points are distributed between them.
class Cylinder {
public:
    enum class Path { OpenHermite, ClosedHermite, OpenBSpline, ClosedBSpline };

    struct Options {
        Path path = Path::OpenHermite;
        int rings = 4; // Default number of pieces between two control points.
        bool twists = false;
        double unit_mm = 1; // Unit of radius tangents in millimetres.
    };

    Cylinder() = default;
    explicit Cylinder(Options const& options)
        : options_(options)
    {
    }

    // The piece that ends at `to`, as sections after `from`; without sections if more points are
    // needed first. `rings` is the number of sections, 0 for the default.
    struct Piece {
        CylinderPoint from;
        CylinderPoint to;
        std::vector<CylinderSection> sections;
    };
    Piece add(CylinderPoint point, int rings = 0);

    // Returns the pieces that close a closed path.
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
    std::size_t count_ = 0; // Number of control points.
    CylinderPoint current_; // End of the last piece.
    // First points of a closed path, which are needed again at its end.
    std::vector<CylinderPoint> first_;
    std::vector<CylinderPoint> last_; // Last three points of a B-spline.
};

} // namespace tractus::lsystem
