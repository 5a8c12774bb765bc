#include "app/render/leaf_parts.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tractus::render {

bool is_thin(Material const& material)
{
    return material.kind == Material::Kind::Leaf || material.kind == Material::Kind::Petal;
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
