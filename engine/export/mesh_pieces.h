#pragma once

#include "engine/export/placed_mesh.h"
#include "engine/mesh/mesh_plan.h"

#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

namespace tractus::exports {

// A view of a part of a surface. Indices count from the surface's first vertex; the first vertex of
// this part has the index `first_vertex`.
struct TriangleView {
    std::span<Vec3f const> positions_mm;
    std::span<Vec3f const> normals;
    std::span<Vec2f const> texture_coordinates;
    std::span<std::uint32_t const> indices;
    std::uint32_t first_vertex = 0;
    // Tangents as from find_tangents(); empty if not needed.
    std::span<Eigen::Vector4f const> tangents {};
};

TriangleView view_of(mesh::TriangleMesh const& mesh, std::uint32_t first_vertex = 0);

// The triangles of one plant in pieces of up to about a megabyte. They come from a mesh in memory
// or are made on demand. Thread-safe.
class MeshPieces {
public:
    // Merged: the copies of an organ are added to the surface with the organ's material, after the
    // surface's other triangles. Apart: they are left to the caller (organs()).
    enum class Organs { Merged, Apart };
    // ForRelief: surfaces and organs have tangents if their material has a normal map.
    enum class Tangents { Never, ForRelief };
    // OneSurface: the indices of a surface continue through all its pieces, and triangles may refer
    // to vertices of other pieces. OwnMeshes: each piece is a mesh of its own, with indices from 0.
    // These pieces are four times as large, since programs draw each with a call of its own.
    enum class Cut { OneSurface, OwnMeshes };

    // If `source` holds a function, the constructor calls it to grow, mesh or draw the plant.
    // `source` must outlive this object.
    MeshPieces(MeshSource const& source, Organs organs, Tangents tangents = Tangents::Never,
               Cut cut = Cut::OneSurface);
    MeshPieces(MeshPieces const&) = delete;
    MeshPieces& operator=(MeshPieces const&) = delete;

    struct Surface {
        MaterialId material = 0;
        mesh::MeshExtent extent {};
        std::size_t piece_count = 0;
    };
    std::span<Surface const> surfaces() const { return surfaces_; }
    std::span<mesh::InstancedMesh const> organs() const; // Empty if organs are merged.
    Material const& material(MaterialId id) const;
    // Number of all triangles, including those of every instance.
    std::uint64_t triangle_count() const;
    // wind() replaces `buffer` by the wind data of a piece's vertices, or empties it if
    // !has_wind().
    bool has_wind() const { return wind_.has_value(); }
    void wind(std::size_t surface, std::size_t piece, std::vector<mesh::WindVertex>& buffer) const;
    // Returns the wind data of the instances of organs()[organ]; empty if !has_wind().
    std::span<mesh::WindVertex const> organ_wind(std::size_t organ) const;

    // PNG picture for all surfaces of a billboard; empty if the source is not a billboard.
    std::string const& picture_png() const { return picture_png_; }
    // Returns a box around all surfaces, computed without making their triangles.
    Bounds bounds_mm() const;

    // True if surfaces and organs with this material have tangents.
    bool has_tangents(MaterialId material) const;

    // Reusable memory for the data of one piece.
    struct Buffer {
        mesh::TriangleMesh triangles {};
        BulkVector<Eigen::Vector4f> tangents {};
    };

    // Returns one piece of a surface; its triangles may be stored in `buffer`. The pieces of a
    // surface follow each other without gaps. With Cut::OwnMeshes they may have more vertices in
    // total than the surface, since they do not share vertices.
    TriangleView piece(std::size_t surface, std::size_t piece, Buffer& buffer) const;

private:
    // A run of consecutive pieces of a surface, all from the same surface of the source or from the
    // same organ.
    struct Run {
        enum class Of { Surface, Organ } of = Of::Surface;
        std::size_t index = 0; // Index of the surface in plan_ or mesh_, or of the organ.
        std::size_t first_piece = 0;
        std::size_t piece_count = 0;
        mesh::MeshExtent start {}; // Numbers of vertices and indices before the run in its surface.
    };

    void use_mesh(mesh::Mesh const& mesh);
    void use_plant(Plant const& plant, PlantToMesh const& source);
    void add_surface(MaterialId material, mesh::MeshExtent const& extent, std::size_t piece_count);
    void merge_organs();
    std::span<Eigen::Vector4f const> tangents_of_mesh(std::size_t surface) const;
    std::span<mesh::InstancedMesh const> all_organs() const
    {
        return mesh_ ? mesh_->organs : organs_;
    }
    Run const& run_of(std::size_t surface, std::size_t piece) const;
    TriangleView triangles_of(Run const& run, std::size_t piece, Buffer& buffer) const;
    // Returns the number of the first piece of plan_'s surface that belongs to `piece`. If `piece`
    // is past the last one, returns `planned_pieces`, the number of all pieces of plan_'s surface.
    std::size_t planned_piece(std::size_t piece, std::size_t planned_pieces) const;
    std::size_t piece_vertices() const;
    TriangleView mesh_piece(Run const& run, std::size_t piece) const;
    TriangleView own_mesh_piece(Run const& run, std::size_t piece, Buffer& buffer) const;
    TriangleView plan_piece(Run const& run, std::size_t piece, mesh::TriangleMesh& buffer) const;
    TriangleView organ_piece(Run const& run, std::size_t piece, mesh::TriangleMesh& buffer) const;
    void organ_piece_wind(Run const& run, std::size_t piece,
                          std::vector<mesh::WindVertex>& buffer) const;

    std::optional<mesh::Mesh> made_;
    std::string picture_png_;
    std::optional<Plant> grown_;
    // Either mesh_ is set, or plant_ with plan_ and organs_.
    mesh::Mesh const* mesh_ = nullptr;
    Plant const* plant_ = nullptr;
    std::optional<mesh::MeshPlan> plan_;
    std::vector<mesh::InstancedMesh> organs_;
    std::optional<mesh::WindKey> wind_;
    // Wind data of each copy of each organ shape.
    std::vector<std::vector<mesh::WindVertex>> organ_wind_;
    std::vector<Surface> surfaces_;
    std::vector<std::vector<Run>> runs_; // Runs of each surface, in order.
    mutable std::once_flag mesh_tangents_found_;
    // Tangents of each surface of mesh_; empty for surfaces without a normal map.
    mutable std::vector<BulkVector<Eigen::Vector4f>> mesh_tangents_;
    bool is_merged_ = false;
    bool has_own_meshes_ = false;
    bool has_tangents_ = false;
};

} // namespace tractus::exports
