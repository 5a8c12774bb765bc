#pragma once

#include "engine/mesh/make_mesh.h"
#include "engine/mesh/triangle_place.h"
#include "engine/mesh/tube.h"
#include "engine/mesh/wind.h"

#include <span>
#include <stop_token>
#include <vector>

namespace tractus::mesh {

// The layout of a plant's surfaces, computed before the triangles are made: how many vertices and
// indices each axis and polygon has, and where they go. A surface is divided into pieces. They can
// be made in any order and on any thread, and be written to the surface's arrays or to a buffer, so
// that a file can be written while the plant is meshed. make_mesh() makes all pieces at once.
class MeshPlan {
public:
    // Plans every axis and polygon, on all threads. `plant` and `options` must meet the conditions
    // of make_mesh(); `plant` must outlive the plan. If `stop` is requested, returns early and has
    // no surfaces.
    explicit MeshPlan(Plant const& plant, MeshOptions const& options = {},
                      std::stop_token const& stop = {});
    MeshPlan(MeshPlan const&) = delete;
    MeshPlan& operator=(MeshPlan const&) = delete;

    // A tube, a part of a tube, or a polygon.
    struct Item {
        std::uint32_t number = 0; // Index of the axis or polygon in the plant.
        TubePart part {};         // The sections of the tube; unused for polygons.
        std::uint32_t first_vertex = 0;
        std::uint64_t first_index = 0;
    };

    // The surface that make_mesh() makes for one material. Tubes come first, then polygons.
    struct Surface {
        MaterialId material = 0;
        MeshExtent extent {};
        std::vector<Item> items {};
        std::size_t tube_count = 0; // Number of items that are tubes.
        // Index in `items` of each piece's first item, followed by the number of items.
        std::vector<std::uint32_t> pieces {};

        std::size_t piece_count() const { return pieces.size() - 1; }
        // Numbers of vertices and indices of all pieces before `piece`. If `piece` is the number of
        // pieces, they are those of the whole surface.
        MeshExtent start_of(std::size_t piece) const;
        MeshExtent extent_of(std::size_t piece) const;
    };

    // The surfaces in the order of materials; none is empty.
    std::span<Surface const> surfaces() const { return surfaces_; }

    // A box around the triangles of all surfaces, computed without making them. It may be too large
    // on each side, by up to the radius of a tube.
    Bounds const& bounds_mm() const { return bounds_mm_; }

    // Makes one piece and writes it to `place`, where there must be room for extent_of(piece).
    // Indices count from the surface's first vertex if place.vertex is start_of(piece).vertices.
    void make_piece(Surface const& surface, std::size_t piece, TrianglePlace place) const;

    // Writes the wind data of the vertices of one piece. The size of `to` must be
    // extent_of(piece).vertices.
    void make_wind(Surface const& surface, std::size_t piece, WindKey const& key,
                   std::span<WindVertex> to) const;

    // A run of vertices that belong to one cross-section of an axis. Those of end caps and tips
    // belong to the first or last cross-section.
    struct Ring {
        Vec3 center_mm;
        SegmentId segment = 0;          // The segment between the previous ring and this one.
        std::uint32_t first_vertex = 0; // Index in the surface's vertices.
        std::uint32_t vertex_count = 0;
    };

    // Appends the rings of one piece in the order of their vertices. Polygons have no rings.
    void find_rings(Surface const& surface, std::size_t piece, std::vector<Ring>& rings) const;

private:
    void trace_axes(std::stop_token const& stop);
    void plan_tubes();
    void plan_polygons();

    Plant const& plant_;
    MeshOptions options_;
    double thickest_mm_ = 0;
    Bounds bounds_mm_;
    std::vector<Surface> surfaces_;

    // The stations of all spines, one list for each block of consecutive axes. The spines in
    // spines_, one for each axis, refer to them. The spine of an axis with sections that are not
    // round is empty.
    std::vector<std::vector<SpineStation>> stations_;
    std::vector<Spine> spines_;
};

// Makes all pieces of all surfaces, on all threads. Returns early if `stop` is requested; the
// result is then unusable.
std::vector<TriangleMesh> make_surfaces(MeshPlan const& plan, std::stop_token const& stop = {});

} // namespace tractus::mesh
