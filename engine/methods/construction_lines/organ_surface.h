#pragma once

#include "engine/base/result.h"
#include "engine/base/vectors.h"
#include "engine/plant/bezier_patch.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tractus::lines {

// An organ as drawn in three views (2008, section 6; Figure 2 c), millimetres. Each line has at
// least two points; a midrib or a section without any is straight.
struct OrganViews {
    // From above: the boundaries from the organ's base to its tip, (right, up) on the sheet. In
    // place of one without points the other one's mirror image counts.
    std::vector<Vec2> left {};
    std::vector<Vec2> right {};
    // From the side: how high the midrib is, (along, height) from base to tip. Along never turns
    // back.
    std::vector<Vec2> midrib {};
    // From the front: the section, (across, height) from left to right. Across never turns back.
    std::vector<Vec2> section {};
};

// A boundary's mirror image at the way from its first point to its last one: the other boundary of
// an organ with only one. No points: none.
std::vector<Vec2> mirrored(std::vector<Vec2> const& boundary);

// Whether the boundaries are apart: there is an area of more than 0.005 by the square of the
// organ's length between them. One without points is the other one's mirror image.
bool has_breadth(OrganViews const& views);

// An organ's surface and its colour, red, green and blue from 0 to 1; without one it has the
// leaves'.
struct OrganSurface {
    std::vector<BezierPatch> patches {};
    std::optional<Vec3> color {};
    // A PNG file that lies on it in place of the colour: its left and right edges on the
    // boundaries, its lower edge on the base. Null: none. Shared by all copies, since sketches are
    // copied with every line.
    std::shared_ptr<std::string const> picture {};
};

// The organ's surface by cross-sectional blending and orthogonal deformation: with l and r the
// boundaries, c the section from (0, 0) to (1, 0), and m the midrib's height above the straight way
// from its base to its tip,
//
//   S(u, v) = l(u) + c_x(v) (r(u) - l(u)) + (|r(u) - l(u)| c_y(v) + m(u)) z
//
// so S(u, 0) and S(u, 1) are the boundaries, seen from above, at the midrib's height; a straight
// midrib and section give a flat organ. All four lines are cubic splines through evenly spaced
// points of those drawn, therefore the patches are the surface itself.
//
// In millimetres, the middle of the two bases at the origin, that of the tips on y, x to the right,
// z to the upper side. s of a patch is along the organ, t from left to right; row after row of
// patches, kAcross in each. Fails, as the user's fault, for views that give no surface.
Result<std::vector<BezierPatch>> organ_surface(OrganViews const& views);

constexpr int kAlong = 12; // Patches, from base to tip.
constexpr int kAcross = 4;

} // namespace tractus::lines
