#pragma once

#include "engine/mesh/mesh.h"

#include <string>

namespace tractus::exports {

constexpr int kBillboardViews = 8;
constexpr int kBillboardColumns = 4; // Number of views per row of the atlas.

// A plant as pictures from eight horizontal directions, 45 degrees apart: view 0 from -y, the
// others counter-clockwise as seen from above.
struct Billboard {
    // RGBA picture in PNG (ISO/IEC 15948): the views as equal squares, row by row, transparent
    // outside the plant.
    std::string atlas_png;
    Vec3 center_mm = Vec3::Zero(); // The point that is at the centre of every view, plant frame.
    double side_mm = 0;            // Side length of the square area that each view shows.
};

// Returns a mesh of one square per view. All squares contain the vertical line through the centre.
// Two of them lie on each of four planes, and each is visible from its own side only, so no special
// shader is needed.
mesh::Mesh billboard_mesh(Billboard const& billboard);

} // namespace tractus::exports
