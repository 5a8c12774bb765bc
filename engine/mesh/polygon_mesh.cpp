#include "engine/mesh/polygon_mesh.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace tractus::mesh {
namespace {

Vec3 newell_normal(std::span<Vec3 const> vertices)
{
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 1; i + 1 < vertices.size(); ++i)
        sum += (vertices[i] - vertices[0]).cross(vertices[i + 1] - vertices[0]);
    return sum;
}

double cross(Vec2 const& a, Vec2 const& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

bool inside(Vec2 const& point, Vec2 const& a, Vec2 const& b, Vec2 const& c)
{
    return cross(b - a, point - a) >= 0 && cross(c - b, point - b) >= 0
        && cross(a - c, point - c) >= 0;
}

bool is_ear(std::vector<Vec2> const& points, std::vector<std::uint32_t> const& ring, std::size_t at)
{
    auto const size = ring.size();
    auto const before = ring[(at + size - 1) % size];
    auto const here = ring[at];
    auto const after = ring[(at + 1) % size];
    if (cross(points[here] - points[before], points[after] - points[here]) <= 0)
        return false;
    return std::none_of(ring.begin(), ring.end(), [&](std::uint32_t other) {
        return other != before && other != here && other != after && points[other] != points[before]
            && points[other] != points[here] && points[other] != points[after]
            && inside(points[other], points[before], points[here], points[after]);
    });
}

// Clips ears until one triangle is left. If the outline has no ear left, because it crosses itself,
// the next corner is clipped instead, so that the loop always ends.
std::vector<std::uint32_t> clip_ears(std::vector<Vec2> const& points)
{
    std::vector<std::uint32_t> ring(points.size());
    for (std::uint32_t i = 0; i < ring.size(); ++i)
        ring[i] = i;
    std::vector<std::uint32_t> triangles;
    std::size_t at = 0;
    for (std::size_t failures = 0; ring.size() > 2;) {
        at %= ring.size();
        if (!is_ear(points, ring, at) && failures < ring.size()) {
            ++at;
            ++failures;
            continue;
        }
        auto const size = ring.size();
        triangles.insert(triangles.end(),
                         { ring[(at + size - 1) % size], ring[at], ring[(at + 1) % size] });
        ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(at));
        failures = 0;
    }
    return triangles;
}

// Returns the direction in which the texture coordinate v increases: from the first vertex towards
// the vertex farthest from it.
Vec3 long_direction(std::span<Vec3 const> vertices, Vec3 const& normal)
{
    Vec3 longest = Vec3::Zero();
    for (auto const& vertex : vertices) {
        Vec3 const flat = vertex - vertices[0] - normal * normal.dot(vertex - vertices[0]);
        if (flat.squaredNorm() > longest.squaredNorm())
            longest = flat;
    }
    return longest.norm() > 0 ? Vec3(longest.normalized()) : normal.unitOrthogonal();
}

// Returns the unit normal of the polygon; no value if the polygon has no area.
std::optional<Vec3> flat_normal(std::span<Vec3 const> vertices)
{
    Vec3 const area = newell_normal(vertices);
    double const length = area.norm();
    if (!(length > 1e-9) || !std::isfinite(length))
        return std::nullopt;
    return Vec3(area / length);
}

} // namespace

MeshExtent polygon_extent(std::span<Vec3 const> vertices_mm)
{
    if (!flat_normal(vertices_mm))
        return {};
    return { vertices_mm.size(), 3 * (vertices_mm.size() - 2) };
}

void write_polygon(std::span<Vec3 const> vertices_mm, TrianglePlace& place)
{
    auto const normal = flat_normal(vertices_mm);
    if (!normal)
        return;
    Vec3 const along = long_direction(vertices_mm, *normal);
    Vec3 const across = along.cross(*normal);

    std::vector<Vec2> points;
    Vec2 low = Vec2::Zero();
    Vec2 high = Vec2::Zero();
    for (auto const& vertex : vertices_mm) {
        Vec3 const offset = vertex - vertices_mm[0];
        points.emplace_back(across.dot(offset), along.dot(offset));
        low = low.cwiseMin(points.back());
        high = high.cwiseMax(points.back());
    }
    Vec2 const size = (high - low).cwiseMax(1e-9);
    for (std::size_t i = 0; i < points.size(); ++i) {
        *place.position_mm++ = vertices_mm[i].cast<float>();
        *place.normal++ = normal->cast<float>();
        *place.texture++ = (points[i] - low).cwiseQuotient(size).cast<float>();
    }
    for (auto const corner : clip_ears(points))
        *place.index++ = place.vertex + corner;
    place.vertex += static_cast<std::uint32_t>(points.size());
}

} // namespace tractus::mesh
