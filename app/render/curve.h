#pragma once

#include "engine/base/vectors.h"

#include <vector>

namespace tractus::render {

// A line in space to be drawn: a stroke, a branch of a skeleton, an indicator, a grid line.
struct Curve {
    struct Point {
        Vec3f position_mm = Vec3f::Zero();   // World frame.
        Vec3f color { 0.15f, 0.15f, 0.17f }; // sRGB, 0 to 1.
        float width = 2;                     // Diameter, in the curve's unit.
    };

    // Pixels stay the same near and far; millimetres shrink with the distance, as tubes do.
    enum class WidthUnit { Pixels, Millimetres };

    // Flat lines keep their colour; round ones are shaded as tubes.
    enum class Look { Flat, Round };

    // Shape of the last point.
    enum class End { Plain, Arrow };

    std::vector<Point> points; // One point draws a dot.
    WidthUnit width_unit = WidthUnit::Pixels;
    Look look = Look::Round;
    End end = End::Plain;
    bool fades = false; // Fades with the depth: see Stage::fade.
};

} // namespace tractus::render
