#pragma once

#include "engine/base/result.h"
#include "engine/base/vectors.h"
#include "engine/methods/construction_lines/drawn_stem.h"
#include "engine/methods/construction_lines/layer_organs.h"

#include <cstddef>
#include <string>
#include <vector>

namespace tractus::lines {

// The construction lines with which an illustrator blocks in a plant: a stem, the boundaries that
// the organs' tips reach at its left and right, and inclination lines across it, along which organs
// are directed (Anastacio, Prusinkiewicz, Sousa, "Sketch-based parameterization of L-systems using
// illustration-inspired construction lines", 2008). Coordinates are in millimetres on the sheet
// (drawn_line.h).
struct LineSketch {
    std::vector<Vec3> stem; // Points of the stem, (u, v, depth), base first.
    // Boundaries that the organs' tips reach on the left and right; empty if not drawn. A missing
    // boundary is taken as the mirror image of the other.
    std::vector<Vec2> left;
    std::vector<Vec2> right;
    // Inclination lines in any order. If there are none, two are assumed, at a tenth of the stem's
    // length and near its top, with organs at 45 degrees.
    std::vector<std::vector<Vec2>> inclinations;
    // Number of nodes of each layer between two neighbouring inclination lines, from below; the
    // topmost line bears one additional node.
    std::vector<int> nodes_per_layer;
    // Number of nodes between each inclination line, in the order of `inclinations`, and the next
    // line above it; replaces nodes_per_layer unless empty. With fewer than two inclination lines
    // there is a single number.
    std::vector<int> nodes_above {};
    // Boundaries in space, (u, v, depth): each gives the organs' reach at its azimuth around the
    // stem (around_stem.h). Azimuths differ by at least kSameAzimuth_deg; the left and right
    // boundaries are at 0 and 180. If there are no boundaries on the sheet, boundaries in space
    // also serve as the left and right ones.
    std::vector<std::vector<Vec3>> around {};
    // Organs of each layer, from below; the last entry also applies to all layers above its own. If
    // empty, all layers have the plant's organs.
    std::vector<LayerOrgans> organs_per_layer {};
    // Organs of the layer above each inclination line, in the order of nodes_above; replaces
    // organs_per_layer unless empty.
    std::vector<LayerOrgans> organs_above {};
};

constexpr double kSameAzimuth_deg = 5;

constexpr std::size_t kMaxPoints = 20'000; // Maximum number of points in all lines of a sketch.
// Fails with a user error if the number of points exceeds kMaxPoints.
Result<void> check_point_count(std::size_t points);

// A half of an inclination line shorter than this share of the stem's length counts as missing.
constexpr double kMinHalf = 1e-3;
constexpr int kMaxNodesInLayer = 500;
constexpr int kMaxNodes = 10'000;

// Position at which an inclination line crosses the stem, and the angles of its two halves to the
// stem's direction, 0 to 180 degrees, as seen on the sheet.
struct Inclination {
    double x = 0;
    double left_deg = 0;
    double right_deg = 0;
    // Index of the line in LineSketch::inclinations; also 0 for default lines that were not drawn.
    std::size_t drawn = 0;
};

// A node, with the angles and sizes of its organs on the left and right. Angles are measured
// between stem and organ in space; sizes are shares of the stem's length.
struct OrganNode {
    double x = 0;
    double left_deg = 0;
    double right_deg = 0;
    double left_size = 0;
    double right_size = 0;
};

// The organs' sizes at one azimuth around the stem.
struct AzimuthSizes {
    double azimuth_deg = 0;
    std::vector<double> sizes; // Size at each node, as a share of the stem's length.
};

// The measurements of a sketch: the parameters of a plant.
struct Construction {
    DrawnStem stem;
    // Inclination lines from below: layer i is between lines i and i + 1.
    std::vector<Inclination> inclinations;
    std::vector<int> nodes_per_layer;
    std::vector<OrganNode> nodes;   // Nodes from below, at least one.
    std::vector<std::string> notes; // Assumptions made for missing lines, one sentence each.
    // Sizes at the boundaries in space, in ascending azimuths; between these azimuths sizes follow
    // size_between(). Empty if all boundaries are on the sheet: then sizes between left and right
    // are linear in the azimuth (Anastacio et al. 2008).
    std::vector<AzimuthSizes> around {};
    // Organs of each layer, from below; empty if all layers have the plant's organs.
    std::vector<LayerOrgans> organs_per_layer {};

    // Share of the stem below the lowest inclination line; above(): above the topmost one.
    double below() const { return inclinations.front().x; }
    double above() const { return 1 - inclinations.back().x; }
};

// Values of the positional functions (Anastacio et al. 2008, section 4) at the position x, 0 to 1
// along the stem. Angles and sizes are linear between nodes, and constant below the first node and
// above the last.
struct FunctionValues {
    double heading_deg = 0; // Heading of the stem, as seen on the sheet.
    double pitch_deg = 0;   // Pitch of the stem, towards the viewer.
    double left_deg = 0;
    double right_deg = 0;
    double left_size = 0;
    double right_size = 0;
};
FunctionValues values_at(Construction const& construction, double x);

// An organ's length and its angle to the stem, either in space or as projected on the sheet.
struct Reach {
    double angle_deg = 0;
    double length = 0;
};

// Convert an organ's length and angle between its projection on the sheet and space, where the stem
// has the pitch `pitch_deg` towards the viewer. The pitch is limited to 80 degrees.
Reach in_space(Reach const& seen, double pitch_deg);
Reach as_projected(Reach const& organ, double pitch_deg);

// Size of a node's organs at an azimuth around the stem.
double size_at(Construction const& construction, std::size_t node, double azimuth_deg);

// How measure_sketch() treats lines that have not been drawn.
enum class Missing {
    Refused, // A missing line is an error; the message tells the user what to draw.
    // Defaults replace missing lines: without boundaries the stem has no organs (Pattern::Bare,
    // sizes 0), and a single inclination line applies to the whole stem.
    Guessed,
};

// True if the sketch has a boundary, so that its stem may have organs.
bool has_boundary(LineSketch const& sketch);

// Measures a sketch. The result does not depend on the sketch's scale or on the drawing direction
// of boundaries and inclination lines; a mirrored sketch gives a mirrored result.
//
// Fails with a user error, saying what to draw or to change, if the stem, both boundaries or a
// second inclination line are missing; an inclination line does not cross the stem exactly once, or
// meets a boundary on the wrong side; boundaries in space run along the stem itself or beside each
// other; numbers of nodes do not match the lines; there are more points than kMaxPoints, or more
// nodes than kMaxNodesInLayer or kMaxNodes allow; or a coordinate is not finite.
Result<Construction> measure_sketch(LineSketch const& sketch, Missing missing = Missing::Refused);

} // namespace tractus::lines
