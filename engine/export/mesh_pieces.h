#pragma once

#include "engine/export/placed_mesh.h"
#include "engine/mesh/mesh_plan.h"

#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

namespace tractus::exports {

// A part of a surface, wherever its triangles are. Indices count from the surface's first vertex;
// to the first vertex here they give the number `first_vertex`.
struct TriangleView {
    std::span<Vec3f const> positions_mm;
    std::span<Vec3f const> normals;
    std::span<Vec2f const> texture_coordinates;
    std::span<std::uint32_t const> indices;
    std::uint32_t first_vertex = 0;
    std::span<Eigen::Vector4f const>
        tangents {}; // From find_tangents(); empty for what needs none.
};

TriangleView view_of(mesh::TriangleMesh const& mesh, std::uint32_t first_vertex = 0);

// The triangles of one plant in pieces of about a megabyte, whether they are in memory or
// are made as they are asked for. Pieces may be asked for on any threads.
class MeshPieces {
public:
    // Whether the copies of an organ are triangles of the surface that has their material, after
    // what else is in it, or are left to the caller.
    enum class Organs { Merged, Apart };
    // Whether surfaces with a normal map have tangents.
    enum class Tangents { Never, ForRelief };
    // Whether the indices of a surface go through all of its pieces, and a piece may lack vertices
    // of its triangles; or each piece has its own, from 0 on, and is a mesh by itself. Those are
    // four times as large: a program draws each at once.
    enum class Cut { OneSurface, OwnMeshes };

    // Grows, meshes or draws what `source` gives as a function; `source` must outlive this.
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
    std::span<mesh::InstancedMesh const> organs() const; // Empty if they are merged.
    Material const& material(MaterialId id) const;
    std::uint64_t triangle_count() const; // Triangles as drawn: every instance counted.
    // Writes what a piece's vertices need for the wind into `buffer`; nothing if it has no wind.
    bool has_wind() const { return wind_.has_value(); }
    void wind(std::size_t surface, std::size_t piece, std::vector<mesh::WindVertex>& buffer) const;
    // Returns the same for the instances of an organ.
    std::span<mesh::WindVertex const> organ_wind(std::size_t organ) const;

    // A billboard's picture, in PNG, on all of its surfaces; empty for what is none.
    std::string const& picture_png() const { return picture_png_; }
    // A box around all surfaces, found without making what is not there yet.
    Bounds bounds_mm() const;

    // Whether surfaces and organs with this material have tangents.
    bool has_tangents(MaterialId material) const;

    // Memory for what has to be made of a piece; kept from piece to piece, so that it is allocated
    // once.
    struct Buffer {
        mesh::TriangleMesh triangles {};
        BulkVector<Eigen::Vector4f> tangents {};
    };

    // One piece; pieces of one surface follow each other without a gap. The extents of meshes of
    // their own may be more than their surface's, as they do not share vertices.
    TriangleView piece(std::size_t surface, std::size_t piece, Buffer& buffer) const;

private:
    // Pieces of a surface that follow each other and have one origin.
    struct Run {
        enum class Of { Surface, Organ } of = Of::Surface;
        std::size_t index = 0; // Index of the plan's or mesh's surface, or of the organ.
        std::size_t first_piece = 0;
        std::size_t piece_count = 0;
        mesh::MeshExtent start {}; // Extent of what lies before it in the surface.
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
    // The first of a plan's pieces that are one piece here; and the end of the last.
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
    mesh::Mesh const* mesh_ = nullptr; // Either this one or
    Plant const* plant_ = nullptr;     // this one, with its plan and organs.
    std::optional<mesh::MeshPlan> plan_;
    std::vector<mesh::InstancedMesh> organs_;
    std::optional<mesh::WindKey> wind_;
    std::vector<std::vector<mesh::WindVertex>> organ_wind_; // Per organ shape of the plant.
    std::vector<Surface> surfaces_;
    std::vector<std::vector<Run>> runs_; // Per surface, in order.
    mutable std::once_flag mesh_tangents_found_;
    // Per surface of mesh_; empty for most.
    mutable std::vector<BulkVector<Eigen::Vector4f>> mesh_tangents_;
    bool is_merged_ = false;
    bool has_own_meshes_ = false;
    bool has_tangents_ = false;
};

} // namespace tractus::exports
