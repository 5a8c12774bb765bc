#pragma once

#include "engine/mesh/mesh.h"

#include <string>

namespace tractus::exports {

constexpr int kBillboardViews = 8;
constexpr int kBillboardColumns = 4; // Columns of the atlas.

// A plant as pictures from all sides. View k shows it from the horizontal direction at k * 45
// degrees: view 0 from -y, the next ones from farther to the right (counter-clockwise from above).
struct Billboard {
    // An RGBA picture in PNG (ISO/IEC 15948): the views as equal squares, row by row, transparent
    // where there is no plant.
    std::string atlas_png;
    Vec3 center_mm = Vec3::Zero(); // Plant frame: what is in the middle of each view.
    double side_mm = 0;            // Side of what a view shows.
};

// A square for each view, all through the centre's vertical line: two on each of four planes, each
// seen from its own side only. So it needs no shader of its own.
mesh::Mesh billboard_mesh(Billboard const& billboard);

} // namespace tractus::exports
