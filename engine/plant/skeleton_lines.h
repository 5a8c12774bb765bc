#pragma once

#include "engine/base/result.h"
#include "engine/plant/plant.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tractus {

// One piece of a skeleton, in no particular direction.
struct SkeletonPiece {
    Vec3 from_mm = Vec3::Zero(); // Plant frame.
    Vec3 to_mm = Vec3::Zero();

    bool operator==(SkeletonPiece const&) const = default;
};

struct SkeletonOptions {
    // Ends nearer than this belong to one joint, as a share of the skeleton's greatest extent.
    double tolerance = 1e-5;
    // Radius of the leaf branches as a share of the skeleton's height; the others follow by the
    // pipe model (pipe_model.h).
    double tip_radius = 0.002;
};

// A plant from lines that another program drew: segments joined at common ends, root to tip
// (Streit 2006 section 4.1). The root of each connected part is its lowest joint. From a joint that
// several lines leave, the axis goes on into the one that bears the longest way to a tip. A loop is
// cut where both ways around it meet. Lines without length are left out. The base of the lowest
// part is put at the origin.
//
// Refuses, in a sentence that begins with `name`, no lines, infinite lines, and as check_size().
Result<Plant> plant_from_lines(std::string const& name, std::span<SkeletonPiece const> lines,
                               SkeletonOptions const& options = {});

// The lines ("l" elements) of a Wavefront OBJ text; its y axis is up. Lengths are metres where the
// whole is smaller than 100 units, else millimetres. Refuses, in a sentence that begins with
// `name`, numbers that are none, vertices that are not there, and a text without lines.
Result<std::vector<SkeletonPiece>> parse_obj_lines(std::string const& name, std::string_view text);

} // namespace tractus
