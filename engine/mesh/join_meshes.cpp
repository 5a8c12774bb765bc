#include "engine/mesh/join_meshes.h"

#include <algorithm>

namespace tractus::mesh {

namespace {

void append_triangles(TriangleMesh& mesh, Vec3f const& moved_mm, MaterialId first_material)
{
    mesh.material = static_cast<MaterialId>(mesh.material + first_material);
    for (auto& position_mm : mesh.positions_mm)
        position_mm += moved_mm;
}

// Returns one more than the highest index of an organ shape in the mesh.
std::uint16_t shape_count(Mesh const& mesh)
{
    std::uint16_t count = 0;
    for (auto const& organ : mesh.organs)
        count = std::max(count, static_cast<std::uint16_t>(organ.shape + 1));
    return count;
}

} // namespace

void append_mesh(Mesh& mesh, Mesh const& other, Vec3f const& moved_mm)
{
    auto const first_material = static_cast<MaterialId>(mesh.materials.size());
    auto const first_shape = shape_count(mesh);
    mesh.materials.insert(mesh.materials.end(), other.materials.begin(), other.materials.end());
    for (auto surface : other.surfaces) {
        append_triangles(surface, moved_mm, first_material);
        mesh.surfaces.push_back(std::move(surface));
    }
    for (auto organ : other.organs) {
        append_triangles(organ.prototype, Vec3f::Zero(), first_material);
        organ.shape = static_cast<std::uint16_t>(organ.shape + first_shape);
        for (auto& instance : organ.instances)
            instance.translation_mm += moved_mm;
        mesh.organs.push_back(std::move(organ));
    }
}

} // namespace tractus::mesh
