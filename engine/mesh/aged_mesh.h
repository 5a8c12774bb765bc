#pragma once

#include "engine/mesh/make_mesh.h"
#include "engine/mesh/mesh_plan.h"

#include <cstdint>
#include <span>
#include <vector>

namespace tractus::mesh {

// The triangles of a plant that are the same at all of its ages, so that one shape flows into the
// next vertex by vertex, as morph targets do.
//
// How many rings a tube has depends on its bends, and so on the age. Here all ages have those of
// the whole plant, and each ring goes where its place on its segment goes: turned, but not twisted,
// as the segment has turned, as far from its base as that has grown, and as wide as the branch is
// there by then. What has not grown yet lies in one point, where it will sprout.
class AgedMesh {
public:
    // `whole`, at its full size, must outlive this; it and `options` as for make_mesh().
    explicit AgedMesh(Plant const& whole, MeshOptions const& options = {});

    // The whole plant. Organs are triangles of the surfaces as tubes are: none is instanced.
    Mesh const& whole() const { return whole_; }

    // The vertices of one surface at some age.
    struct Vertices {
        BulkVector<Vec3f> positions_mm;
        BulkVector<Vec3f> normals; // Unit length.
    };

    // Where the vertices of each surface of whole() are when the plant is `young`: the same plant
    // at another age, of the same topology (Grower::grow()). For the whole plant they are those of
    // whole(). Of tubes the normals turn with the segments, but do not follow the taper of a young
    // tip. Runs on all threads; the result is the same for any number of them.
    void at(Plant const& young, std::vector<Vertices>& surfaces) const;

private:
    // A polygon or an organ: its number in the plant, and where it has its vertices.
    struct Rider {
        std::uint32_t number = 0;
        std::uint32_t first_vertex = 0;
    };
    struct Parts {
        std::vector<MeshPlan::Ring> rings {};
        std::vector<Rider> polygons {};
        std::vector<Rider> organs {};
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
    std::vector<TriangleMesh> prototypes_; // Per organ shape; empty where it is not used.
    std::vector<Parts> parts_;             // Per surface of whole_.
};

} // namespace tractus::mesh
