#include "engine/mesh/closed_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <utility>

namespace tractus::mesh {

namespace {

using Coordinates = std::array<float, 3>;

Coordinates coordinates_of(Vec3f const& position)
{
    return { position.x(), position.y(), position.z() };
}

// The number of the surface to which each vertex belongs: the least vertex of that surface.
std::vector<std::uint32_t> surface_of_vertices(ClosedMesh const& mesh)
{
    std::vector<std::uint32_t> root(mesh.positions_mm.size());
    std::iota(root.begin(), root.end(), 0);
    auto const find = [&](std::uint32_t vertex) {
        while (root[vertex] != vertex) {
            root[vertex] = root[root[vertex]];
            vertex = root[vertex];
        }
        return vertex;
    };
    for (auto const& [a, b, c] : mesh.triangles)
        for (auto const& [from, to] : { std::pair(a, b), std::pair(b, c) }) {
            auto const first = find(from);
            auto const second = find(to);
            root[std::max(first, second)] = std::min(first, second);
        }
    for (std::uint32_t i = 0; i < root.size(); ++i)
        root[i] = find(i);
    return root;
}

} // namespace

void append(ClosedMesh& mesh, ClosedMesh const& other)
{
    auto const first = static_cast<std::uint32_t>(mesh.positions_mm.size());
    mesh.positions_mm.insert(mesh.positions_mm.end(), other.positions_mm.begin(),
                             other.positions_mm.end());
    mesh.materials.insert(mesh.materials.end(), other.materials.begin(), other.materials.end());
    for (auto const& [a, b, c] : other.triangles)
        mesh.triangles.push_back({ first + a, first + b, first + c });
}

void separate_vertices(ClosedMesh& mesh)
{
    auto& positions = mesh.positions_mm;
    for (auto& position : positions)
        position += Vec3f::Zero(); // Turns -0 into 0.
    std::vector<std::uint32_t> order(positions.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        auto const left = coordinates_of(positions[a]);
        auto const right = coordinates_of(positions[b]);
        return left != right ? left < right : a < b;
    });
    std::vector<Coordinates> taken;
    taken.reserve(order.size());
    std::vector<std::uint32_t> moved;
    for (auto const vertex : order) {
        auto const here = coordinates_of(positions[vertex]);
        if (!taken.empty() && taken.back() == here)
            moved.push_back(vertex);
        else
            taken.push_back(here);
    }
    std::set<Coordinates> added;
    for (auto const vertex : moved) {
        auto here = coordinates_of(positions[vertex]);
        while (std::binary_search(taken.begin(), taken.end(), here) || !added.insert(here).second)
            here[0] = std::nextafter(here[0], std::numeric_limits<float>::infinity());
        positions[vertex].x() = here[0];
    }
}

std::size_t count_surfaces(ClosedMesh const& mesh)
{
    auto const surfaces = surface_of_vertices(mesh);
    std::size_t count = 0;
    for (std::uint32_t i = 0; i < surfaces.size(); ++i)
        count += surfaces[i] == i ? 1 : 0;
    return count;
}

void fill_hollows(ClosedMesh& mesh)
{
    auto const surfaces = surface_of_vertices(mesh);
    std::vector<double> volume(surfaces.size()); // Six times the volume within each surface.
    for (auto const& [a, b, c] : mesh.triangles) {
        // Relative to a point of the surface, to keep the numbers small.
        Vec3 const origin = mesh.positions_mm[surfaces[a]].cast<double>();
        Vec3 const p = mesh.positions_mm[a].cast<double>() - origin;
        Vec3 const q = mesh.positions_mm[b].cast<double>() - origin;
        Vec3 const r = mesh.positions_mm[c].cast<double>() - origin;
        volume[surfaces[a]] += p.dot(q.cross(r));
    }
    std::vector<std::uint32_t> number(surfaces.size());
    ClosedMesh kept;
    for (std::uint32_t i = 0; i < surfaces.size(); ++i) {
        if (volume[surfaces[i]] < 0)
            continue;
        number[i] = static_cast<std::uint32_t>(kept.positions_mm.size());
        kept.positions_mm.push_back(mesh.positions_mm[i]);
        kept.materials.push_back(mesh.materials[i]);
    }
    for (auto const& [a, b, c] : mesh.triangles)
        if (volume[surfaces[a]] >= 0)
            kept.triangles.push_back({ number[a], number[b], number[c] });
    mesh = std::move(kept);
}

} // namespace tractus::mesh
