#pragma once

#include "engine/base/vectors.h"

#include <vector>

namespace tractus::render {

// A line in space to be drawn, such as a stroke, a branch of a skeleton, an indicator or a grid
// line.
struct Curve {
    struct Point {
        Vec3f position_mm = Vec3f::Zero();   // Position in the world frame.
        Vec3f color { 0.15f, 0.15f, 0.17f }; // Colour in sRGB, 0 to 1.
        float width = 2;                     // Thickness of the line, in the curve's width unit.
    };

    // Widths in pixels are the same at any distance. Widths in millimetres shrink with distance,
    // like those of tubes.
    enum class WidthUnit { Pixels, Millimetres };

    // Flat lines are drawn in their own colour; round lines are shaded like tubes.
    enum class Look { Flat, Round };

    // Shape of the line's end at its last point.
    enum class End { Plain, Arrow };

    std::vector<Point> points; // A single point is drawn as a dot.
    WidthUnit width_unit = WidthUnit::Pixels;
    Look look = Look::Round;
    End end = End::Plain;
    bool fades = false; // True: the colour fades with depth, as Stage::fade says.
};

} // namespace tractus::render
