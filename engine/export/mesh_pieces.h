#pragma once

#include "engine/export/placed_mesh.h"
#include "engine/mesh/mesh_plan.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace tractus {

// A part of a surface, wherever its triangles are. Indices count from the surface's first vertex.
struct TriangleView {
    std::span<Vec3f const> positions_mm;
    std::span<Vec3f const> normals;
    std::span<Vec2f const> texture_coordinates;
    std::span<std::uint32_t const> indices;
};

TriangleView view_of(TriangleMesh const& mesh);

// The triangles of one plant in pieces of at most about a megabyte, whether they are in memory or
// are made as they are asked for. Pieces may be asked for on any threads.
class MeshPieces {
public:
    // Grows, meshes or draws what `source` gives as a function; `source` must outlive this.
    explicit MeshPieces(MeshSource const& source);
    MeshPieces(MeshPieces const&) = delete;
    MeshPieces& operator=(MeshPieces const&) = delete;

    struct Surface {
        MaterialId material = 0;
        MeshExtent extent {};
        std::size_t piece_count = 0;
    };
    std::span<Surface const> surfaces() const { return surfaces_; }
    std::span<InstancedMesh const> organs() const;
    Material const& material(MaterialId id) const;
    std::uint64_t triangle_count() const; // As drawn: every instance counted.
    // What a piece's vertices need for the wind, into `buffer`; nothing for what has no wind.
    bool has_wind() const { return wind_.has_value(); }
    void wind(std::size_t surface, std::size_t piece, std::vector<WindVertex>& buffer) const;
    // The same for the instances of an organ.
    std::span<WindVertex const> organ_wind(std::size_t organ) const;

    // A billboard's picture, in PNG, on all of its surfaces; empty for what is none.
    std::string const& picture_png() const { return picture_png_; }
    Bounds bounds_mm() const; // A box around all surfaces. Reads a mesh through.

    // One piece; pieces follow each other without a gap. `buffer` holds what has to be made.
    TriangleView piece(std::size_t surface, std::size_t piece, TriangleMesh& buffer) const;

private:
    void use_mesh(Mesh const& mesh);
    void use_plant(Plant const& plant, PlantToMesh const& source);

    std::optional<Mesh> made_;
    std::string picture_png_;
    std::optional<Plant> grown_;
    Mesh const* mesh_ = nullptr;   // Either this one or
    Plant const* plant_ = nullptr; // this one, with its plan and organs.
    std::optional<MeshPlan> plan_;
    std::vector<InstancedMesh> organs_;
    std::optional<WindKey> wind_;
    std::vector<std::vector<WindVertex>> organ_wind_; // Per organ shape of the plant.
    std::vector<Surface> surfaces_;
};

} // namespace tractus
