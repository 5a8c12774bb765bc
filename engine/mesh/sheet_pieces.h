#pragma once

#include "engine/mesh/closed_mesh.h"
#include "engine/mesh/mesh.h"

#include <array>
#include <cstdint>
#include <vector>

namespace tractus::mesh {

// A connected surface, closed or with a rim, of which no edge has more than two triangles. Vertices
// at the same place are one, without regard to normals and textures.
struct SheetPiece {
    std::vector<Vec3f> positions_mm;
    std::vector<ClosedMesh::Triangle> triangles;
    // Edges with a single triangle, from vertex to vertex as that triangle runs along them; empty
    // for a closed piece. Each vertex of the rim begins one of them and ends one.
    std::vector<std::array<std::uint32_t, 2>> rim;

    bool is_closed() const { return rim.empty(); }
};

// Divides triangles into pieces. The surface is cut along edges that belong to more than two
// triangles, or whose triangles have opposite sides. Triangles without area and repeated triangles
// are left out, so the front and the back of a leaf are one sheet. The triangles of closed pieces
// are counter-clockwise as seen from outside.
std::vector<SheetPiece> split_sheet(TriangleMesh const& mesh);

// Moves and scales a piece. The triangles of a mirrored piece are reversed.
SheetPiece placed(SheetPiece const& piece, InstanceTransform const& instance);

// Returns the unit normals of a piece's vertices: the mean of the normals of their triangles,
// weighted by area.
std::vector<Vec3f> vertex_normals(SheetPiece const& piece);

// Returns by how much a closed piece must grow on all sides to be at least about `thickness_mm`
// thick everywhere; 0 if it is.
double growth_of(SheetPiece const& piece, double thickness_mm);

// Returns the piece as a solid: a piece with a rim as a plate, at least `thickness_mm` (above 0)
// thick; a closed piece as it is, or larger if it is thinner than that.
ClosedMesh solid_of(SheetPiece const& piece, MaterialId material, double thickness_mm);

} // namespace tractus::mesh
