#pragma once

#include "engine/base/bulk_vector.h"
#include "engine/base/vectors.h"
#include "engine/plant/material.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tractus::mesh {

constexpr double kSameNode_mm = 1e-4; // Nodes of an axis closer together than this are merged.

// Triangles of one material. Their frame is the plant's (tubes, polygons) or the organ's
// (prototypes). The vertex arrays have equal sizes. There are three indices per triangle,
// counter-clockwise as seen from outside.
struct TriangleMesh {
    MaterialId material = 0;
    BulkVector<Vec3f> positions_mm;
    BulkVector<Vec3f> normals; // Unit length.
    // Tubes: u runs once around, v along the axis at the same scale. Blades: the unit square, with
    // the midrib at u = 0.5 and the base at v = 0.
    BulkVector<Vec2f> texture_coordinates;
    BulkVector<std::uint32_t> indices;

    std::size_t triangle_count() const { return indices.size() / 3; }
};

// Transform of one copy of a prototype: scaled along the prototype's axes, then rotated, then
// translated.
struct InstanceTransform {
    Vec3f translation_mm = Vec3f::Zero();
    Quatf rotation = Quatf::Identity();
    Vec3f scale = Vec3f::Ones();
};

// The mesh of one organ shape and the transforms of all its copies in a plant.
struct InstancedMesh {
    TriangleMesh prototype;
    std::vector<InstanceTransform> instances; // One per copy, in the order of the plant's organs.
    std::uint16_t shape = 0; // Index of the shape in the plant's list of organ shapes.
};

// A plant as triangles: the input of renderers and exporters.
struct Mesh {
    std::vector<Material> materials;    // All materials, indexed by MaterialId.
    std::vector<TriangleMesh> surfaces; // Tubes and polygons; at most one surface per material.
    std::vector<InstancedMesh> organs;  // One entry per organ shape that the plant uses.

    // Number of triangles of the surfaces and of all instances of the organs.
    std::size_t triangle_count() const;
};

} // namespace tractus::mesh
