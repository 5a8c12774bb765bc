#pragma once

#include "engine/export/placed_mesh.h"
#include "engine/mesh/mesh_plan.h"

#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

namespace tractus::exports {

// A part of a surface, whose memory belongs to others. Indices count from the surface's first
// vertex; the first vertex of this part has the index `first_vertex`.
struct TriangleView {
    std::span<Vec3f const> positions_mm;
    std::span<Vec3f const> normals;
    std::span<Vec2f const> texture_coordinates;
    std::span<std::uint32_t const> indices;
    std::uint32_t first_vertex = 0;
    std::span<Eigen::Vector4f const> tangents {}; // As from find_tangents(); empty if not needed.
};

TriangleView view_of(mesh::TriangleMesh const& mesh, std::uint32_t first_vertex = 0);

// The triangles of one plant in pieces of about a megabyte, either from memory or made on demand.
// Thread-safe.
class MeshPieces {
public:
    // Whether the copies of an organ are merged into the surface with their material, after its
    // other triangles, or left to the caller.
    enum class Organs { Merged, Apart };
    // Whether surfaces with a normal map have tangents.
    enum class Tangents { Never, ForRelief };
    // OneSurface: the indices of a surface continue through all pieces, and triangles may refer to
    // vertices of other pieces. OwnMeshes: each piece is a mesh of its own, with indices from 0.
    // Such pieces are four times as large, since a program draws each with one call.
    enum class Cut { OneSurface, OwnMeshes };

    // If `source` is a function, calls it to grow, mesh or draw the plant. `source` must outlive
    // this object.
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
    std::uint64_t triangle_count() const; // Number of triangles, with those of every instance.
    // wind() writes the wind data of a piece's vertices into `buffer`: nothing if !has_wind().
    bool has_wind() const { return wind_.has_value(); }
    void wind(std::size_t surface, std::size_t piece, std::vector<mesh::WindVertex>& buffer) const;
    // Returns the wind data of an organ's instances.
    std::span<mesh::WindVertex const> organ_wind(std::size_t organ) const;

    // Picture of a billboard in PNG, for all of its surfaces; empty if the source is no billboard.
    std::string const& picture_png() const { return picture_png_; }
    // Box around all surfaces, computed without making their triangles.
    Bounds bounds_mm() const;

    // True if surfaces and organs with this material have tangents.
    bool has_tangents(MaterialId material) const;

    // Reusable memory for the data of one piece.
    struct Buffer {
        mesh::TriangleMesh triangles {};
        BulkVector<Eigen::Vector4f> tangents {};
    };

    // Returns one piece. The pieces of a surface are consecutive, without gaps. With Cut::OwnMeshes
    // their total extent may exceed that of the surface, as they do not share vertices.
    TriangleView piece(std::size_t surface, std::size_t piece, Buffer& buffer) const;

private:
    // Consecutive pieces of a surface that come from one surface of the source or from one organ.
    struct Run {
        enum class Of { Surface, Organ } of = Of::Surface;
        std::size_t index = 0; // Index of that surface in the plan or mesh, or of the organ.
        std::size_t first_piece = 0;
        std::size_t piece_count = 0;
        mesh::MeshExtent start {}; // Extent of everything before the run in the surface.
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
    // Index of the first piece of plan_ that belongs to `piece`, or `planned_pieces`, the number of
    // plan_'s pieces, if `piece` is past the last one.
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
    std::vector<std::vector<mesh::WindVertex>> organ_wind_; // Wind data, by organ shape and copy.
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
