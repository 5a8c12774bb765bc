#include "app/render/leaf_parts.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tractus::render {

bool is_thin(Material const& material)
{
    return material.kind == Material::Kind::Leaf || material.kind == Material::Kind::Petal;
}

namespace {

// A part of a spray: its vertices, and the indices of its triangles.
struct SprayPart {
    std::vector<std::uint32_t> vertices;
    std::vector<std::uint32_t> indices;
};

std::vector<SprayPart> parts_of(mesh::TriangleMesh const& mesh)
{
    auto const connected = connected_parts(mesh);
    std::vector<SprayPart> parts(connected.counts.size());
    for (std::uint32_t i = 0; i < connected.part.size(); ++i)
        parts[connected.part[i]].vertices.push_back(i);
    for (auto const index : mesh.indices)
        parts[connected.part[index]].indices.push_back(index);
    return parts;
}

// Direction between the two vertices of a part that are farthest from each other.
Vec3f long_axis(mesh::TriangleMesh const& mesh, SprayPart const& part)
{
    Vec3f axis = Vec3f::Zero();
    for (auto const a : part.vertices)
        for (auto const b : part.vertices)
            if (Vec3f const way = mesh.positions_mm[b] - mesh.positions_mm[a];
                way.squaredNorm() > axis.squaredNorm())
                axis = way;
    return axis.normalized();
}

// Appends a copy of a part's vertices, `wider` times as far from its long axis, and its triangles
// to `indices`. Returns the copy's width.
float add_wider(mesh::TriangleMesh& mesh, SprayPart const& part, float wider,
                std::vector<std::uint32_t>& indices)
{
    auto const first = static_cast<std::uint32_t>(mesh.positions_mm.size());
    Vec3f const axis = long_axis(mesh, part);
    Vec3f middle = Vec3f::Zero();
    for (auto const vertex : part.vertices)
        middle += mesh.positions_mm[vertex] / static_cast<float>(part.vertices.size());
    float farthest_mm = 0;
    for (auto const vertex : part.vertices) {
        Vec3f const place = mesh.positions_mm[vertex] - middle;
        Vec3f const along = place.dot(axis) * axis;
        farthest_mm = std::max(farthest_mm, wider * (place - along).norm());
        mesh.positions_mm.push_back(middle + along + wider * (place - along));
        mesh.normals.push_back(Vec3f(mesh.normals[vertex]));
        if (!mesh.texture_coordinates.empty())
            mesh.texture_coordinates.push_back(Vec2f(mesh.texture_coordinates[vertex]));
    }
    for (auto const index : part.indices) {
        auto const found = std::ranges::lower_bound(part.vertices, index);
        indices.push_back(first + static_cast<std::uint32_t>(found - part.vertices.begin()));
    }
    return 2 * farthest_mm;
}

} // namespace

std::vector<mesh::CoarseTriangles> thinned_versions(mesh::TriangleMesh& mesh)
{
    constexpr std::size_t kFewestParts = 32;
    constexpr std::size_t kFewestKept = 6;
    constexpr std::size_t kMostIndices = 12; // Of a part, on average.
    auto const parts = parts_of(mesh);
    std::vector<mesh::CoarseTriangles> versions;
    if (parts.size() < kFewestParts || mesh.indices.size() > kMostIndices * parts.size())
        return versions;
    for (std::size_t every = 2; parts.size() / every >= kFewestKept; every *= 2) {
        auto& version = versions.emplace_back();
        for (auto i = every / 2; i < parts.size(); i += every)
            version.error_mm
                = std::max(version.error_mm,
                           add_wider(mesh, parts[i], static_cast<float>(every), version.indices));
    }
    return versions;
}

ConnectedParts connected_parts(mesh::TriangleMesh const& mesh)
{
    constexpr auto kNone = ~std::uint32_t { 0 };
    // Each vertex leads to an earlier one of its part; the first one leads to itself.
    std::vector<std::uint32_t> earlier(mesh.positions_mm.size());
    std::iota(earlier.begin(), earlier.end(), 0u);
    auto const first_of = [&](std::uint32_t vertex) {
        while (earlier[vertex] != vertex)
            vertex = earlier[vertex] = earlier[earlier[vertex]];
        return vertex;
    };
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
        for (std::size_t k = 1; k < 3; ++k) {
            auto const a = first_of(mesh.indices[i]);
            auto const b = first_of(mesh.indices[i + k]);
            earlier[std::max(a, b)] = std::min(a, b);
        }
    ConnectedParts parts;
    std::vector<std::uint32_t> number(earlier.size(), kNone);
    std::vector<Vec3> sums;
    parts.part.reserve(earlier.size());
    for (std::uint32_t i = 0; i < earlier.size(); ++i) {
        auto& part = number[first_of(i)];
        if (part == kNone) {
            part = static_cast<std::uint32_t>(sums.size());
            sums.emplace_back(Vec3::Zero());
            parts.counts.push_back(0);
        }
        parts.part.push_back(part);
        sums[part] += mesh.positions_mm[i].cast<double>();
        ++parts.counts[part];
    }
    for (std::size_t i = 0; i < sums.size(); ++i)
        parts.middles_mm.emplace_back((sums[i] / parts.counts[i]).cast<float>());
    return parts;
}

Vec3f middle_of_largest_part(mesh::TriangleMesh const& mesh)
{
    auto const parts = connected_parts(mesh);
    auto const largest = std::ranges::max_element(parts.counts) - parts.counts.begin();
    return parts.middles_mm[static_cast<std::size_t>(largest)];
}

Vec2f individual_at(Vec3f const& middle_mm)
{
    // Middles are rounded to whole cells, since those of merged leaves have other rounding errors.
    constexpr float kCell_mm = 2;
    std::uint32_t hash = 0;
    for (int axis = 0; axis < 3; ++axis) {
        float const cell = std::clamp(std::floor(middle_mm[axis] / kCell_mm), -1e9f, 1e9f);
        hash ^= static_cast<std::uint32_t>(static_cast<std::int32_t>(cell));
        hash *= 0x9e3779b9u;
        hash = (hash ^ (hash >> 16)) * 0x7feb352du;
        hash = (hash ^ (hash >> 15)) * 0x846ca68bu;
    }
    return Vec2f(static_cast<float>(hash & 0xffffu), static_cast<float>(hash >> 16)) / 65535.0f;
}

} // namespace tractus::render
