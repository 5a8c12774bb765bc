#pragma once

#include "engine/base/result.h"
#include "engine/plant/plant.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tractus {

// One line of a skeleton; its direction has no meaning.
struct SkeletonPiece {
    Vec3 from_mm = Vec3::Zero(); // One end, and `to_mm` the other; plant frame.
    Vec3 to_mm = Vec3::Zero();

    bool operator==(SkeletonPiece const&) const = default;
};

struct SkeletonOptions {
    // Line ends that are closer together than this share of the skeleton's greatest extent belong
    // to one joint.
    double tolerance = 1e-5;
    // Radius of the tips as a share of the skeleton's height; other radii follow from the pipe
    // model (pipe_model.h).
    double tip_radius = 0.002;
};

// Builds a plant from lines that another program drew: segments joined at common ends, oriented
// from root to tip (Streit 2006, section 4.1). The root of each connected part is its lowest joint.
// At a fork the axis is continued by the line with the longest path to a tip. A loop is cut where
// the two paths around it meet. Lines of length 0 are left out. The base of the lowest part is
// moved to the origin.
//
// Fails, in a sentence that begins with `name`, if there are no lines, a coordinate is not finite,
// or check_size() fails.
Result<Plant> plant_from_lines(std::string const& name, std::span<SkeletonPiece const> lines,
                               SkeletonOptions const& options = {});

// Reads the lines ("l" elements) of a Wavefront OBJ text, with y up. Lengths are taken as metres if
// the file's extent is below 100 units, and as millimetres otherwise. Fails, in a sentence that
// begins with `name`, if a number is invalid, a vertex is missing, or there are no lines.
Result<std::vector<SkeletonPiece>> parse_obj_lines(std::string const& name, std::string_view text);

} // namespace tractus
