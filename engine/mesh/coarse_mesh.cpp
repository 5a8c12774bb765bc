#include "engine/mesh/coarse_mesh.h"

#include <algorithm>
#include <array>
#include <meshoptimizer.h>

namespace tractus::mesh {

namespace {

float extent_mm(TriangleMesh const& mesh)
{
    return meshopt_simplifyScale(mesh.positions_mm.data()->data(), mesh.positions_mm.size(),
                                 sizeof(Vec3f));
}

} // namespace

CoarseTriangles coarse_version(TriangleMesh const& mesh, float max_error_mm)
{
    constexpr std::size_t kFewest = 6; // Indices of two triangles.
    auto const* const positions = mesh.positions_mm.data()->data();
    auto const count = mesh.positions_mm.size();
    CoarseTriangles version;
    version.indices.resize(mesh.indices.size());
    float const extent = std::max(extent_mm(mesh), 1e-6f);
    float reached = 0;
    version.indices.resize(meshopt_simplify(
        version.indices.data(), mesh.indices.data(), mesh.indices.size(), positions, count,
        sizeof(Vec3f), std::min(kFewest, mesh.indices.size()), max_error_mm / extent, 0, &reached));
    version.error_mm = reached * extent;
    return version;
}

std::vector<CoarseTriangles> coarse_versions(TriangleMesh const& mesh)
{
    constexpr std::array kErrors { 0.005f, 0.015f, 0.04f, 0.1f };
    constexpr double kMostOfFormer = 0.8; // A version that saves less is not worth keeping.
    std::vector<CoarseTriangles> versions;
    float const extent = extent_mm(mesh);
    auto former = static_cast<double>(mesh.indices.size());
    for (float const error : kErrors) {
        auto version = coarse_version(mesh, error * extent);
        auto const size = static_cast<double>(version.indices.size());
        if (size == 0 || size > kMostOfFormer * former)
            continue;
        former = size;
        versions.push_back(std::move(version));
    }
    return versions;
}

TriangleMesh simplified(TriangleMesh const& mesh, float max_error_mm)
{
    constexpr auto kUnused = ~std::uint32_t { 0 };
    bool const is_textured = !mesh.texture_coordinates.empty();
    TriangleMesh made;
    made.material = mesh.material;
    std::vector<std::uint32_t> number(mesh.positions_mm.size(), kUnused);
    for (auto const index : coarse_version(mesh, max_error_mm).indices) {
        if (number[index] == kUnused) {
            number[index] = static_cast<std::uint32_t>(made.positions_mm.size());
            made.positions_mm.push_back(mesh.positions_mm[index]);
            made.normals.push_back(mesh.normals[index]);
            if (is_textured)
                made.texture_coordinates.push_back(mesh.texture_coordinates[index]);
        }
        made.indices.push_back(number[index]);
    }
    return made;
}

} // namespace tractus::mesh
