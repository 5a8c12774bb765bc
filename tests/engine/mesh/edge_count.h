#pragma once

#include "engine/mesh/closed_mesh.h"

#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace tractus::mesh {

using Corner = std::array<float, 3>;

// A triangle as a file has it: the positions of its corners.
using Corners = std::array<Corner, 3>;

// Number of edges that are not shared by exactly two triangles, which run along it in opposite
// directions. An edge is known by the positions of its ends, as in an STL file.
inline std::size_t count_bad_edges(std::vector<Corners> const& triangles)
{
    struct Uses {
        int forth = 0;
        int back = 0;
    };
    std::map<std::pair<Corner, Corner>, Uses> edges;
    for (auto const& corners : triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            auto const& from = corners[k];
            auto const& to = corners[(k + 1) % 3];
            if (from < to)
                ++edges[{ from, to }].forth;
            else
                ++edges[{ to, from }].back;
        }
    std::size_t bad = 0;
    for (auto const& [edge, uses] : edges)
        bad += uses.forth == 1 && uses.back == 1 && edge.first != edge.second ? 0 : 1;
    return bad;
}

inline std::vector<Corners> corners_of(ClosedMesh const& mesh)
{
    std::vector<Corners> triangles;
    for (auto const& triangle : mesh.triangles) {
        Corners corners;
        for (std::size_t k = 0; k < 3; ++k) {
            auto const& at = mesh.positions_mm[triangle[k]];
            corners[k] = { at.x(), at.y(), at.z() };
        }
        triangles.push_back(corners);
    }
    return triangles;
}

// Volume inside of all surfaces; where they overlap it counts repeatedly.
inline double volume_mm3(ClosedMesh const& mesh)
{
    double sum = 0;
    for (auto const& [a, b, c] : mesh.triangles) {
        auto const& at = mesh.positions_mm;
        sum += at[a].cast<double>().dot(at[b].cast<double>().cross(at[c].cast<double>()));
    }
    return sum / 6;
}

inline Eigen::AlignedBox3f box_mm(ClosedMesh const& mesh)
{
    Eigen::AlignedBox3f box;
    for (auto const& position : mesh.positions_mm)
        box.extend(position);
    return box;
}

} // namespace tractus::mesh
