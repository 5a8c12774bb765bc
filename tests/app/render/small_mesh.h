#pragma once

#include "engine/mesh/mesh.h"

#include <array>

namespace tractus::render {

constexpr MaterialId kBarkMaterial = 0;
constexpr MaterialId kLeafMaterial = 1;

inline void add_quad(mesh::TriangleMesh& mesh, std::array<Vec3f, 4> const& corners)
{
    auto const first = static_cast<std::uint32_t>(mesh.positions_mm.size());
    Vec3f const normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
    std::array<Vec2f, 4> const square { Vec2f(0, 0), Vec2f(1, 0), Vec2f(1, 1), Vec2f(0, 1) };
    for (std::size_t i = 0; i < 4; ++i) {
        mesh.positions_mm.push_back(corners[i]);
        mesh.normals.push_back(normal);
        mesh.texture_coordinates.push_back(square[i]);
    }
    for (std::uint32_t const corner : { 0u, 1u, 2u, 0u, 2u, 3u })
        mesh.indices.push_back(first + corner);
}

// Returns a square post of bark, 40 mm wide and 300 mm high, and a leaf on each side of it at x =
// -200 and x = 200 mm. The leaves are upright squares of 100 mm that face the user (-y), at a
// height of 250 mm.
inline mesh::Mesh post_with_leaves()
{
    mesh::Mesh mesh;
    mesh.materials.push_back(
        { .name = "bark", .kind = Material::Kind::Bark, .base_color = { 0.40f, 0.28f, 0.18f } });
    mesh.materials.push_back({ .name = "leaf",
                               .kind = Material::Kind::Leaf,
                               .base_color = { 0.25f, 0.55f, 0.15f },
                               .roughness = 0.6f,
                               .translucency = 0.4f });
    auto& post = mesh.surfaces.emplace_back();
    post.material = kBarkMaterial;
    for (int side = 0; side < 4; ++side) {
        Eigen::AngleAxisf const turn(static_cast<float>(side) * 1.5707963f, Vec3f::UnitZ());
        add_quad(post,
                 { turn * Vec3f(-20, -20, 0), turn * Vec3f(20, -20, 0), turn * Vec3f(20, -20, 300),
                   turn * Vec3f(-20, -20, 300) });
    }
    auto& leaf = mesh.organs.emplace_back();
    leaf.prototype.material = kLeafMaterial;
    add_quad(leaf.prototype,
             { Vec3f(-50, 0, -50), Vec3f(50, 0, -50), Vec3f(50, 0, 50), Vec3f(-50, 0, 50) });
    leaf.instances.push_back({ .translation_mm = { -200, 0, 250 } });
    leaf.instances.push_back({ .translation_mm = { 200, 0, 250 } });
    return mesh;
}

} // namespace tractus::render
