#pragma once

#include "engine/base/result.h"
#include "engine/base/vectors.h"
#include "engine/methods/construction_lines/drawn_stem.h"
#include "engine/methods/construction_lines/layer_organs.h"

#include <cstddef>
#include <string>
#include <vector>

namespace tractus::lines {

// What an illustrator draws to block in a plant: a stem, the lines that the organs' tips reach at
// its left and right, and lines across it along which organs stand (Anastacio, Prusinkiewicz,
// Sousa, "Sketch-based parameterization of L-systems using illustration-inspired construction
// lines", 2008). Millimetres on the sheet (drawn_line.h).
struct LineSketch {
    std::vector<Vec3> stem; // (u, v, depth), base first.
    // Empty: not drawn. One that is missing is the other one, mirrored.
    std::vector<Vec2> left;
    std::vector<Vec2> right;
    // In any order; none: two, at a tenth of the stem and near its top, with organs at 45 degrees.
    std::vector<std::vector<Vec2>> inclinations;
    // How many nodes each layer between two neighbouring inclination lines has, from below; the
    // topmost line bears one more.
    std::vector<int> nodes_per_layer;
    // In place of it, if not empty: how many stand between each inclination line, in the order of
    // the list, and the next one above it. One number where there are fewer than two lines.
    std::vector<int> nodes_above {};
    // Boundaries in space, (u, v, depth): each says how far organs reach at its azimuth around the
    // stem (around_stem.h), in which no two are nearer than kSameAzimuth_deg; the left and the
    // right one are at 0 and 180. Lines there that are all of the boundaries count as the left and
    // right one on the sheet.
    std::vector<std::vector<Vec3>> around {};
    // What each layer bears, from below; what is said last counts for all layers above, too. Empty:
    // what the plant bears.
    std::vector<LayerOrgans> organs_per_layer {};
    // What is borne between lines as nodes_above has them; counts in place of it if not empty.
    std::vector<LayerOrgans> organs_above {};
};

constexpr double kSameAzimuth_deg = 5;

constexpr std::size_t kMostPoints = 20'000;         // Of all lines of a sketch.
Result<void> check_point_count(std::size_t points); // Refuses more, as the user's fault.

// An inclination line that reaches less far beyond the stem, by its length, has no half there.
constexpr double kLeastHalf = 1e-3;
constexpr int kMostNodesInLayer = 500;
constexpr int kMostNodes = 10'000;

// Where an inclination line crosses the stem, and how far what grows along it turns away from the
// stem to each side, degrees from 0 to 180.
struct Inclination {
    double x = 0;
    double left_deg = 0;
    double right_deg = 0;
    std::size_t drawn = 0; // Its number in the sketch's list; 0, too, of those that nobody drew.
};

// A place where organs stand. Angles are those between stem and organ in space, sizes shares of the
// stem's length, at its left and right.
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
    std::vector<double> sizes; // Of each node: shares of the stem's length.
};

// A sketch as measured: what parameterizes a plant.
struct Construction {
    DrawnStem stem;
    std::vector<Inclination> inclinations; // From below: layer i lies between i and i + 1.
    std::vector<int> nodes_per_layer;
    std::vector<OrganNode> nodes;   // From below; at least one.
    std::vector<std::string> notes; // What had to be guessed, a sentence each.
    // At the boundaries, the azimuths rising, if they are in space; between them sizes follow
    // size_between(). Else there is none: between left and right sizes are linear, as in the paper.
    std::vector<AzimuthSizes> around {};
    // What each layer bears, from below; empty where all of them bear what the plant bears.
    std::vector<LayerOrgans> organs_per_layer {};

    // The shares of the stem below the lowest line and above the topmost one.
    double below() const { return inclinations.front().x; }
    double above() const { return 1 - inclinations.back().x; }
};

// The positional functions (2008, section 4) at the place x, 0 to 1 along the stem. Angles and
// sizes are linear from node to node, and constant below the first and above the last.
struct FunctionValues {
    double heading_deg = 0; // Of the stem, as seen.
    double pitch_deg = 0;   // Of the stem, towards the viewer.
    double left_deg = 0;
    double right_deg = 0;
    double left_size = 0;
    double right_size = 0;
};
FunctionValues values_at(Construction const& construction, double x);

// What stands at an angle to the stem, and how far it goes.
struct Reach {
    double angle_deg = 0;
    double length = 0;
};

// From what is seen in the sheet's plane to the organ in space on a stem that rises towards the
// viewer by so much, and back. A stem that points at the viewer counts as one at 80 degrees.
Reach in_space(Reach const& seen, double pitch_deg);
Reach as_seen(Reach const& organ, double pitch_deg);

// The size of a node's organs at an azimuth around the stem.
double size_at(Construction const& construction, std::size_t node, double azimuth_deg);

// What becomes of a sketch that lacks lines.
enum class Missing {
    Refused, // With what to draw.
    // As long as somebody draws it: without boundaries nothing stands on the stem (Pattern::Bare,
    // the sizes are 0), and where there is only one inclination line it holds all along the stem.
    Guessed,
};

// Whether there is a boundary, so that organs may stand on the stem.
bool has_boundary(LineSketch const& sketch);

// Measures a sketch. The same sketch mirrored, scaled, or with boundaries and inclination lines
// drawn the other way round gives the same numbers, mirrored.
//
// Fails, as the user's fault, with what to draw or to change: a stem, both boundaries or a second
// inclination line missing; one that does not cross the stem just once, or that meets a boundary on
// the other's side; boundaries in space that go along the stem itself or beside each other; numbers
// of nodes that do not fit the lines; more points or nodes than the limits above; numbers that are
// not finite.
Result<Construction> measure_sketch(LineSketch const& sketch, Missing missing = Missing::Refused);

} // namespace tractus::lines
