#pragma once

#include "engine/mesh/make_mesh.h"
#include "engine/mesh/mesh_plan.h"

#include <cstdint>
#include <span>
#include <vector>

namespace tractus::mesh {

// A mesh with the same triangles at every age of a plant, so that one shape morphs into the next
// vertex by vertex (morph targets).
//
// In an ordinary mesh the number of rings of a tube depends on its bends, and so on the age. Here
// the plant has the rings of the full-grown plant at every age. A ring stays at the same share of
// its segment's length, is rotated with the segment without twist, and has the radius of the branch
// at that age. Parts that have not grown yet are collapsed into the point where they will sprout.
class AgedMesh {
public:
    // `whole` is the full-grown plant and must outlive this object. `whole` and `options` must meet
    // the conditions of make_mesh().
    explicit AgedMesh(Plant const& whole, MeshOptions const& options = {});

    // The mesh of the full-grown plant. Its organs are part of the surfaces; none are instanced.
    Mesh const& whole() const { return whole_; }

    // The vertices of one surface at a given age.
    struct Vertices {
        BulkVector<Vec3f> positions_mm;
        BulkVector<Vec3f> normals; // Unit length.
    };

    // Computes the vertices of each surface of whole() for `young`, the same plant at another age
    // with the same topology (Grower::grow()). If `young` is the full-grown plant itself, the
    // vertices equal those of whole(). The normals of tubes rotate with their segments but ignore
    // the taper of a young tip. Runs on all threads; the result does not depend on their number.
    void at(Plant const& young, std::vector<Vertices>& surfaces) const;

private:
    // A polygon or organ: its index in the plant and its first vertex in the surface.
    struct AttachedPart {
        std::uint32_t number = 0;
        std::uint32_t first_vertex = 0;
    };
    struct Parts {
        std::vector<MeshPlan::Ring> rings {};
        std::vector<AttachedPart> polygons {};
        std::vector<AttachedPart> organs {};
    };
    struct Carrier;

    void find_parts(MeshPlan const& plan);
    void add_organs(MeshOptions const& options);
    std::size_t surface_of(MaterialId material);
    std::vector<Carrier> carriers(Plant const& young) const;
    void move_rings(std::size_t surface, std::span<Carrier const> carriers, Vertices& to) const;
    void move_polygons(std::size_t surface, Plant const& young, std::span<Carrier const> carriers,
                       Vertices& to) const;
    void move_organs(std::size_t surface, Plant const& young, Vertices& to) const;

    Plant const& plant_;
    Mesh whole_;
    std::vector<TriangleMesh> prototypes_; // Mesh of each organ shape; empty for unused shapes.
    std::vector<Parts> parts_;             // Rings, polygons and organs of each surface of whole_.
};

} // namespace tractus::mesh
