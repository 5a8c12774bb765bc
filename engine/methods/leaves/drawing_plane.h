#pragma once

#include "engine/base/vectors.h"

#include <vector>

namespace tractus::leaf {

// Least-squares plane of the drawing of a leaf. Its normal points up or, if the plane is upright,
// towards the viewer. Seen from the normal's side, `right` is to the right of `up`.
struct DrawingPlane {
    Vec3 center = Vec3::Zero();
    Vec3 right = Vec3::UnitX();
    Vec3 up = Vec3::UnitY();
    Vec3 normal = Vec3::UnitZ();

    explicit DrawingPlane(std::vector<std::vector<Vec3>> const& lines);

    Vec2 flat(Vec3 const& point) const
    {
        return { (point - center).dot(right), (point - center).dot(up) };
    }
};

} // namespace tractus::leaf
