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

// How a stroke changes one segment of its path.
struct Joint {
    enum class Kind {
        None,  // Unchanged: the segment moves rigidly with its parent.
        Turn,  // Rotated by `turn` relative to its parent, compared with the base plant.
        World, // Has the direction `direction`, plant frame.
        Laid, // Has the direction `direction` of the stroke as drawn, aligned by heading and pitch.
    };
    Kind kind = Kind::None;
    Quat turn = Quat::Identity();
    Vec3 direction = Vec3::UnitZ();
    // For Kind::Laid: number of the association, and `in_path`: the segment's number in its path.
    std::uint32_t stroke = kNone;
    std::uint32_t in_path = 0;
};

// A stroke prepared for alignment with the branches of one plant.
struct StrokeShape {
    // The stroke by arc length, shared between copies. Null, to save memory, if only the path
    // follows the stroke.
    std::shared_ptr<ArcLength const> curve;
    StrokeFit fit = StrokeFit::Start;
    // True if the stroke is aligned by heading and pitch and its fit is not StrokeFit::World.
    bool is_laid_by_heading = false;
    // For strokes aligned by heading (stroke_laying.h): horizontal vector to the farthest point,
    // first turn, aim, and the path's direction in the base plant.
    Vec2 reach = Vec2::Zero();
    std::optional<double> first_turn {};
    Aim path_aim {};
    Vec3 path_direction = Vec3::UnitZ();
    // The next two are for strokes that are not aligned by heading.
    Quat to_path = Quat::Identity(); // Rotates the curve to the path in the base plant.
    // Rotates the curve to the coordinates of an axis' base frame.
    Quat from_path = Quat::Identity();
    std::vector<Joint> joints; // How the stroke changes each segment of its path.
};

// Fails like check_association().
Result<StrokeShape> shape_of(Plant const& plant, RestShape const& rest,
                             Association const& association);

// Returns the rotation that aligns the curve of `stroke`, which is not aligned by heading, with the
// axis `id`: from_path in the axis' base frame, then, for StrokeFit::Chord, corrected to the chord
// of the axis. With StrokeFit::World nothing is rotated.
Quat curve_to_axis(Plant const& plant, RestShape const& rest, StrokeShape const& stroke, AxisId id);

} // namespace tractus::variation
