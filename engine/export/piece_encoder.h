#pragma once

#include "engine/base/bulk_vector.h"
#include "engine/export/mesh_pieces.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tractus::exports {

// glTF's name for a kind of number (glTF 2.0 section 3.6.2.2).
enum class ComponentType {
    Byte = 5120,
    UnsignedByte = 5121,
    Short = 5122,
    UnsignedShort = 5123,
    UnsignedInt = 5125,
    Float = 5126
};

// How EXT_meshopt_compression compresses numbers, where it does: by its mode ATTRIBUTES, without a
// filter or with one, or by its mode INDICES.
enum class Codec { Attributes, Octahedral, Exponential, Indices };

// Format of an accessor's numbers.
struct NumberFormat {
    ComponentType type = ComponentType::Float;
    int components = 3;
    bool normalized = false;
    int element_bytes = 12; // A multiple of four but for indices.
    Codec codec = Codec::Attributes;
};

// How the vertices of a surface are written.
struct SurfaceFormat {
    // 16-bit positions and 8-bit normals, as KHR_mesh_quantization allows.
    bool quantized = false;
    // Normals, tangents and texture coordinates are what filters of EXT_meshopt_compression undo;
    // quantised ones only.
    bool filtered = false;
    // Metres, glTF's frame: a quantised position is origin_m + step_m * the number, the same for
    // all three components, so that normals stay what they are.
    Vec3 origin_m = Vec3::Zero();
    double step_m = 1;
    bool short_indices = false; // Indices have 16 bits.
    bool tangents = false;      // There are tangents, for a normal map.

    NumberFormat positions() const;
    NumberFormat normals() const;
    NumberFormat tangent_vectors() const;
    NumberFormat texture_coordinates() const;
    NumberFormat indices() const;
};

// Quantisation for what lies in a box. A box that is empty or not finite gives some that works.
SurfaceFormat quantized_format(Bounds const& bounds_mm);

constexpr std::size_t kMostStreams = 10;

// A part of a file, ready to be written: each stream continues a block of its own.
struct EncodedPiece {
    std::array<std::span<std::byte const>, kMostStreams> streams {};
    bool is_finite = true;
    // Vertices and indices of triangles; instances are vertices.
    mesh::MeshExtent extent {};
    // Limits of the positions, as they are written; low above high if there are none.
    Vec3f low = Vec3f::Constant(std::numeric_limits<float>::infinity());
    Vec3f high = -low;

    // Memory that the streams lie in, if it is not the mesh itself.
    std::array<BulkVector<std::byte>, kMostStreams> storage {};
    std::array<BulkVector<std::byte>, kMostStreams> compressed {};
};

// Streams: positions, normals, texture coordinates, indices, tangents. `triangles` must outlive
// what is encoded, and `piece` may have been used before.
void encode_triangles(TriangleView const& triangles, SurfaceFormat const& format,
                      EncodedPiece& piece);

// How the places of organs are written: translations, rotations, scales.
struct InstanceFormat {
    bool quantized = false; // 16-bit rotations, as EXT_mesh_gpu_instancing allows.

    static NumberFormat translations();
    NumberFormat rotations() const;
    static NumberFormat scales();
};

// Streams: translations, rotations, scales.
void encode_instances(std::span<mesh::InstanceTransform const> instances,
                      InstanceFormat const& format, EncodedPiece& piece);

} // namespace tractus::exports
