#pragma once

#include "engine/base/result.h"
#include "engine/stroke/resample.h"
#include "engine/variation/association.h"
#include "engine/variation/stroke_laying.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace tractus::variation {

// Change of one segment of a stroke's path.
struct Joint {
    enum class Kind {
        None,  // Nothing: the segment rides as in the base plant.
        Turn,  // It turns by `turn` against the one below, compared with the base plant.
        World, // It points in `direction`, plant frame.
        Laid,  // It points in `direction` of the stroke as drawn, laid by heading and pitch.
    };
    Kind kind = Kind::None;
    Quat turn = Quat::Identity();
    Vec3 direction = Vec3::UnitZ();
    // Of a laid one: the association's number, and the segment's number in its path.
    std::uint32_t stroke = kNone;
    std::uint32_t in_path = 0;
};

// A stroke made ready to be laid along branches of one plant.
struct StrokeShape {
    // Null where only the path follows it, since it is large. Shared between copies.
    std::shared_ptr<ArcLength const> curve;
    StrokeFit fit = StrokeFit::Start;
    // By heading and pitch, and not as in the world.
    bool is_laid_by_heading = false;
    // Of such a stroke (stroke_laying.h): the way to its farthest point as the ground sees it, its
    // first turn, and its aim and the path's direction in the base plant.
    Vec2 reach = Vec2::Zero();
    std::optional<double> first_turn {};
    Aim path_aim {};
    Vec3 path_direction = Vec3::UnitZ();
    // Of any other.
    Quat to_path = Quat::Identity();   // Takes the curve to where the path lies in the base plant.
    Quat from_path = Quat::Identity(); // Takes the curve to the coordinates of an axis' base frame.
    std::vector<Joint> joints;         // One per segment of the path.
};

// Refuses what check_association refuses.
Result<StrokeShape> shape_of(Plant const& plant, RestShape const& rest,
                             Association const& association);

// How a curve that is not laid by heading is turned to lie along a chain of segments as its
// association's fit says: by from_path in the base frame of the axis `id`, or, where the chord is
// matched, by the axis' own chord.
Quat curve_to_axis(Plant const& plant, RestShape const& rest, StrokeShape const& stroke, AxisId id);

} // namespace tractus::variation
