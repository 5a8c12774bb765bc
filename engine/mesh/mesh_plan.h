#pragma once

#include "engine/mesh/make_mesh.h"
#include "engine/mesh/triangle_place.h"
#include "engine/mesh/tube.h"
#include "engine/mesh/wind.h"

#include <span>
#include <stop_token>
#include <vector>

namespace tractus::mesh {

// The triangles of a plant's surfaces before they are made: how many there are, and where each axis
// and each polygon has its own. A surface is cut into pieces that are made in any order, on any
// thread, into the surface's arrays or into a buffer: so a file can be written while it is meshed.
// make_mesh() is all pieces at once.
class MeshPlan {
public:
    // Looks at every axis and polygon, on all threads. `plant` and `options` as for make_mesh();
    // the plant must outlive the plan. Ends early when `stop` asks for it; then there are no
    // surfaces.
    explicit MeshPlan(Plant const& plant, MeshOptions const& options = {},
                      std::stop_token const& stop = {});
    MeshPlan(MeshPlan const&) = delete;
    MeshPlan& operator=(MeshPlan const&) = delete;

    // A tube, a part of one, or a polygon.
    struct Item {
        std::uint32_t number = 0; // Number of the axis or the polygon.
        TubePart part {};         // Tubes only.
        std::uint32_t first_vertex = 0;
        std::uint64_t first_index = 0;
    };

    // Surface that make_mesh() makes of one material. Tubes come first, then polygons.
    struct Surface {
        MaterialId material = 0;
        MeshExtent extent {};
        std::vector<Item> items {};
        std::size_t tube_count = 0;           // How many of the items are tubes.
        std::vector<std::uint32_t> pieces {}; // The first item of each piece, and the end of all.

        std::size_t piece_count() const { return pieces.size() - 1; }
        // Extent of what lies before a piece; for the number of pieces, the whole extent.
        MeshExtent start_of(std::size_t piece) const;
        MeshExtent extent_of(std::size_t piece) const;
    };

    // Surfaces in the order of materials; none is empty.
    std::span<Surface const> surfaces() const { return surfaces_; }

    // A box around all triangles, found without making them: up to a radius larger than it has to
    // be.
    Bounds const& bounds_mm() const { return bounds_mm_; }

    // Makes one piece: `place` is where it begins, and has room for the piece's extent. Indices
    // count from the surface's first vertex if place.vertex is start_of(piece).vertices.
    void make_piece(Surface const& surface, std::size_t piece, TrianglePlace place) const;

    // Writes what the vertices of one piece need for the wind: `to` has as many as the piece's
    // extent.
    void make_wind(Surface const& surface, std::size_t piece, WindKey const& key,
                   std::span<WindVertex> to) const;

    // A run of vertices of one cross-section of an axis, filled ends and tips included.
    struct Ring {
        Vec3 center_mm;
        SegmentId segment = 0;          // Segment that the stretch up to here belongs to.
        std::uint32_t first_vertex = 0; // Index in the surface.
        std::uint32_t vertex_count = 0;
    };

    // Appends the rings of one piece, in the order of their vertices. Polygons have none.
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

    // Traced once: the stations of consecutive axes together, and of each axis its spine, which has
    // none where its sections are not round.
    std::vector<std::vector<SpineStation>> stations_;
    std::vector<Spine> spines_;
};

// Makes all pieces of all surfaces at once, on all threads. `stop` as for make_mesh().
std::vector<TriangleMesh> make_surfaces(MeshPlan const& plan, std::stop_token const& stop = {});

} // namespace tractus::mesh
