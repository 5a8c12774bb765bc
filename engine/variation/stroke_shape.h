#pragma once

#include "engine/base/result.h"
#include "engine/stroke/resample.h"
#include "engine/variation/association.h"

#include <memory>
#include <span>
#include <vector>

namespace tractus::variation {

// Change of one segment of a stroke's path.
struct Joint {
    enum class Kind {
        None,  // Nothing: the segment rides as in the base plant.
        Turn,  // It turns by `turn` against the one below, compared with the base plant.
        World, // It points in `direction`, plant frame.
    };
    Kind kind = Kind::None;
    Quat turn = Quat::Identity();
    Vec3 direction = Vec3::UnitZ();
};

// A stroke made ready to be laid along branches of one plant.
struct StrokeShape {
    // Null where only the path follows it, since it is large. Shared between copies.
    std::shared_ptr<ArcLength const> curve;
    StrokeFit fit = StrokeFit::Start;
    Quat to_path = Quat::Identity();   // Takes the curve to where the path lies in the base plant.
    Quat from_path = Quat::Identity(); // Takes the curve to the coordinates of an axis' base frame.
    std::vector<Joint> joints;         // One per segment of the path.
};

// Refuses what check_association refuses.
Result<StrokeShape> shape_of(Plant const& plant, RestShape const& rest,
                             Association const& association);

// How a curve is turned to lie along a chain of segments as its association's fit says: by
// from_path in the base frame of the axis `id`, or, where the chord is matched, by the axis' own
// chord.
Quat curve_to_axis(Plant const& plant, RestShape const& rest, StrokeShape const& stroke, AxisId id);

} // namespace tractus::variation
