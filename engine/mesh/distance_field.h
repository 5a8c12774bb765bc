#pragma once

#include "engine/mesh/solid_parts.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace tractus::mesh {

// The distances of points from the shapes that make up a plant: pieces of branches, triangles of
// leaves, and closed organs. Every distance is exact, or too small near the flat base of a trunk.
class DistanceField {
public:
    explicit DistanceField(SolidParts const& parts);

    // Number of shapes.
    std::size_t size() const { return cones_.size() + plates_.size() + lumps_.size(); }

    MaterialId material(std::size_t shape) const;

    // A box around a shape.
    Eigen::AlignedBox3f box_mm(std::size_t shape) const;

    // Distance of a point from the surface of a shape, negative inside.
    float distance_mm(std::size_t shape, Vec3f const& at_mm) const;

    // True for closed organs, of which distance_mm() looks at every triangle.
    bool is_slow(std::size_t shape) const { return shape >= cones_.size() + plates_.size(); }

private:
    // Two spheres and the cone that touches both.
    struct Cone {
        Vec3f from_mm;
        Vec3f to_mm;
        float from_radius_mm;
        float to_radius_mm;
        // Outward direction of the plane through `foot_mm` that cuts the cone; zero: no plane.
        Vec3f below = Vec3f::Zero();
        Vec3f foot_mm = Vec3f::Zero();
        MaterialId material = 0;
    };
    // The points within a distance of a triangle.
    struct Plate {
        std::array<Vec3f, 3> corners_mm;
        float half_mm;
        MaterialId material;
    };
    // A closed piece, larger by `growth_mm`.
    struct Lump {
        SheetPiece piece;
        std::vector<Vec3f> face_normals;
        // Normals of the edges that begin at each corner of each triangle, and of the vertices, for
        // the side on which a point lies (Baerentzen, Aanaes 2005, "Signed distance computation
        // using the angle weighted pseudonormal").
        std::vector<std::array<Vec3f, 3>> edge_normals;
        std::vector<Vec3f> vertex_normals;
        float growth_mm = 0;
        Eigen::AlignedBox3f box_mm;
        MaterialId material = 0;
    };

    void add_tubes(Plant const& plant);
    void add_shape(SolidShape const& shape, double thickness_mm);
    static Lump lump_of(SheetPiece piece, double thickness_mm, MaterialId material);
    static float distance_of(Cone const& cone, Vec3f const& at_mm);
    static float distance_of(Lump const& lump, Vec3f const& at_mm);

    std::vector<Cone> cones_;
    std::vector<Plate> plates_;
    std::vector<Lump> lumps_;
};

} // namespace tractus::mesh
