#include "engine/export/tangents.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tractus::exports {
namespace {

// Adds a triangle to the sums of its three vertices: the direction in which u increases on the
// triangle, and in w the orientation of (u, v) relative to the triangle. Both are weighted by the
// triangle's area in the texture.
void add_triangle(TriangleView const& triangles, std::size_t first,
                  BulkVector<Eigen::Vector4f>& sums)
{
    std::array<std::size_t, 3> corners {};
    for (std::size_t k = 0; k < corners.size(); ++k)
        corners[k] = triangles.indices[first + k] - triangles.first_vertex;
    auto const& position = triangles.positions_mm;
    auto const& texture = triangles.texture_coordinates;
    Vec3f const a = position[corners[1]] - position[corners[0]];
    Vec3f const b = position[corners[2]] - position[corners[0]];
    Vec2f const at_a = texture[corners[1]] - texture[corners[0]];
    Vec2f const at_b = texture[corners[2]] - texture[corners[0]];
    float const turn = at_a.x() * at_b.y() - at_b.x() * at_a.y();
    Vec3f const along_u = std::copysign(1.0f, turn) * (a * at_b.y() - b * at_a.y());
    Eigen::Vector4f const sum { along_u.x(), along_u.y(), along_u.z(), turn };
    for (auto const corner : corners)
        sums[corner] += sum;
}

Eigen::Vector4f tangent_of(Eigen::Vector4f const& sum, Vec3f const& normal)
{
    Vec3f tangent = sum.head<3>() - normal * normal.dot(sum.head<3>());
    float const length = tangent.norm();
    // If the sum has no direction or is NaN, the tangent is an arbitrary vector orthogonal to the
    // normal.
    tangent = length > 1e-6f * sum.head<3>().norm() ? Vec3f(tangent / length)
                                                    : Vec3f(normal.unitOrthogonal());
    return { tangent.x(), tangent.y(), tangent.z(), sum.w() < 0 ? 1.0f : -1.0f };
}

} // namespace

void find_tangents(TriangleView const& triangles, BulkVector<Eigen::Vector4f>& tangents)
{
    tangents.resize(triangles.positions_mm.size());
    std::fill(tangents.begin(), tangents.end(), Eigen::Vector4f(Eigen::Vector4f::Zero()));
    for (std::size_t i = 0; i + 2 < triangles.indices.size(); i += 3)
        add_triangle(triangles, i, tangents);
    for (std::size_t i = 0; i < tangents.size(); ++i)
        tangents[i] = tangent_of(tangents[i], triangles.normals[i]);
}

} // namespace tractus::exports
