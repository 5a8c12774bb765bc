#pragma once

#include "engine/base/vectors.h"
#include "engine/lsystem/language/model.h"
#include "engine/methods/sketch_lsystem/rule.h"
#include "engine/methods/sketch_lsystem/segment_lengths.h"

#include <span>
#include <string>
#include <vector>

namespace tractus::sketch {

// The turn of an axis before one of its segments, relative to the preceding segment's frame after
// parallel transport: `/(plane)+(bend)\(plane)` in turtle commands. The plane is from -180 to 180
// degrees, the bend from 0 to 180. Both angles are 0 where the axis continues straight.
struct Turn {
    double plane_deg = 0;
    double bend_deg = 0;

    bool operator==(Turn const&) const = default;
};

// A stroke in the form that a model needs to grow along it: one turn per segment, and the number of
// times that laterals may fork. All numbers are rounded to six significant digits, as in the
// model's text.
struct DrawnAxis {
    Vec3 base_mm = Vec3::Zero(); // Start of the stroke, which is the plant's origin.
    std::vector<Turn> turns;
    int depth = kUncutDepth;
    // For each lateral, the share of its length for which it has room, in the order of
    // lateral_room(). Empty: all laterals grow to full length.
    std::vector<double> room {};

    int segments() const { return static_cast<int>(turns.size()); }
};

// Computes the axis through the nodes of a resampled stroke (stroke_resampler.h), with the largest
// depth of forking that the rule's limit on internodes allows. z is up; the turtle's initial
// heading is upwards, and its left side faces -x.
DrawnAxis draw_axis(Rule const& rule, std::span<Vec3 const> nodes_mm);

// Computes the axis through the nodes of a stroke that was resampled with `lengths`. Each segment
// aims at its node from where the rounded turns before it lead, so rounding errors do not add up.
DrawnAxis aim_axis(SegmentLengths const& lengths, std::span<Vec3 const> nodes_mm);

// The positions of an axis's nodes, beginning with its base. They differ from the resampled
// stroke's nodes only because the turns are rounded to six digits.
std::vector<Vec3> nodes_of(DrawnAxis const& axis, SegmentLengths const& lengths);
std::vector<Vec3> nodes_of(DrawnAxis const& axis, Rule const& rule);

// Formats the planes or the bends of all turns as an array of a model's text: "{0, 12.5}".
std::string array_of(std::vector<Turn> const& turns, double Turn::*angle_deg);

// Presence of leaves at the top apex and at live lateral apices.
enum class Leaves { Bare, Leafy };

// Writes the plant that `rule` grows along `axis` as a model in cpfg's language, with its view
// file. A turtle unit is a millimetre on the desk and a centimetre of the plant, as in all shipped
// models: a stroke of 200 mm becomes a plant of 2 m. The leaves do not affect the derived string.
// Deriving fewer steps than the axis has segments gives the plant of the stroke's first segments,
// with the same limit on forking.
lsystem::ModelSource write_model(Rule const& rule, DrawnAxis const& axis, Leaves leaves,
                                 std::string const& name);

} // namespace tractus::sketch
