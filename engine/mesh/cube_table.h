#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tractus::mesh {

// How a surface passes through a cube whose corners are inside or outside of it (marching cubes:
// Lorensen, Cline 1987). Corner i is at (i & 1, i >> 1 & 1, i >> 2 & 1). The surface crosses the
// edges between a corner inside and one outside.
//
// The triangles of neighbouring cubes fit together to closed surfaces of which each edge has
// exactly two triangles: on a face with two opposite corners inside, the surface separates these;
// and no edge between two triangles of one cube lies on a face.
class CubeTable {
public:
    struct Edge {
        int axis;   // 0 to 2.
        int corner; // The edge's end with the lower coordinate.
    };
    static constexpr int kEdges = 12;
    using Triangle = std::array<std::uint8_t, 3>; // Numbers of crossed edges.

    // The table, made when it is first needed.
    static CubeTable const& get();

    // An edge of the cube; `number`: 0 to kEdges - 1.
    Edge const& edge(std::size_t number) const { return edges_[number]; }

    // Triangles for a cube; bit i of `inside` says whether corner i is inside. Counter-clockwise as
    // seen from outside.
    std::span<Triangle const> triangles(std::uint8_t inside) const { return triangles_[inside]; }

private:
    using Loop = std::vector<std::uint8_t>;

    CubeTable();
    std::uint8_t edge_between(int a, int b) const;
    void add_crossings(std::array<int, 4> const& face, unsigned inside,
                       std::array<int, kEdges>& next) const;
    bool share_face(std::uint8_t a, std::uint8_t b) const;
    bool divide(Loop const& loop, std::vector<Triangle>& triangles) const;

    std::array<Edge, kEdges> edges_ {};
    std::array<std::vector<Triangle>, 256> triangles_ {};
};

} // namespace tractus::mesh
