#pragma once

#include "engine/mesh/mesh.h"

#include <string>

namespace tractus::exports {

constexpr int kBillboardViews = 8;
constexpr int kBillboardColumns = 4; // Number of views per row of the atlas.

// A plant as pictures from eight directions. View k shows it horizontally from the direction at k *
// 45 degrees: view 0 from -y, later ones counter-clockwise as seen from above.
struct Billboard {
    // RGBA picture in PNG (ISO/IEC 15948): the views as equal squares, row by row, transparent
    // outside the plant.
    std::string atlas_png;
    Vec3 center_mm = Vec3::Zero(); // The point at the centre of each view, plant frame.
    double side_mm = 0;            // Side length of the square area that each view shows.
};

// Returns a square for each view, all through the vertical line through the centre: two on each of
// four planes, each visible from its own side only, so no special shader is needed.
mesh::Mesh billboard_mesh(Billboard const& billboard);

} // namespace tractus::exports
