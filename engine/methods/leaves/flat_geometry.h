#pragma once

#include "engine/base/vectors.h"

namespace tractus::leaf {

// Cross product, positive if b is counter-clockwise of a.
inline double cross(Vec2 const& a, Vec2 const& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

// Signed area of a triangle times two, positive if its corners are counter-clockwise.
inline double turn(Vec2 const& a, Vec2 const& b, Vec2 const& c)
{
    return cross(b - a, c - a);
}

} // namespace tractus::leaf
