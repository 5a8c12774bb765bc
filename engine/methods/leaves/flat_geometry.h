#pragma once

#include "engine/base/vectors.h"

namespace tractus::leaf {

// Positive where b lies counter-clockwise of a.
inline double cross(Vec2 const& a, Vec2 const& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

// Twice a triangle's area, positive where its corners run counter-clockwise.
inline double turn(Vec2 const& a, Vec2 const& b, Vec2 const& c)
{
    return cross(b - a, c - a);
}

} // namespace tractus::leaf
