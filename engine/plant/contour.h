#pragma once

#include "engine/base/vectors.h"

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace tractus {

// Index into Plant::contours.
using ContourId = std::uint16_t;

// Says in place of a contour that the section is a circle.
constexpr ContourId kNoContour = std::numeric_limits<ContourId>::max();

// The outline of an axis' cross-section: fluted stems, ribbons, leaf blades along a midrib.
struct Contour {
    static constexpr std::size_t kSteps = 256;

    std::string name;
    bool closed = true; // An open one is a sheet, seen from both sides.
    // kSteps + 1 points at equal steps along the outline; the last of a closed one is its first.
    // For a node of radius 1: x along the section's normal, y along normal x axis, z along the
    // axis. A closed outline turns from x to y.
    std::vector<Vec3f> points;
};

// How an axis' cross-section looks at one of its nodes.
struct NodeSection {
    ContourId contour = kNoContour;
    ContourId next_contour = kNoContour; // Contour that it is becoming.
    float share = 0;                     // 0 `contour` to 1 `next_contour`.
    Vec3f normal = Vec3f::Zero();        // The contour's x in the plant's frame; across the axis.
    std::uint16_t sides = 8;             // Into how many sides the outline is to be cut; 3 or more.

    bool is_round() const { return contour == kNoContour && next_contour == kNoContour; }
};

} // namespace tractus
