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

// How a stroke changes one segment of the path of branches that it shapes (Association::path).
struct Joint {
    enum class Kind {
        None, // The stroke does not change the segment, which moves rigidly with its parent.
        // The segment's rotation relative to its parent differs from that in the base plant by
        // `turn`.
        Turn,
        World, // The segment has the direction `direction`, plant frame.
        // `direction` is that of the stroke as drawn; the segment has it after alignment by heading
        // and pitch.
        Laid,
    };
    Kind kind = Kind::None;
    Quat turn = Quat::Identity();
    Vec3 direction = Vec3::UnitZ();
    // For Kind::Laid: number of the association. `in_path`: the segment's number in the
    // association's path.
    std::uint32_t stroke = kNone;
    std::uint32_t in_path = 0;
};

// A stroke prepared for alignment with the branches of one plant.
struct StrokeShape {
    // The stroke by arc length, shared between copies of StrokeShape. Null, to save memory, if the
    // stroke shapes only its path and no descendants.
    std::shared_ptr<ArcLength const> curve;
    StrokeFit fit = StrokeFit::Start;
    // True if the stroke is aligned by heading and pitch and its fit is not StrokeFit::World.
    bool is_laid_by_heading = false;
    // Used only for strokes aligned by heading (stroke_laying.h): the horizontal vector to the
    // farthest point (farthest_reach()), first_turn_share(), the stroke's aim for the path, and the
    // path's direction in the base plant.
    Vec2 reach = Vec2::Zero();
    std::optional<double> first_turn {};
    Aim path_aim {};
    Vec3 path_direction = Vec3::UnitZ();
    // to_path and from_path are used only for strokes that are not aligned by heading.
    Quat to_path = Quat::Identity(); // Rotates the curve to the path in the base plant.
    // Rotates the curve to the coordinates of the frame at an axis' base.
    Quat from_path = Quat::Identity();
    std::vector<Joint> joints; // How the stroke changes each segment of its path.
};

// Prepares the stroke of an association. Fails if check_association() fails.
Result<StrokeShape> shape_of(Plant const& plant, RestShape const& rest,
                             Association const& association);

// Returns the rotation that aligns the curve of `stroke` with the axis `id`, for strokes that are
// not aligned by heading: from_path in the frame at the axis' base, then, for StrokeFit::Chord, a
// correction to the chord of the axis. With StrokeFit::World this is the identity.
Quat curve_to_axis(Plant const& plant, RestShape const& rest, StrokeShape const& stroke, AxisId id);

} // namespace tractus::variation
