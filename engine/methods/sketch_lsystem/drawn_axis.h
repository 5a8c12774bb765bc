#pragma once

#include "engine/base/vectors.h"
#include "engine/lsystem/language/model.h"
#include "engine/methods/sketch_lsystem/rule.h"
#include "engine/methods/sketch_lsystem/segment_lengths.h"

#include <span>
#include <string>
#include <vector>

namespace tractus::sketch {

// Turn of an axis before one of its segments, against the frame of the segment before it, which is
// carried along by the least rotation and does not roll: `/(plane)+(bend)\(plane)` in turtle
// commands. Degrees; plane -180 to 180, bend 0 to 180. Where the axis goes straight on both are 0.
struct Turn {
    double plane_deg = 0;
    double bend_deg = 0;

    bool operator==(Turn const&) const = default;
};

// Description of a stroke for a model that grows along it: as many turns as the stroke has
// segments, and how often laterals may fork. All numbers are as the model's text gives them, six
// significant digits.
struct DrawnAxis {
    Vec3 base_mm = Vec3::Zero(); // Where the pen came down; the plant's own origin.
    std::vector<Turn> turns;
    int depth = kUncutDepth;

    int segments() const { return static_cast<int>(turns.size()); }
};

// The axis through the nodes of a resampled stroke (stroke_resampler.h), with the depth that the
// rule's limit allows. z is up, and the turtle starts upwards, its left at -x.
DrawnAxis draw_axis(Rule const& rule, std::span<Vec3 const> nodes_mm);

// The axis through the nodes of a stroke that was resampled by those lengths, which are as the text
// has them, too: each segment aims at its node from where rounding has left the one before it, so
// that no error adds up.
DrawnAxis aim_axis(SegmentLengths const& lengths, std::span<Vec3 const> nodes_mm);

// Where the turtle has the axis's nodes, its base first: the stroke's nodes, but for what rounding
// to six digits costs.
std::vector<Vec3> nodes_of(DrawnAxis const& axis, SegmentLengths const& lengths);
std::vector<Vec3> nodes_of(DrawnAxis const& axis, Rule const& rule);

// The turns' planes, or bends, as the values of an array in a model's text: "{0, 12.5}".
std::string array_of(std::vector<Turn> const& turns, double Turn::*angle_deg);

// Whether leaves stand at the live lateral apices and at the top.
enum class Leaves { Bare, Leafy };

// The plant as a model in cpfg's language, and what it looks like. A turtle's unit is a millimetre
// on the desk and a centimetre of the plant, as in all our models: 200 mm drawn are a plant of 2 m.
// The string does not depend on the leaves. Deriving fewer steps than the axis has segments gives
// the plant of the stroke's first segments, at the same depth.
lsystem::ModelSource write_model(Rule const& rule, DrawnAxis const& axis, Leaves leaves,
                                 std::string const& name);

} // namespace tractus::sketch
