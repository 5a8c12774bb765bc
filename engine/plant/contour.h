#pragma once

#include "engine/base/vectors.h"

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace tractus {

// Index into Plant::contours.
using ContourId = std::uint16_t;

// The ContourId of a circular section, which has no entry in Plant::contours.
constexpr ContourId kNoContour = std::numeric_limits<ContourId>::max();

// The outline of an axis' cross-section, for fluted stems, ribbons, or leaf blades along a midrib.
struct Contour {
    static constexpr std::size_t kSteps = 256;

    std::string name;
    bool closed = true; // False: the section is a sheet, visible from both sides.
    // kSteps + 1 points at equal parameter steps along the outline, for a node of radius 1: x along
    // the section's normal, y along normal x axis direction, z along the axis. In a closed outline
    // the last point equals the first, and the points run from x towards y.
    std::vector<Vec3f> points;
};

// The cross-section of an axis at one of its nodes.
struct NodeSection {
    ContourId contour = kNoContour;
    ContourId next_contour = kNoContour; // Contour that the section blends into.
    float share = 0;                     // Blend factor, from 0 (`contour`) to 1 (`next_contour`).
    // Direction of the contour's x, in the plant's frame; orthogonal to the axis.
    Vec3f normal = Vec3f::Zero();
    std::uint16_t sides = 8; // Number of sides into which the outline is divided; at least 3.

    bool is_round() const { return contour == kNoContour && next_contour == kNoContour; }
};

} // namespace tractus
