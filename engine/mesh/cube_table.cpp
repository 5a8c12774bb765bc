#include "engine/mesh/cube_table.h"

#include "engine/base/check.h"

#include <cstddef>
#include <utility>

namespace tractus::mesh {

namespace {

// The corners of each face, counter-clockwise as seen from outside of the cube.
std::array<std::array<int, 4>, 6> cube_faces()
{
    std::array<std::array<int, 4>, 6> faces {};
    for (int axis = 0; axis < 3; ++axis) {
        int const u = 1 << (axis + 1) % 3;
        int const v = 1 << (axis + 2) % 3;
        int const far = 1 << axis;
        faces[static_cast<std::size_t>(2 * axis)] = { 0, v, u | v, u };
        faces[static_cast<std::size_t>(2 * axis + 1)] = { far, far | u, far | u | v, far | v };
    }
    return faces;
}

} // namespace

CubeTable const& CubeTable::get()
{
    static CubeTable const table;
    return table;
}

CubeTable::CubeTable()
{
    std::size_t count = 0;
    for (int axis = 0; axis < 3; ++axis)
        for (int corner = 0; corner < 8; ++corner)
            if ((corner >> axis & 1) == 0)
                edges_[count++] = { axis, corner };
    for (unsigned inside = 0; inside < 256; ++inside) {
        std::array<int, kEdges> next {};
        next.fill(-1);
        for (auto const& face : cube_faces())
            add_crossings(face, inside, next);
        for (std::uint8_t first = 0; first < kEdges; ++first) {
            Loop loop;
            for (int edge = first; next[static_cast<std::size_t>(edge)] >= 0;) {
                loop.push_back(static_cast<std::uint8_t>(edge));
                edge = std::exchange(next[static_cast<std::size_t>(edge)], -1);
            }
            if (!loop.empty())
                CHECK(divide(loop, triangles_[inside]));
        }
    }
}

std::uint8_t CubeTable::edge_between(int a, int b) const
{
    for (std::uint8_t i = 0; i < kEdges; ++i) {
        auto const& [axis, corner] = edges_[i];
        int const other = corner | 1 << axis;
        if ((corner == a && other == b) || (corner == b && other == a))
            return i;
    }
    CHECK(false);
    return 0;
}

// Adds the lines in which the surface crosses a face: around each run of corners inside, from the
// edge before it to the edge after it.
void CubeTable::add_crossings(std::array<int, 4> const& face, unsigned inside,
                              std::array<int, kEdges>& next) const
{
    auto const corner = [&](std::size_t i) { return face[i % 4]; };
    auto const is_inside = [&](std::size_t i) { return (inside >> corner(i) & 1) != 0; };
    for (std::size_t i = 0; i < 4; ++i) {
        if (!is_inside(i) || is_inside(i + 3))
            continue;
        auto last = i;
        while (is_inside(last + 1))
            ++last;
        next[edge_between(corner(i + 3), corner(i))] = edge_between(corner(last), corner(last + 1));
    }
}

bool CubeTable::share_face(std::uint8_t a, std::uint8_t b) const
{
    int const first = edges_[a].corner;
    int const second = edges_[b].corner;
    for (int axis = 0; axis < 3; ++axis)
        if (edges_[a].axis != axis && edges_[b].axis != axis
            && (first >> axis & 1) == (second >> axis & 1))
            return true;
    return false;
}

// Divides a loop of crossed edges into triangles whose common edges lie on no face of the cube.
// Returns false if there is no such division.
bool CubeTable::divide(Loop const& loop, std::vector<Triangle>& triangles) const
{
    auto const size = loop.size();
    if (size == 3) {
        triangles.push_back({ loop[0], loop[1], loop[2] });
        return true;
    }
    for (std::size_t i = 0; i < size; ++i) {
        auto const before = loop[(i + size - 1) % size];
        auto const after = loop[(i + 1) % size];
        if (share_face(before, after))
            continue;
        auto rest = loop;
        rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
        auto found = triangles;
        if (divide(rest, found)) {
            found.push_back({ before, loop[i], after });
            triangles = std::move(found);
            return true;
        }
    }
    return false;
}

} // namespace tractus::mesh
