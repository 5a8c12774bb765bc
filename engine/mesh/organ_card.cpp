#include "engine/mesh/organ_card.h"

#include "engine/mesh/mesh_measures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <vector>

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

// Number of parts of a mesh that touch each other in no vertex.
static std::size_t part_count(TriangleMesh const& mesh)
{
    std::vector<std::uint32_t> parent(mesh.positions_mm.size());
    auto const root = [&](std::uint32_t vertex) {
        while (parent[vertex] != vertex)
            vertex = parent[vertex] = parent[parent[vertex]];
        return vertex;
    };
    std::map<std::array<float, 3>, std::uint32_t> places;
    for (std::uint32_t vertex = 0; vertex < parent.size(); ++vertex) {
        auto const& at = mesh.positions_mm[vertex];
        parent[vertex] = places.try_emplace({ at.x(), at.y(), at.z() }, vertex).first->second;
    }
    for (std::size_t i = 0; i < mesh.indices.size(); ++i)
        parent[root(mesh.indices[i])] = root(mesh.indices[i - i % 3]);
    std::size_t count = 0;
    std::vector<bool> is_counted(parent.size());
    for (auto const vertex : mesh.indices)
        if (auto const part = root(vertex); !is_counted[part]) {
            is_counted[part] = true;
            ++count;
        }
    return count;
}

std::optional<TriangleMesh> organ_card(TriangleMesh const& prototype)
{
    constexpr std::size_t kMostParts = 4;
    if (part_count(prototype) > kMostParts)
        return std::nullopt;
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

TriangleMesh organ_spindle(TriangleMesh const& prototype)
{
    constexpr std::uint32_t kCorners = 3;
    auto const box = bounds(prototype);
    Vec3f const middle = (0.5 * (box.min_mm + box.max_mm)).cast<float>();
    Vec3f const half = (0.5 * (box.max_mm - box.min_mm)).cast<float>();
    TriangleMesh spindle;
    spindle.material = prototype.material;
    auto const add = [&](Vec3f const& direction) {
        Vec3f const place = middle + half.cwiseProduct(direction);
        auto const nearest
            = std::ranges::min_element(prototype.positions_mm, {}, [&](Vec3f const& other) {
                  return (other - place).squaredNorm();
              });
        spindle.positions_mm.push_back(place);
        spindle.normals.push_back(direction);
        if (!prototype.texture_coordinates.empty())
            spindle.texture_coordinates.push_back(
                prototype.texture_coordinates[static_cast<std::size_t>(
                    nearest - prototype.positions_mm.begin())]);
    };
    add(-Vec3f::UnitY());
    add(Vec3f::UnitY());
    for (std::uint32_t i = 0; i < kCorners; ++i) {
        float const angle = static_cast<float>(2 * std::numbers::pi * i / kCorners);
        add({ std::sin(angle), 0, std::cos(angle) });
    }
    for (std::uint32_t i = 0; i < kCorners; ++i) {
        auto const corner = 2 + i;
        auto const next = 2 + (i + 1) % kCorners;
        for (auto const index : { 0u, next, corner, 1u, corner, next })
            spindle.indices.push_back(index);
    }
    return spindle;
}

OrganShape coarser_spray(OrganShape const& spray)
{
    constexpr std::size_t kFewestLeaves = 4;
    constexpr std::size_t kMostPerLeaf = 6; // Number of leaves that one leaf replaces, at most.
    constexpr double kLonger = 1.5;
    auto const count = spray.spray.size();
    auto const kept = std::max(std::min(count, kFewestLeaves), count / kMostPerLeaf);
    double const replaced = static_cast<double>(count) / static_cast<double>(kept);
    double const longer = std::min(kLonger, replaced);
    auto coarse = spray;
    coarse.spray.clear();
    coarse.patches.clear();
    for (std::size_t i = 0; i < kept; ++i) {
        // Kept leaves are evenly distributed from the base of the spray to its tip.
        auto const number = (2 * i + 1) * count / (2 * kept);
        auto leaf = spray.spray[number];
        auto patch = spray.patches[number];
        Vec3 const scale(replaced / longer, longer, 1);
        for (auto& point : patch.control) {
            Vec3 const in_leaf = leaf.orientation.conjugate() * (point - leaf.base_mm);
            point = leaf.base_mm + leaf.orientation * scale.cwiseProduct(in_leaf);
        }
        leaf.length_mm *= scale.y();
        leaf.width_mm *= scale.x();
        coarse.spray.push_back(leaf);
        coarse.patches.push_back(patch);
    }
    return coarse;
}

} // namespace tractus::mesh
