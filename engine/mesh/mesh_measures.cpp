#include "engine/mesh/mesh_measures.h"

#include <algorithm>
#include <limits>

namespace tractus::mesh {

namespace {

// Returns the normal of a triangle, with the triangle's area as its length.
Vec3f area_vector(TriangleMesh const& mesh, std::size_t first_index)
{
    auto const& a = mesh.positions_mm[mesh.indices[first_index]];
    auto const& b = mesh.positions_mm[mesh.indices[first_index + 1]];
    auto const& c = mesh.positions_mm[mesh.indices[first_index + 2]];
    return (b - a).cross(c - a) / 2;
}

} // namespace

float triangle_area(Vec3f const& a, Vec3f const& b, Vec3f const& c)
{
    return (b - a).cross(c - a).norm() / 2;
}

float surface_area(TriangleMesh const& mesh)
{
    float area = 0;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
        area += area_vector(mesh, i).norm();
    return area;
}

bool is_closed(TriangleMesh const& mesh)
{
    Vec3f sum = Vec3f::Zero();
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
        sum += area_vector(mesh, i);
    return sum.norm() < 0.05f * surface_area(mesh);
}

Vec3f placed(InstanceTransform const& instance, Vec3f const& point)
{
    return instance.translation_mm + instance.rotation * instance.scale.cwiseProduct(point);
}

Bounds bounds(TriangleMesh const& mesh)
{
    Bounds box;
    for (auto const& position : mesh.positions_mm)
        box.add(position.cast<double>());
    return box;
}

// Calls use(point) for all vertices of the surfaces, and for the corners of each instance's box.
template<typename Use> static void for_each_point(Mesh const& mesh, Use const& use)
{
    for (auto const& surface : mesh.surfaces)
        for (auto const& position : surface.positions_mm)
            use(position);
    for (auto const& organ : mesh.organs) {
        auto const prototype = bounds(organ.prototype);
        if (prototype.empty())
            continue;
        for (auto const& instance : organ.instances)
            for (int corner = 0; corner < 8; ++corner) {
                Vec3 const point(corner & 1 ? prototype.max_mm.x() : prototype.min_mm.x(),
                                 corner & 2 ? prototype.max_mm.y() : prototype.min_mm.y(),
                                 corner & 4 ? prototype.max_mm.z() : prototype.min_mm.z());
                use(placed(instance, point.cast<float>()));
            }
    }
}

Bounds bounds(Mesh const& mesh)
{
    Bounds box;
    for_each_point(mesh, [&](Vec3f const& point) { box.add(point.cast<double>()); });
    return box;
}

double reach(Mesh const& mesh, Vec3 const& direction)
{
    double most = -std::numeric_limits<double>::infinity();
    for_each_point(mesh, [&](Vec3f const& point) {
        most = std::max(most, direction.dot(point.cast<double>()));
    });
    return most;
}

} // namespace tractus::mesh
