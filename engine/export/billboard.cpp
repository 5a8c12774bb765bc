#include "engine/export/billboard.h"

#include <cmath>

namespace tractus::exports {

mesh::Mesh billboard_mesh(Billboard const& billboard)
{
    mesh::Mesh mesh;
    mesh.materials = { { .name = "billboard", .kind = Material::Kind::Solid } };
    auto& squares = mesh.surfaces.emplace_back();
    constexpr int kRows = kBillboardViews / kBillboardColumns;
    for (int view = 0; view < kBillboardViews; ++view) {
        double const turn = 2 * kPi * view / kBillboardViews;
        Vec3 const normal(std::sin(turn), -std::cos(turn), 0);
        Vec3 const right(std::cos(turn), std::sin(turn), 0);
        // Corners run counter-clockwise from the lower left.
        for (int corner = 0; corner < 4; ++corner) {
            double const x = corner == 1 || corner == 2 ? 1 : 0;
            double const y = corner >= 2 ? 1 : 0;
            Vec3 const at = billboard.center_mm
                + billboard.side_mm * ((x - 0.5) * right + (y - 0.5) * Vec3::UnitZ());
            squares.positions_mm.push_back(at.cast<float>());
            squares.normals.push_back(normal.cast<float>());
            squares.texture_coordinates.push_back(
                Vec2((view % kBillboardColumns + x) / kBillboardColumns,
                     (view / kBillboardColumns + 1 - y) / kRows)
                    .cast<float>());
        }
        auto const first = static_cast<std::uint32_t>(4 * view);
        for (std::uint32_t const index : { 0u, 1u, 2u, 0u, 2u, 3u })
            squares.indices.push_back(first + index);
    }
    return mesh;
}

} // namespace tractus::exports
