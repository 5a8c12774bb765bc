#pragma once

#include "engine/base/result.h"
#include "engine/base/vectors.h"
#include "engine/plant/bezier_patch.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tractus::lines {

// An organ drawn in three views (Anastacio et al. 2008, section 6 and Figure 2 c), in millimetres.
// Each line has at least two points; a midrib or section without points is straight.
struct OrganViews {
    // Boundaries seen from above, from the organ's base to its tip, (right, up) on the sheet. A
    // boundary without points is taken as the mirror image of the other.
    std::vector<Vec2> left {};
    std::vector<Vec2> right {};
    // Midrib seen from the side, (along, height) from base to tip. `along` never decreases.
    std::vector<Vec2> midrib {};
    // Section seen from the front, (across, height) from left to right. `across` never decreases.
    std::vector<Vec2> section {};
};

// Returns the mirror image of a boundary about the line from its first to its last point, which
// serves as the other boundary of an organ. Empty if the boundary has no points.
std::vector<Vec2> mirrored(std::vector<Vec2> const& boundary);

// True if the area between the organ's boundaries is more than 0.005 of the square of its length. A
// boundary without points is taken as the mirror image of the other.
bool has_breadth(OrganViews const& views);

// An organ's surface, and its colour as red, green and blue from 0 to 1 (without a value, the
// default colour of leaves).
struct OrganSurface {
    std::vector<BezierPatch> patches {};
    std::optional<Vec3> color {};
    // A PNG file that replaces the colour: the picture's left and right edges lie on the organ's
    // boundaries, its lower edge at the base. Null if there is none. Copies of a sketch share the
    // file's bytes, because a sketch is copied with every line that is added.
    std::shared_ptr<std::string const> picture {};
};

// Computes an organ's surface by cross-sectional blending and orthogonal deformation. With l and r
// the boundaries, c the section from (0, 0) to (1, 0), and m the midrib's height above the straight
// line from its base to its tip:
//
//    S(u, v) = l(u) + c_x(v) (r(u) - l(u)) + (|r(u) - l(u)| c_y(v) + m(u)) z
//
// So S(u, 0) and S(u, 1) are the boundaries as seen from above, at the midrib's height; a straight
// midrib and a straight section give a flat organ. All four lines are cubic splines through evenly
// spaced points of the drawn lines, so the patches represent the surface exactly.
//
// Coordinates are in millimetres, with the midpoint of the boundaries' bases at the origin, the
// midpoint of their tips on the y axis, x to the right, and z out of the upper side. A patch's
// parameter s runs along the organ, t from left to right. Patches are listed row by row from the
// base, kAcross in each row. Fails with a user error if the views give no surface.
Result<std::vector<BezierPatch>> organ_surface(OrganViews const& views);

constexpr int kAlong = 12; // Number of patches of an organ's surface from base to tip.
constexpr int kAcross = 4;

} // namespace tractus::lines
