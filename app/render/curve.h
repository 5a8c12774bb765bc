#pragma once

#include "engine/base/vectors.h"

#include <vector>

namespace tractus::render {

// A line in space to draw: a stroke, a branch of a skeleton, an indicator, a grid line.
struct Curve {
    struct Point {
        Vec3f position_mm = Vec3f::Zero();   // Position in the world frame.
        Vec3f color { 0.15f, 0.15f, 0.17f }; // Colour in sRGB, 0 to 1.
        float width = 2;                     // Diameter in the curve's width unit.
    };

    // Widths in pixels do not depend on the distance; widths in millimetres shrink with it, like
    // those of tubes.
    enum class WidthUnit { Pixels, Millimetres };

    // Flat lines keep their colour; round ones are shaded as tubes.
    enum class Look { Flat, Round };

    // Shape of the last point.
    enum class End { Plain, Arrow };

    std::vector<Point> points; // A single point is drawn as a dot.
    WidthUnit width_unit = WidthUnit::Pixels;
    Look look = Look::Round;
    End end = End::Plain;
    bool fades = false; // True: the colour fades with depth; see Stage::fade.
};

} // namespace tractus::render
