#pragma once

#include "engine/base/bulk_vector.h"
#include "engine/base/vectors.h"
#include "engine/plant/material.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tractus::mesh {

constexpr double kSameNode_mm = 1e-4; // Nodes closer than this are one.

// Triangles of one material. Plant frame (tubes, polygons) or organ frame (prototypes),
// millimetres. The vertex arrays have equal sizes; indices are counter-clockwise seen from outside,
// three to a triangle.
struct TriangleMesh {
    MaterialId material = 0;
    BulkVector<Vec3f> positions_mm;
    BulkVector<Vec3f> normals; // Unit length.
    // Tubes: u once around, v in the same scale along the axis. Blades: the unit square, midrib at
    // u = 0.5, base at v = 0.
    BulkVector<Vec2f> texture_coordinates;
    BulkVector<std::uint32_t> indices;

    std::size_t triangle_count() const { return indices.size() / 3; }
};

// Where one copy of a prototype stands: scaled along its own axes, then rotated, then moved.
struct InstanceTransform {
    Vec3f translation_mm = Vec3f::Zero();
    Quatf rotation = Quatf::Identity();
    Vec3f scale = Vec3f::Ones();
};

// One organ shape and all its copies in a plant.
struct InstancedMesh {
    TriangleMesh prototype;
    std::vector<InstanceTransform> instances; // Instances in the order of the plant's organs.
    std::uint16_t shape = 0;                  // Index of the plant's organ shape.
};

// A plant as triangles: what renderers and exporters take.
struct Mesh {
    std::vector<Material> materials;    // MaterialId is an index into it.
    std::vector<TriangleMesh> surfaces; // Tubes and polygons; at most one per material.
    std::vector<InstancedMesh> organs;  // One per organ shape that the plant uses.

    // Triangles as drawn: every instance counted.
    std::size_t triangle_count() const;
};

} // namespace tractus::mesh
