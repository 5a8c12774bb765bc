#include "engine/mesh/organ_card.h"

#include "engine/mesh/mesh_measures.h"

#include <algorithm>

namespace tractus::mesh {

static void add_rhombus(TriangleMesh& mesh, Vec3f const& base, Vec3f const& tip,
                        Vec3f const& half_width)
{
    auto const first = static_cast<std::uint32_t>(mesh.positions_mm.size());
    Vec3f const middle = (base + tip) / 2;
    mesh.positions_mm.insert(mesh.positions_mm.end(),
                             { base, middle + half_width, tip, middle - half_width });
    mesh.normals.insert(mesh.normals.end(), 4, half_width.cross(tip - base).normalized());
    mesh.texture_coordinates.insert(
        mesh.texture_coordinates.end(),
        { Vec2f(0.5f, 0), Vec2f(1, 0.5f), Vec2f(0.5f, 1), Vec2f(0, 0.5f) });
    for (std::uint32_t const corner : { 0u, 1u, 2u, 0u, 2u, 3u })
        mesh.indices.push_back(first + corner);
}

std::optional<TriangleMesh> organ_card(TriangleMesh const& prototype)
{
    Vec3 const extent = bounds(prototype).max_mm - bounds(prototype).min_mm;
    if (!(extent.y() > 0.5 * extent.maxCoeff()))
        return std::nullopt;
    auto const by_y = [](Vec3f const& a, Vec3f const& b) { return a.y() < b.y(); };
    Vec3f const base = *std::ranges::min_element(prototype.positions_mm, by_y);
    Vec3f const tip = *std::ranges::max_element(prototype.positions_mm, by_y);
    bool const closed = is_closed(prototype);
    float const area = surface_area(prototype) * (closed ? 0.27f : 1.0f);
    float const half_width = area / std::max((tip - base).norm(), 1e-6f);
    TriangleMesh rhombus;
    rhombus.material = prototype.material;
    add_rhombus(rhombus, base, tip, Vec3f(half_width, 0, 0));
    if (closed)
        add_rhombus(rhombus, base, tip, Vec3f(0, 0, half_width));
    return rhombus;
}

} // namespace tractus::mesh
